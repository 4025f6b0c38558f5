import { describe, expect, it } from 'vitest';
import { formatSpeed, maxSpeed, offeredSpeed, steppedSpeed } from '../../web/model/speeds.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, endTangents } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';
import { keyRef } from './documents.ts';

describe('Hermite speeds', () => {
  it('are whole steps from 0 to 4', () => {
    expect([-1, 0.024, 0.026, 1.37, 99].map(offeredSpeed)).toEqual([0, 0, 0.05, 1.35, 4]);
  });

  it('are stepped through without leaving the steps', () => {
    let speed = 0;
    for (let n = 1; n <= 80; n += 1) {
      speed = steppedSpeed(speed, 1);
      expect(speed).toBe(Number((n * 0.05).toFixed(2)));
    }
    expect(steppedSpeed(speed, 1)).toBe(4);
    expect(steppedSpeed(-3, -1)).toBe(0);
  });

  it('have a limit that depends on the distance of the tangent pose', () => {
    expect([null, 3, 2, 0.4, 0.01, 0].map((shape) => maxSpeed(2, shape))).toEqual([4, 4, 4, 20, 40, 40]);
    expect(maxSpeed(0, 0)).toBe(4);
    expect([17.02, 99].map((wanted) => offeredSpeed(wanted, 20))).toEqual([17, 20]);
    expect([steppedSpeed(19.95, 1, 20), steppedSpeed(19.95, 10, 20)]).toEqual([20, 20]);
  });

  it('are written with their unit', () => {
    expect([1, 0.35, -2].map(formatSpeed)).toEqual(['1×', '0.35×', '-2×']);
  });
});

describe('the target of an end tangent', () => {
  const doc = (change: Partial<Doc['encoding']>): Doc => ({
    keys: [4, 2, 7].map((pose, index) => keyRef(pose, '', index)),
    motion: { ...DEFAULT_MOTION, boundary: 'hermite' },
    encoding: { ...DEFAULT_ENCODING, ...change },
  });

  it('is the neighbour, or the chosen tangent pose, a key or not', () => {
    expect(endTangents(doc({}))).toEqual({ start: 'neighbour', end: 'neighbour' });
    expect(endTangents(doc({ startTangentPose: 7 }))).toEqual({ start: 'shape', end: 'neighbour' });
    expect(endTangents(doc({ endTangentPose: 0 }))).toEqual({ start: 'neighbour', end: 'shape' });
  });

  it('is null if the boundary has no tangents', () => {
    expect(endTangents({ ...doc({}), motion: { ...DEFAULT_MOTION } })).toBeNull();
  });
});
