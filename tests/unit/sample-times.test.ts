import { describe, expect, it } from 'vitest';
import { evenTimes, readTimes } from '../../web/model/sample-times.ts';

const span = { start: 0.5, end: 2 };

describe('times of keys from an animation', () => {
  it('are evenly spaced from its start to its end', () => {
    expect(evenTimes(span, 4)).toEqual([0.5, 1, 1.5, 2]);
  });

  it('are read from a list, and clamped', () => {
    expect(readTimes('0.5, 1;2.00005', span)).toEqual([0.5, 1, 2]);
  });

  it('are refused with a message', () => {
    expect(readTimes('1, x', span)).toContain('Time 2');
    expect(readTimes('1, 2.1', span)).toBe('2.1 s is outside the animation, which runs from 0.5 to 2 s.');
    expect(readTimes('1, 1', span)).toContain('two times');
  });
});
