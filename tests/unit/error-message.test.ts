import { describe, expect, it } from 'vitest';
import { errorMessageOf } from '../../web/app/view/error-message.ts';
import { EngineError } from '../../web/engine/api/errors.ts';

describe('the message for a failure', () => {
  it('is its own message, with code and location as details', () => {
    const error = new EngineError('vertex-count-mismatch', 'b.obj (key 2) has 3 vertices.', { file: 'b.obj', key: 1 });
    expect(errorMessageOf(error)).toEqual({
      message: 'b.obj (key 2) has 3 vertices.',
      details: 'code vertex-count-mismatch, file b.obj, key 1, counted from 0',
    });
    expect(errorMessageOf(new EngineError('missing-file', 'No.', { file: 'c.obj' })).details).toBe(
      'code missing-file, file c.obj',
    );
    expect(errorMessageOf(new TypeError('x is not a function')).details).toBe('TypeError');
  });

  it('suggests a retry for unknown failures', () => {
    expect(errorMessageOf('boom')).toEqual({
      message: 'Something went wrong. The shape on the screen is still usable.',
      details: 'boom',
    });
  });
});
