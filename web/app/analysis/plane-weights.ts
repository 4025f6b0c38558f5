/**
 * Maps a point of the shape plane to weights of the keys. The plane has only two coordinates, so several mixtures
 * project to one point. The chosen mixture is near the motion's shapes around that point: the difference from them has
 * the least norm, in the weights and in the shapes.
 */

export type Point = readonly [number, number];

export interface PlaneShapes {
  /** Positions of the keys, 2 numbers each, relative to their mean. */
  keys: readonly number[];
  /** Shapes with known weights: 2 numbers per shape, and one weight per key and shape. */
  points: readonly number[];
  weights: readonly number[];
}

export interface PlaneMixture {
  /** One weight per key; they sum to 1. */
  weights: number[];
  /** Its point in the plane: the requested point, unless all keys are collinear. */
  at: Point;
}

/** If the keys' variance along one axis is below this share of the other, it is rounding error. */
const MIN_VARIANCE = 1e-10;
/** Exponent of the inverse distance. It is high, so near the curve only the nearest shapes have an effect. */
const POWER = 6;

/** Returns the exact weights at keys and at every shape in `points`. */
export function mixtureAt(shapes: PlaneShapes, point: Point): PlaneMixture {
  const count = shapes.keys.length / 2;
  const near = nearbyWeights(shapes, point, count);
  const reached = placeOf(shapes.keys, near);
  const weights = [...near];
  const variance = [0, 1].map((axis) => sumOf(count, (key) => shapes.keys[2 * key + axis]! ** 2));
  for (const axis of [0, 1] as const) {
    if (!(variance[axis]! > MIN_VARIANCE * Math.max(...variance))) continue;
    const step = (point[axis] - reached[axis]) / variance[axis]!;
    for (let key = 0; key < count; key += 1) weights[key]! += step * shapes.keys[2 * key + axis]!;
  }
  return { weights, at: placeOf(shapes.keys, weights) };
}

/** Position of an affine mixture of the keys in their plane. */
export function placeOf(keys: readonly number[], weights: readonly number[]): Point {
  const along = (axis: 0 | 1): number => sumOf(keys.length / 2, (key) => weights[key]! * keys[2 * key + axis]!);
  return [along(0), along(1)];
}

/** Shepard's interpolation of the known weights: a mean by inverse distance. */
function nearbyWeights({ points, weights }: PlaneShapes, [x, y]: Point, count: number): number[] {
  const squared = Array.from(
    { length: points.length / 2 },
    (_, i) => (points[2 * i]! - x) ** 2 + (points[2 * i + 1]! - y) ** 2,
  );
  const least = Math.min(...squared);
  const shares = squared.map((distance) => (least === 0 ? Number(distance === 0) : (least / distance) ** (POWER / 2)));
  const total = shares.reduce((sum, share) => sum + share, 0);
  return Array.from(
    { length: count },
    (_, key) => sumOf(shares.length, (i) => shares[i]! * weights[i * count + key]!) / total,
  );
}

function sumOf(count: number, term: (index: number) => number): number {
  let sum = 0;
  for (let index = 0; index < count; index += 1) sum += term(index);
  return sum;
}
