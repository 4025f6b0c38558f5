import { describe, expect, it } from 'vitest';
import {
  adaptiveTimes,
  errorOf,
  largestError,
  peakOf,
  type Motion,
} from '../../../web/engine/caller/adaptive-times.ts';

/** A point that accelerates along the unit circle, and a fixed point. */
const angle = (t: number): number => 3 * t * t;
const turning: Motion = {
  at: async (t) => Float32Array.of(Math.cos(angle(t)), Math.sin(angle(t)), 0, 5, 5, 5),
};

/** The largest distance of a chord from the circle, at many times. */
async function densely(motion: Motion, times: readonly number[]): Promise<number> {
  let largest = 0;
  for (let i = 1; i < times.length; i += 1) {
    const [a, b] = [await motion.at(times[i - 1]!), await motion.at(times[i]!)];
    for (let s = 0; s <= 20; s += 1) {
      const between = await motion.at(times[i - 1]! + (s / 20) * (times[i]! - times[i - 1]!));
      const off = [0, 1, 2].map((c) => between[c]! - a[c]! - (s / 20) * (b[c]! - a[c]!));
      largest = Math.max(largest, Math.hypot(...off));
    }
  }
  return largest;
}

const wanted = { corners: [0, 0.5, 1, 2], tolerance: 0.01, grid: null, max: 1000 };

describe('adaptive times', () => {
  it('stay within the tolerance everywhere, include the corners, and are few', async () => {
    const { times, error } = await adaptiveTimes(turning, wanted);
    for (const corner of wanted.corners) expect(times).toContain(corner);
    expect(times).toEqual([...new Set(times)].sort((a, b) => a - b));
    const measured = await densely(turning, times);
    expect(measured).toBeLessThan(wanted.tolerance);
    expect(error).toBeGreaterThan(0.99 * measured);
    // A chord of the circle may span 2 acos(1 - tolerance), which gives the smallest possible number.
    const min = angle(2) / (2 * Math.acos(1 - wanted.tolerance));
    expect(times.length).toBeLessThan(1.6 * min + wanted.corners.length);
  });

  it('are fewer for a larger tolerance, and only the corners if nothing moves', async () => {
    const few = await adaptiveTimes(turning, { ...wanted, tolerance: 0.1 });
    const many = await adaptiveTimes(turning, { ...wanted, tolerance: 0.001 });
    expect(few.times.length).toBeLessThan(many.times.length / 4);
    const still: Motion = { at: async () => Float32Array.of(1, 2, 3) };
    expect(await adaptiveTimes(still, wanted)).toEqual({ times: wanted.corners, error: 0 });
  });

  it('are from the grid if there is one, and the whole grid if it is too coarse', async () => {
    const grid = Array.from({ length: 193 }, (_, i) => i / 96);
    const { times, error } = await adaptiveTimes(turning, { ...wanted, grid });
    expect(times.every((t) => grid.includes(t))).toBe(true);
    expect(times.length).toBeLessThan(grid.length);
    expect(error).toBeLessThan(wanted.tolerance);
    const coarse = [0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2];
    const all = await adaptiveTimes(turning, { ...wanted, tolerance: 1e-4, grid: coarse });
    expect(all.times).toEqual(coarse);
    expect(all.error).toBeCloseTo(await largestError(turning, coarse), 6);
  });

  it('are refused if there would be too many', async () => {
    await expect(adaptiveTimes(turning, { ...wanted, tolerance: 1e-7, max: 100 })).rejects.toThrow(
      'more than 100 morph targets',
    );
  });
});

/** A point that moves along x and oscillates across it. */
const swinging = (across: (t: number) => number): Motion => ({ at: async (t) => Float32Array.of(t, across(t), 0) });

describe('the largest error of a chord', () => {
  it.each([
    ['bends one way, more and more', (t: number) => t ** 4],
    ['bends both ways, and is on the chord in its middle', (t: number) => t * (t - 0.5) * (t - 1)],
    ['bends mostly near its end', (t: number) => Math.exp(4 * t)],
    ['bends both ways, one more than the other', (t: number) => t * (t - 0.6) * (t - 1)],
  ])('is found where the motion %s', async (_, across) => {
    const motion = swinging(across);
    const measured = await densely(motion, [0, 1]);
    const stated = await largestError(motion, [0, 1]);
    expect(stated).toBeGreaterThan(0.97 * measured);
    expect(stated).toBeLessThan(1.005 * measured); // the error is also measured at discrete steps
    // A neighbouring chord has about the same error in its middle.
    expect(await largestError(motion, [-0.01, 0, 1])).toBeGreaterThan(0.97 * measured);
  });

  it('is where it is for a motion of fourth order', () => {
    const off = (s: number): number => s * (1 - s) * (1 + 3 * s + 2 * s * s);
    const { share, distance } = peakOf(off(0.25), off(0.5), off(0.75));
    const largest = Math.max(...Array.from({ length: 1001 }, (_, i) => off(i / 1000)));
    expect(distance).toBeCloseTo(largest, 3);
    expect(off(share)).toBeCloseTo(largest, 3);
    expect(peakOf(0, 0, 0)).toEqual({ share: 0.5, distance: 0 });
  });
});

describe('the error of given times', () => {
  it('is found at a cost that does not grow with their number', async () => {
    let asked = 0;
    const counted: Motion = {
      at: (t) => {
        asked += 1;
        return turning.at(t);
      },
    };
    const times = Array.from({ length: 2001 }, (_, i) => i / 1000);
    expect(await errorOf(counted, times, [0, 0.5, 1, 2])).toBeCloseTo(await largestError(turning, times), 9);
    expect(asked).toBeLessThan(200);
    const few = [0, 0.5, 1, 1.5, 2];
    expect(await errorOf(turning, few, [0, 2])).toBe(await largestError(turning, few));
  });
});
