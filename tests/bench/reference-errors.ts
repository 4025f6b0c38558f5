/** Compares a motion with a captured one: rigid alignment of shapes, and sliding of resting vertices. */
import { leadingEigenvector } from '../../web/study/symmetric-eigen.ts';

type Vector = [number, number, number];

function centroidOf(shape: Float32Array): Vector {
  const sum: Vector = [0, 0, 0];
  for (let i = 0; i < shape.length; i += 1) sum[i % 3]! += shape[i]!;
  return sum.map((value) => value / (shape.length / 3)) as Vector;
}

/** `shape` aligned with `target` by a rigid motion (Horn 1987); 3 x vertices both. */
export function aligned(shape: Float32Array, target: Float32Array): Float32Array {
  const [from, to] = [centroidOf(shape), centroidOf(target)];
  const s = new Float64Array(9);
  for (let i = 0; i < shape.length; i += 3)
    for (let a = 0; a < 3; a += 1)
      for (let b = 0; b < 3; b += 1) s[3 * a + b]! += (shape[i + a]! - from[a]!) * (target[i + b]! - to[b]!);
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = s as unknown as number[];
  const matrix = [
    [xx! + yy! + zz!, yz! - zy!, zx! - xz!, xy! - yx!],
    [yz! - zy!, xx! - yy! - zz!, xy! + yx!, zx! + xz!],
    [zx! - xz!, xy! + yx!, yy! - xx! - zz!, yz! + zy!],
    [xy! - yx!, zx! + xz!, yz! + zy!, zz! - xx! - yy!],
  ].flat();
  // The largest eigenvalue must also be the largest in magnitude.
  const shift = matrix.reduce((sum, value) => sum + Math.abs(value), 0);
  const [w, x, y, z] = leadingEigenvector(
    matrix.map((value, index) => value + (index % 5 === 0 ? shift : 0)),
    4,
  ) as [number, number, number, number];
  const turn = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
  const result = new Float32Array(shape.length);
  for (let i = 0; i < shape.length; i += 3)
    for (let a = 0; a < 3; a += 1)
      result[i + a] = to[a]! + turn[a]!.reduce((sum, value, b) => sum + value * (shape[i + b]! - from[b]!), 0);
  return result;
}

/** Share of the diagonal: vertices up to this height above the lowest count as on the ground. */
const ON_GROUND = 0.015;
/** Share of the diagonal: less movement is not walking. */
const WALKS = 0.5;

/**
 * Turns a walk in place (Y up) into a real one: moves each frame so that vertices on the ground stay in place on
 * average. null if this gives no movement. 3 x vertices each.
 */
export function walkedOn(shapes: readonly Float32Array[], diagonal: number): Float32Array[] | null {
  const way = { x: 0, z: 0 };
  const moved = shapes.map((shape, frame) => {
    const before = shapes[frame - 1];
    if (before) {
      const step = groundStep(before, shape, ON_GROUND * diagonal);
      way.x -= step.x;
      way.z -= step.z;
    }
    return shape.map((value, i) => value + [way.x, 0, way.z][i % 3]!);
  });
  return Math.hypot(way.x, way.z) > WALKS * diagonal ? moved : null;
}

function groundStep(before: Float32Array, after: Float32Array, height: number): { x: number; z: number } {
  const lowest = (shape: Float32Array): number =>
    shape.reduce((low, value, i) => (i % 3 === 1 && value < low ? value : low), Infinity);
  const [ground, next] = [lowest(before) + height, lowest(after) + height];
  const step = { x: 0, z: 0 };
  let count = 0;
  for (let i = 0; i < before.length; i += 3) {
    if (before[i + 1]! > ground || after[i + 1]! > next) continue;
    step.x += after[i]! - before[i]!;
    step.z += after[i + 2]! - before[i + 2]!;
    count += 1;
  }
  return count === 0 ? step : { x: step.x / count, z: step.z / count };
}

/** Share of the diagonal: a vertex rests between two keys if its true path stays this close to its start. */
const RESTS = 0.005;

/**
 * Distance of resting vertices from their true positions, root mean square over all of them, in percent of the
 * diagonal.
 */
export class Sliding {
  private squares = 0;
  private count = 0;
  private start: Float32Array | null = null;
  private frames: { reference: Float32Array; shape: Float32Array }[] = [];

  constructor(private readonly diagonal: number) {}

  /** Adds the next frame of both, 3 x vertices. `isKey`: whether it is a key, as the first and last frames are. */
  add(reference: Float32Array, shape: Float32Array, isKey: boolean): void {
    this.frames.push({ reference: reference.slice(), shape: shape.slice() });
    if (!isKey) return;
    if (this.start) this.addInterval(this.start);
    this.start = reference.slice();
    this.frames = [];
  }

  private addInterval(start: Float32Array): void {
    const far = (a: Float32Array, b: Float32Array, i: number): number =>
      Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!);
    for (let i = 0; i < start.length; i += 3) {
      if (this.frames.some(({ reference }) => far(reference, start, i) > RESTS * this.diagonal)) continue;
      // The last frame is a key, which every motion matches.
      for (const { reference, shape } of this.frames.slice(0, -1)) this.squares += far(shape, reference, i) ** 2;
      this.count += this.frames.length - 1;
    }
  }

  /** NaN if no vertex rests. */
  get percent(): number {
    return (100 * Math.sqrt(this.squares / this.count)) / this.diagonal;
  }
}
