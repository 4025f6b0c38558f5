import { describe, expect, it } from 'vitest';
import { mixtureAt, placeOf } from '../../web/app/analysis/plane-weights.ts';
import type { PlaneShapes } from '../../web/app/analysis/plane-weights.ts';

/** Principal axes: uncorrelated coordinates relative to their mean. */
const keys = [-2, 1, 2, 1, -2, -1, 2, -1];
const unit = (key: number): number[] => [0, 1, 2, 3].map((other) => Number(other === key));
const between = [0.4, 0.3, 0.2, 0.1];
const shapes: PlaneShapes = {
  keys,
  points: [...keys, ...placeOf(keys, between)],
  weights: [...[0, 1, 2, 3].flatMap(unit), ...between],
};
const sum = (values: readonly number[]): number => values.reduce((all, one) => all + one, 0);

describe('the mixture at a point of the shape plane', () => {
  it('is the key itself at a key, and a known shape at its point', () => {
    for (const key of [0, 1, 2, 3]) {
      expect(mixtureAt(shapes, [keys[2 * key]!, keys[2 * key + 1]!]).weights).toEqual(unit(key));
    }
    const { weights } = mixtureAt(shapes, placeOf(keys, between));
    weights.forEach((weight, key) => expect(weight).toBeCloseTo(between[key]!, 12));
  });

  it('has the requested point, with weights that sum to 1', () => {
    for (const point of [
      [0, 0],
      [7, -4],
      [-1.9, 0.9],
      [0.3, 30],
    ] as const) {
      const { weights, at } = mixtureAt(shapes, point);
      expect(sum(weights)).toBeCloseTo(1, 12);
      expect(at[0]).toBeCloseTo(point[0], 9);
      expect(at[1]).toBeCloseTo(point[1], 9);
      expect(placeOf(keys, weights)).toEqual(at);
    }
  });

  it('changes nearby weights as little as possible', () => {
    // all shapes except one are far away, so the rest has the least norm of weights at that point
    const one: PlaneShapes = { keys, points: [0, 0], weights: [0.25, 0.25, 0.25, 0.25] };
    expect(mixtureAt(one, [1, 0]).weights).toEqual([0.125, 0.375, 0.125, 0.375]);
  });

  it('stays on the line if all keys are on one', () => {
    const line: PlaneShapes = { keys: [-1, 0, 1, 0], points: [-1, 0, 1, 0], weights: [1, 0, 0, 1] };
    const { weights, at } = mixtureAt(line, [0.5, 3]);
    expect(weights[0]).toBeCloseTo(0.25, 12);
    expect(at).toEqual([expect.closeTo(0.5, 12), 0]);
  });

  it('is smooth: a small step of the point is a small step of the weights', () => {
    let before = mixtureAt(shapes, [-2, 1]).weights;
    for (let i = 1; i <= 2000; i += 1) {
      const { weights } = mixtureAt(shapes, [-2 + (4 * i) / 2000, 1 - (1.7 * i) / 2000]);
      expect(Math.max(...weights.map((weight, key) => Math.abs(weight - before[key]!)))).toBeLessThan(0.02);
      before = weights;
    }
  });
});
