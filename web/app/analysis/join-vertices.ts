/**
 * Joins the copies of vertices at seams and in flat shaded files: vertices at the same place in every key. The engine
 * does the same with more care (wasm/core/mesh/weld.h); here a missed copy only hides an edge.
 */
export interface KeyShapes {
  /** Number of keys, and their positions. */
  keys: number;
  key(index: number): Float32Array;
  /** Called between short parts of the work. */
  pause(): Promise<void>;
}

/** Cells per side of the first key's box. Three of these numbers fit in one exact integer. */
const CELLS = 100_000;
/** Copies are this close, as a share of the size. */
const CLOSE = 1e-6;
/** Vertices between two pauses. */
const AT_ONCE = 500;

/** For each vertex, the first vertex at its place. */
export async function joinVertices({ keys, key, pause }: KeyShapes): Promise<Uint32Array> {
  const first = key(0);
  const vertexOf = new Uint32Array(first.length / 3);
  const { low, size } = boxOf(first);
  const known = new Map<number, number>();
  for (let v = 0; v < vertexOf.length; v += 1) {
    if (v % AT_ONCE === 0) await pause();
    const place = (axis: number): number => Math.round(((first[3 * v + axis]! - low[axis]!) / size) * CELLS);
    const cell = [0, 1, 2].reduce((sum, axis) => sum * (CELLS + 1) + place(axis), 0);
    const there = known.get(cell);
    if (there === undefined) known.set(cell, v);
    vertexOf[v] = there ?? v;
  }
  for (let k = 0; k < keys; k += 1) {
    const positions = key(k);
    for (let v = 0; v < vertexOf.length; v += 1) {
      if (v % AT_ONCE === 0) await pause();
      const other = vertexOf[v]!;
      if (other !== v && apart(positions, v, other) > CLOSE * size) vertexOf[v] = v;
    }
  }
  return vertexOf;
}

function apart(positions: Float32Array, v: number, w: number): number {
  const along = (axis: number): number => Math.abs(positions[3 * v + axis]! - positions[3 * w + axis]!);
  return Math.max(along(0), along(1), along(2));
}

/** The lowest corner and the longest side of the bounding box. */
function boxOf(positions: Float32Array): { low: number[]; size: number } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 1) {
    const axis = i % 3;
    if (positions[i]! < low[axis]!) low[axis] = positions[i]!;
    if (positions[i]! > high[axis]!) high[axis] = positions[i]!;
  }
  return { low, size: Math.max(...high.map((value, axis) => value - low[axis]!)) || 1 };
}
