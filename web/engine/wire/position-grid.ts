/**
 * Rounding of positions in a quantised GLB: to 16 bits, with one grid for the base shape and its target offsets. The
 * grid does not have to cover the distance to the origin.
 */
import type { Point } from '../api/types.ts';

/** Steps of a normalised number on either side of 0. */
export const STEPS = 32767;

export interface PositionGrid {
  /** Centre of the base shape. */
  centre: Point;
  /** Size of a normalised 1: an upper bound on the base's coordinates relative to the centre, and on offsets. */
  scale: number;
}

/** Finds the grid from shapes that are added one by one. */
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

  /** Adds a target by its positions, as stored in a GLB. */
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
 * The largest displacement of a vertex by rounding: half a step along each axis, for the base and for every added
 * target. `weight`: the largest sum of target weights at any time.
 */
export function roundingError({ scale }: PositionGrid, weight: number): number {
  return (Math.sqrt(3) * scale * (1 + weight)) / 2 / STEPS;
}

/** Largest sum of an animation's weights at any time; null: one target at a time. */
export function maxWeight(weights: Float32Array | null, times: number): number {
  if (!weights) return 1;
  const targets = weights.length / times;
  let most = 0;
  for (let row = 0; row < times; row += 1) {
    const sum = weights.subarray(row * targets, (row + 1) * targets).reduce((all, one) => all + Math.abs(one), 0);
    most = Math.max(most, sum);
  }
  return most;
}
