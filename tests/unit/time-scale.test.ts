import { describe, expect, it } from 'vitest';
import {
  clampKeyTime,
  clampTime,
  formatTime,
  neighbourKey,
  phaseOf,
  snap,
  timeScale,
  wrap,
} from '../../web/model/time-scale.ts';

const range = [2, 4] as const;
const keys = [
  { time: 2, name: 'bent' },
  { time: 3.5, name: 'straight' },
  { time: 4, name: 'left' },
];

describe('the slider', () => {
  it('shows most of a mean interval beyond both ends, for any number of keys', () => {
    expect(timeScale(range, 3).whole).toEqual([1.2, 4.8]);
    expect(timeScale(range, 2).whole.map((t) => Number(t.toFixed(9)))).toEqual([0.4, 5.6]);
    const [low, high] = timeScale([0, 10], 11).whole;
    expect([low, high]).toEqual([-0.8, 10.8]);
  });

  it('allows times up to twice the length of the motion beyond its ends', () => {
    expect(clampTime(-9, range)).toBe(-2);
    expect(clampTime(9, range)).toBe(8);
    expect(clampTime(5.5, range)).toBe(5.5);
  });

  it('snaps only to the nearest key within reach', () => {
    expect(snap(3.45, [2, 3.5, 4], 0.1)).toBe(3.5);
    expect(snap(3.3, [2, 3.5, 4], 0.1)).toBe(3.3);
  });

  it('jumps from key to key and stays if there is none', () => {
    const times = [2, 3.5, 4];
    expect(neighbourKey(2, times, 1, range)).toBe(3.5);
    expect(neighbourKey(3.6, times, -1, range)).toBe(3.5);
    expect(neighbourKey(4, times, 1, range)).toBe(4);
    expect(neighbourKey(1.5, times, 1, range)).toBe(2);
  });

  it('keeps a dragged key between its neighbours and leaves the ends free', () => {
    const times = [0, 1, 2];
    expect(clampKeyTime(times, 1, 5)).toBeLessThan(2);
    expect(clampKeyTime(times, 1, -5)).toBeGreaterThan(0);
    expect(clampKeyTime(times, 2, 9)).toBe(9);
    expect(clampKeyTime(times, 0, -9)).toBe(-9);
  });
});

describe('the phase', () => {
  const at = (t: number, periodic = false, tolerance?: number): ReturnType<typeof phaseOf> =>
    phaseOf({ t, keys, range, periodic, tolerance });

  it('is a key only at exactly its time', () => {
    expect(at(3.5)).toMatchObject({ kind: 'key', text: 'At key 2, straight' });
    expect(at(3.501).kind).toBe('between');
    expect(at(3.501, false, 0.01).kind).toBe('key');
  });

  it('names the neighbouring keys', () => {
    expect(at(3).text).toBe('Between keys 1 and 2');
    expect(at(3.9).text).toBe('Between keys 2 and 3');
  });

  it('states on which side it is extrapolated', () => {
    expect(at(1.9)).toMatchObject({ kind: 'beyond', text: 'Before the first key (extrapolated)' });
    expect(at(4.1)).toMatchObject({ kind: 'beyond', text: 'Beyond the last key (extrapolated)' });
  });

  it('repeats a closed motion instead of extrapolating it', () => {
    expect(at(4.7, true).text).toBe('Between keys 1 and 2');
    expect(at(1.5, true)).toMatchObject({ kind: 'key', text: 'At key 2, straight' });
  });

  it('includes the interval of a closed motion from the last key to the first', () => {
    const phase = phaseOf({ t: 4.5, keys, range: [2, 5], periodic: true });
    expect(phase.text).toBe('Between keys 3 and 1');
  });
});

describe('wrap', () => {
  it('does not change times in the range, including its end', () => {
    expect(wrap(4, range)).toBe(4);
    expect(wrap(2, range)).toBe(2);
  });

  it('moves other times by whole periods', () => {
    expect(wrap(4.5, range)).toBeCloseTo(2.5, 12);
    expect(wrap(1.5, range)).toBeCloseTo(3.5, 12);
    expect(wrap(-10.5, range)).toBeCloseTo(3.5, 12);
  });
});

describe('formatTime', () => {
  it('has meaningful decimals only', () => {
    expect(formatTime(0.42)).toBe('0.420');
    expect(formatTime(12.3456, [0, 100])).toBe('12.3');
    expect(formatTime(0.00012, [0, 0.001])).toBe('0.000120');
  });

  it('never returns a negative zero', () => {
    expect(formatTime(-1e-9)).toBe('0.000');
  });
});
