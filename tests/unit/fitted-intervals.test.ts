/** Where fitted motions show shapes of their own method. */
import { describe, expect, it } from 'vitest';
import type { Motion } from '../../web/engine/api/api.ts';
import { fittedText } from '../../web/model/method-words.ts';
import { fittedCount, isOwnAt } from '../../web/study/fitted-intervals.ts';

const motion = (method: string, fitted: boolean[] | null): Motion =>
  ({ keyTimes: [0, 1, 2, 4], fitted, options: { method } }) as unknown as Motion;

describe('a motion shows its own method', () => {
  it.each([
    ['lengths', [true, false, true], [-1, 0, 0.5, 1, 1.5, 2, 3, 4, 5], '111000111'],
    ['shell', [false, false, true], [-1, 0, 2, 2.1], '0001'],
    ['lengths', [true, true, true], [-1, 1, 5], '111'],
    ['lri', [false, false, true], [-1, 0.5], '11'],
    ['linear', null, [-1, 0.5], '11'],
  ])('%s, fitted %j, at %j: %s', (method, fitted, times, own) => {
    expect(times.map((t) => (isOwnAt(motion(method, fitted), t) ? '1' : '0')).join('')).toBe(own);
  });

  it('in a number of intervals, which the page says beside its name unless it is all', () => {
    expect([null, [true, false, false], [true, true]].map((fitted) => fittedCount({ fitted }))).toEqual([null, 1, 2]);
    expect([null, [true, false, false], [true, true]].map(fittedText)).toEqual(['', 'fitted in 1 of 3 intervals', '']);
  });
});
