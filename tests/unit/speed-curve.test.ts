import { describe, expect, it } from 'vitest';
import { speedAt, speedCurveOf, speedPaths, speedTimes } from '../../web/model/speed-curve.ts';

describe('the curve of a motion on the timeline', () => {
  it('is requested on both sides of every key, in increasing order', () => {
    const times = speedTimes([0, 1], [0, 0.25, 1]);
    expect(times.every((t, i) => i === 0 || t > times[i - 1]!)).toBe(true);
    for (const key of [0, 0.25, 1]) {
      expect(times.some((t) => t < key && key - t < 1e-5)).toBe(true);
      expect(times.some((t) => t > key && t - key < 1e-5)).toBe(true);
    }
    expect(times[0]).toBeLessThan(-0.3);
    expect(times.at(-1)).toBeGreaterThan(1.3);
  });

  it('grows little with many keys', () => {
    const keys = Array.from({ length: 80 }, (_, i) => i);
    expect(speedTimes([0, 79], keys).length).toBeLessThan(900);
  });

  it('has the mean speed within the keys', () => {
    const times = [-1, 0, 0.5, 0.500001, 1, 2];
    const curve = speedCurveOf(times, { speed: [9, 2, 2, 4, 4, 9], overshoot: [0, 0, 0, 0, 0, 0] }, [0, 1]);
    expect(curve.mean).toBeCloseTo(3, 4);
    expect(speedAt(curve, 0.7)).toEqual({ speed: 4 / curve.mean, past: false });
  });

  it('is empty for a motion at rest', () => {
    const still = speedCurveOf([0, 1], { speed: [0, 0], overshoot: [0, 0] }, [0, 1]);
    expect(speedAt(still, 0.5)).toBeNull();
    expect(speedPaths(still, { range: [0, 1], part: [0, 1], width: 100, height: 10 }).line).not.toContain('NaN');
  });

  it('is highest at the largest speed, and tints overshoot only', () => {
    const curve = speedCurveOf([0, 1, 2, 3, 4], { speed: [1, 2, 4, 2, 1], overshoot: [0, 0, 0.2, 0.1, 0] }, [0, 4]);
    const picture = { range: [0, 3], part: [0, 4], width: 100, height: 10 } as const;
    const { line, area, past } = speedPaths(curve, picture);
    expect(line).toBe('M0.0 7.8L25.0 5.5L50.0 1.0L75.0 5.5L100.0 7.8');
    expect(area).toBe('M0.0 10L0.0 7.8L25.0 5.5L50.0 1.0L75.0 5.5L75.0 10Z');
    expect(past).toBe('M50.0 10L50.0 1.0L75.0 5.5L75.0 10Z');
    expect(speedPaths(curve, { ...picture, part: [2, 4] }).line).toContain('L0.0 1.0L50.0 5.5L100.0 7.8');
  });
});
