/**
 * Joins the copies of vertices at seams and in flat shaded files: vertices at the same place in every key. The engine
 * does the same with more care (wasm/core/mesh/weld.h), but has no call for its result.
 */
export interface KeyShapes {
  /** Number of keys, and their positions. */
  keys: number;
  key(index: number): Float32Array;
  /** Called between short parts of the work. */
  pause(): Promise<void>;
}

/** Cells along the longest side of the first key's box. Three of their numbers fit in one exact integer. */
const CELLS = 100_000;
/** Copies are this close, as a share of the size. */
const CLOSE = 1e-6;
/** Vertices between two pauses. */
const AT_ONCE = 200;

/** For each vertex, the first vertex at its place. */
export async function joinVertices({ keys, key, pause }: KeyShapes): Promise<Uint32Array> {
  const poses = Array.from({ length: keys }, (_, k) => key(k));
  const { low, size } = boxOf(poses[0]!);
  const vertexOf = new Uint32Array(poses[0]!.length / 3);
  /** The places in each cell and close to it, by their first vertices. */
  const known = new Map<number, number[]>();
  for (let v = 0; v < vertexOf.length; v += 1) {
    if (v % AT_ONCE === 0) await pause();
    const place = low.map((lowest, axis) => ((poses[0]![3 * v + axis]! - lowest) / size) * CELLS);
    const others = known.get(cellsWithin(place, 0)[0]!) ?? [];
    const there = others.find((other) => poses.every((positions) => apart(positions, v, other) <= CLOSE * size));
    vertexOf[v] = there ?? v;
    if (there !== undefined) continue;
    for (const cell of cellsWithin(place, CLOSE * CELLS)) known.set(cell, [...(known.get(cell) ?? []), v]);
  }
  return vertexOf;
}

/** Numbers of the cells within this distance, in cells, of a place: up to 8 at a corner. */
function cellsWithin(place: readonly number[], distance: number): number[] {
  let cells = [0];
  for (const at of place) {
    // The lowest place has neighbours below 0.
    const [from, to] = [Math.floor(at - distance) + 1, Math.floor(at + distance) + 1];
    const along = (one: number): number[] => cells.map((cell) => cell * (CELLS + 3) + one);
    cells = from === to ? along(from) : [...along(from), ...along(to)];
  }
  return cells;
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
