/** Extent of the poses for the view: their box, and a sample of points to fit. */
import type { Bounds } from './floor.ts';

/** Enough to fit a view tightly, few enough to process in one frame. */
const POINTS_PER_POSE = 1500;

/** Points this close to the floor count as touching it. A share of the height. */
const TOUCHES = 0.05;

/**
 * The extent for fitting a view: the box, and some vertices of every pose, xyz interleaved, including the extreme ones
 * along each axis.
 */
export interface Extent {
  bounds: Bounds;
  points: Float32Array;
}

export function extentOf(poses: Iterable<Float32Array>): Extent {
  const min: Bounds['min'] = [Infinity, Infinity, Infinity];
  const max: Bounds['max'] = [-Infinity, -Infinity, -Infinity];
  const points: number[] = [];
  for (const positions of poses) {
    const vertices = positions.length / 3;
    const step = Math.max(1, Math.floor(vertices / POINTS_PER_POSE));
    for (let v = 0; v < vertices; v += step) push(points, positions, v);
    extremes(positions).forEach((v, index) => {
      push(points, positions, v);
      const axis = Math.floor(index / 2) as 0 | 1 | 2;
      min[axis] = Math.min(min[axis], positions[3 * v + axis]!);
      max[axis] = Math.max(max[axis], positions[3 * v + axis]!);
    });
  }
  return { bounds: { min, max, foot: footOf(points, min[1], max[1]) }, points: Float32Array.from(points) };
}

function footOf(points: number[], floor: number, top: number): Bounds['foot'] {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    if (points[i + 1]! > floor + TOUCHES * (top - floor)) continue;
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k]!, points[i + 2 * k]!);
      high[k] = Math.max(high[k]!, points[i + 2 * k]!);
    }
  }
  const [x, z] = [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2];
  return { x, z, radius: Math.hypot(high[0]! - x, high[1]! - z) };
}

function push(points: number[], positions: Float32Array, vertex: number): void {
  points.push(positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!);
}

function extremes(positions: Float32Array): number[] {
  const found = [0, 0, 0, 0, 0, 0];
  for (let v = 0; v < positions.length / 3; v += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const value = positions[3 * v + axis]!;
      if (value < positions[3 * found[2 * axis]! + axis]!) found[2 * axis] = v;
      if (value > positions[3 * found[2 * axis + 1]! + axis]!) found[2 * axis + 1] = v;
    }
  }
  return found;
}

/** Minimum and maximum coordinate along an axis. */
export function rangeAlong(positions: Float32Array, axis: 0 | 1 | 2): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]!);
    high = Math.max(high, positions[i]!);
  }
  return [low, high];
}
