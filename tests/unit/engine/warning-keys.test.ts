import { describe, expect, it } from 'vitest';
import { NO_PLACE, type Warning } from '../../../web/engine/api/types.ts';
import { keysInWords, keysOf } from '../../../web/engine/api/warning-keys.ts';

const warning = (code: string, key: number, message = 'Something turns far.'): Warning => ({
  ...NO_PLACE,
  code,
  message,
  count: 0,
  key,
});

describe('the keys that a warning is about', () => {
  it('are those that bound the interval before its key', () => {
    expect(keysOf(warning('ambiguous-turn', 2), 4)).toEqual([1, 2]);
    expect(keysInWords(warning('ambiguous-turn', 2), 4)).toBe('Key 2 to key 3');
  });

  it('of a closed motion are the last and the first where it closes', () => {
    for (const key of [0, 4]) expect(keysOf(warning('ambiguous-part-turn', key), 4)).toEqual([3, 0]);
    expect(keysInWords(warning('ambiguous-part-turn', 0), 4)).toBe('Key 4 to key 1');
  });

  it('are one key for what is about a pose', () => {
    expect(keysOf(warning('mirrored', 2), 4)).toEqual([2, 2]);
    expect(keysInWords(warning('mirrored', 0), 4)).toBe('Key 1');
  });

  it('are none without a place, and not said twice', () => {
    expect(keysOf(warning('winding', -1), 4)).toBeNull();
    expect(keysInWords(warning('winding', -1), 4)).toBe('');
    expect(keysInWords(warning('ambiguous-turn', 2, 'Between keys 2 and 3 it turns far.'), 4)).toBe('');
    expect(keysInWords(warning('mirrored', 2, 'Key 3 is mirrored.'), 4)).toBe('');
  });
});
