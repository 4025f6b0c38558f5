/**
 * How positions are rounded in a quantised GLB: to 16 bits on one grid, for the base shape and for the differences of
 * its targets. It covers these, and not the distance to the origin.
 */
import type { Point } from '../api/types.ts';

/** Steps of a normalised number on either side of 0. */
export const STEPS = 32767;

export interface PositionGrid {
  /** Centre of the base shape. */
  centre: Point;
  /** Size of a normalised 1: no coordinate of the base is farther from the centre, and no difference is longer. */
  scale: number;
}

/** Finds the grid of shapes that it is shown one by one; all are xyz interleaved. */
export class GridFit {
  private readonly low = [Infinity, Infinity, Infinity];
  private readonly high = [-Infinity, -Infinity, -Infinity];
  private longest = 0;

  addBase(positions: ArrayLike<number>): void {
    for (let i = 0; i < positions.length; i += 1) {
      this.low[i % 3] = Math.min(this.low[i % 3]!, positions[i]!);
      this.high[i % 3] = Math.max(this.high[i % 3]!, positions[i]!);
    }
  }

  addDifference(offsets: ArrayLike<number>): void {
    for (let i = 0; i < offsets.length; i += 1) this.longest = Math.max(this.longest, Math.abs(offsets[i]!));
  }

  /** Adds a target by its positions, as a GLB stores it. */
  addTarget(positions: Float32Array, base: Float32Array): void {
    this.addDifference(positions.map((value, i) => value - base[i]!));
  }

  get grid(): PositionGrid {
    const half = (axis: number): number => (this.high[axis]! - this.low[axis]!) / 2;
    const middle = (axis: number): number => this.low[axis]! + half(axis);
    return {
      centre: [middle(0), middle(1), middle(2)],
      scale: Math.max(half(0), half(1), half(2), this.longest) || 1,
    };
  }
}

/**
 * The largest distance that rounding moves a vertex: half a step of the base and of every target that is added to it,
 * along each axis. `weight`: the largest sum of their weights at any time.
 */
export function roundingError({ scale }: PositionGrid, weight: number): number {
  return (Math.sqrt(3) * scale * (1 + weight)) / 2 / STEPS;
}

/** Largest sum of an animation's weights at any time; null: one target is shown at a time. */
export function mostWeight(weights: Float32Array | null, times: number): number {
  if (!weights) return 1;
  const targets = weights.length / times;
  let most = 0;
  for (let row = 0; row < times; row += 1) {
    const sum = weights.subarray(row * targets, (row + 1) * targets).reduce((all, one) => all + Math.abs(one), 0);
    most = Math.max(most, sum);
  }
  return most;
}
