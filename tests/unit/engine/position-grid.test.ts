import { describe, expect, it } from 'vitest';
import { PointCache } from '../../../web/engine/caller/point-cache.ts';
import { GridFit, STEPS, maxWeight, roundingError } from '../../../web/engine/wire/position-grid.ts';

describe('the grid of a quantised file', () => {
  it('covers the base around its middle, at any position', () => {
    const fit = new GridFit();
    fit.addBase([1000, 0, -5, 1002, 1, -4]);
    expect(fit.grid).toEqual({ centre: [1001, 0.5, -4.5], scale: 1 });
  });

  it('covers the longest difference of a target', () => {
    const fit = new GridFit();
    const base = Float32Array.of(1000, 0, 0, 1002, 0, 0);
    fit.addBase(base);
    fit.addTarget(Float32Array.of(1000, 0, -3, 1002, 2, 0), base);
    expect(fit.grid).toEqual({ centre: [1001, 0, 0], scale: 3 });
    expect(roundingError(fit.grid, 1)).toBeCloseTo((Math.sqrt(3) * 3) / STEPS, 12);
  });

  it('counts the weights that are active at once', () => {
    expect(maxWeight(null, 3)).toBe(1);
    expect(maxWeight(Float32Array.of(0, 0, 0.5, -1, 0.25, 0.25), 3)).toBe(1.5);
  });
});

it('a point cache refuses positions that are not finite', () => {
  const cache = new PointCache('pc2', { seconds: [0] }, 2);
  expect(() => cache.add(Float32Array.of(0, 1, 2, 3, Infinity, 5))).toThrow(/Vertex 1 of a frame is not finite/);
});
