import { describe, expect, it } from 'vitest';
import { NO_PLACE, type Warning } from '../../../web/engine/api/types.ts';
import { keysOf } from '../../../web/engine/api/warning-keys.ts';

const warning = (code: string, key: number): Warning => ({
  ...NO_PLACE,
  code,
  message: 'A large rotation.',
  count: 0,
  key,
});

describe('the keys that a warning is about', () => {
  it('are the ends of the interval before its key', () => {
    expect(keysOf(warning('ambiguous-turn', 2), 4)).toEqual([1, 2]);
  });

  it('of a closed motion are the last and the first in the closing interval', () => {
    for (const key of [0, 4]) expect(keysOf(warning('ambiguous-component-turn', key), 4)).toEqual([3, 0]);
  });

  it('are one key for a warning about a pose', () => {
    expect(keysOf(warning('mirrored', 2), 4)).toEqual([2, 2]);
  });

  it('are none without a location', () => {
    expect(keysOf(warning('winding', -1), 4)).toBeNull();
  });
});
