import { describe, expect, it } from 'vitest';
import {
  formatMoment,
  frameStartTime,
  loopRange,
  nearestFrameTime,
  ownRate,
  playRange,
  snappedTime,
  steppedFrameTime,
  withEnd,
} from '../../web/model/frames.ts';
import { frameCount, frameTimes } from '../../web/engine/api/whole-frames.ts';

const range = [0, 1] as const;

describe('whole frames', () => {
  it('are held until the next one begins, and are never before the start', () => {
    expect(frameStartTime(0.49, null, 0)).toBe(0.49);
    expect(frameStartTime(0.49, 10, 0)).toBe(0.4);
    expect(frameStartTime(0.5, 10, 0)).toBe(0.5);
    expect(frameStartTime(0.3, 10, 0)).toBe(0.3); // 0.3 * 10 is slightly less than 3
    expect(frameStartTime(0.26, 10, 0.25)).toBe(0.25);
    expect(frameStartTime(-0.01, 10, -1)).toBe(-0.1);
  });

  it('are counted without being listed', () => {
    for (const [stretch, fps] of [
      [[0, 1], 24],
      [[-0.4, 1.4], 12.5],
      [[0.26, 0.29], 10],
    ] as const)
      expect(frameCount(stretch, fps)).toBe(frameTimes(stretch, fps).length);
    expect(frameCount([0, 1e9], 60)).toBe(60e9 + 1);
  });

  it('are stepped through one by one, also from a time between two', () => {
    expect(steppedFrameTime(0.5, 24, 1)).toBe(13 / 24);
    expect(steppedFrameTime(0.51, 24, 1)).toBe(13 / 24);
    expect(steppedFrameTime(0.51, 24, -1)).toBe(12 / 24);
    expect(steppedFrameTime(0.5, 24, -10)).toBe(2 / 24);
    let t = 0;
    for (let n = 1; n <= 240; n += 1) {
      t = steppedFrameTime(t, 24, 1);
      expect(t).toBe(n / 24);
    }
  });

  it('are on the grid that contains time zero', () => {
    expect(nearestFrameTime(0.51, 24)).toBe(0.5);
    expect(frameTimes([0, 1], 4)).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(frameTimes([0, 1], 24)).toHaveLength(25);
  });

  it('include both ends of the range, once each', () => {
    expect(frameTimes([0.1, 0.8], 4)).toEqual([0.1, 0.25, 0.5, 0.75, 0.8]);
    expect(frameTimes([0.1, 0.2], 4)).toEqual([0.1, 0.2]);
    expect(frameTimes([0.5, 0.5], 4)).toEqual([0.5]);
    const run = frameTimes([0, 0.7], 24);
    expect([run.length, run.at(-2), run.at(-1)]).toEqual([18, 16 / 24, 0.7]);
    // Rounded quotients are no further frames.
    for (const [end, fps] of [
      [0.7, 30],
      [2.3, 10],
      [1 / 3, 12],
      [1000 + 1e-5, 24],
    ] as const) {
      const times = frameTimes([0, end], fps);
      expect([times.length, times.at(-1)]).toEqual([Math.round(end * fps) + 1, end]);
    }
  });

  it('have the rate of the animation that the keys were taken from', () => {
    const rateOf = (seconds: number, keys: number, start = 0): number | null =>
      ownRate({ animation: 0, animations: [{ name: '', start, end: start + seconds, keys, moves: true }] });
    expect([rateOf(0.7, 22), rateOf(1, 25), rateOf(2, 51, 0.5)]).toEqual([30, 24, 25]);
    expect([rateOf(1001 / 30, 1001), rateOf(10, 1201)]).toEqual([29.97, 120]);
    // Few keys: the first usual rate with whole frames.
    expect([rateOf(0.7, 4), rateOf(1, 3), rateOf(0.375, 3)]).toEqual([30, 30, 24]);
    expect([rateOf(0, 1), ownRate({ animation: -1, animations: [] })]).toEqual([null, null]);
  });

  it('are replaced by close keys', () => {
    expect(snappedTime(0.52, [0, 0.53], 0.02, 10)).toBe(0.53);
    expect(snappedTime(0.52, [0, 0.6], 0.02, 10)).toBe(0.5);
    expect(snappedTime(0.52, [0, 0.6], 0.02, null)).toBe(0.52);
  });

  it('are shown as numbers', () => {
    expect(formatMoment(0.5, range, 24)).toBe('12');
    expect(formatMoment(0.51, range, 24)).toBe('12.24');
    expect(formatMoment(-1e-9, range, 24)).toBe('0');
    expect(formatMoment(0.51, range, null)).toBe('0.510');
  });
});

describe('the playing range', () => {
  it('is the range of the keys, or the chosen range within the slider', () => {
    expect(playRange(null, range)).toEqual([0, 1]);
    expect(playRange([-0.2, 0.5], range)).toEqual([-0.2, 0.5]);
    expect(playRange([0.5, 9], range)).toEqual([0.5, 3]);
    expect(loopRange([7, 9], range)).toBeNull();
    expect(playRange([7, 9], range)).toEqual([0, 1]);
  });

  it('has ends that move with each other', () => {
    expect(withEnd(null, range, 'start', 0.3, 0.01)).toEqual([0.3, 1]);
    expect(withEnd([0.3, 0.6], range, 'start', 0.8, 0.01)).toEqual([0.8, 0.81]);
    expect(withEnd([0.3, 0.6], range, 'end', 0.1, 0.05)).toEqual([0.05, 0.1]);
    expect(withEnd(null, range, 'end', 99, 0.01)).toEqual([0, 3]);
    expect(withEnd(null, range, 'start', 99, 0.1)[1]).toBeCloseTo(3, 12);
  });
});
