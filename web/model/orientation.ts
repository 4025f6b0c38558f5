/** Orientation of files that do not specify it: up axis, and length of a unit in metres. */
import type { ImportOptions, PathKey, Point } from '../engine/api/types.ts';
import type { Doc } from './state.ts';

export type Orientation = Required<Pick<ImportOptions, 'up' | 'unit'>>;

const NOWHERE: Point = [0, 0, 0];

/** Converts positions from one orientation to another; `offsets`: before and after. */
export function reoriented(
  positions: Float32Array,
  from: Orientation,
  to: Orientation,
  [before, after]: readonly [Point, Point] = [NOWHERE, NOWHERE],
): Float32Array {
  const { scale, turn } = changeOf(from, to);
  const turned = new Float32Array(positions.length);
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const [y, z] = [positions[i + 1]! + before[1], positions[i + 2]! + before[2]];
    turned[i] = scale * (positions[i]! + before[0]) - after[0];
    turned[i + 1] = scale * (turn === 0 ? y : turn * z) - after[1];
    turned[i + 2] = scale * (turn === 0 ? z : -turn * y) - after[2];
  }
  return turned;
}

/** The document for another orientation of its files: pins' offsets turn with the shape. */
export function reorientedDoc(doc: Doc, from: Orientation, to: Orientation): Doc {
  if (!doc.motion.pins.some(({ path }) => path)) return doc;
  const { scale, turn } = changeOf(from, to);
  const turned = ([x, y, z]: Point): PathKey['move'] => [
    scale * x,
    scale * (turn === 0 ? y : turn * z),
    scale * (turn === 0 ? z : -turn * y),
  ];
  const pins = doc.motion.pins.map((pin) =>
    pin.path ? { ...pin, path: pin.path.map((key) => ({ ...key, move: turned(key.move) })) } : pin,
  );
  return { ...doc, motion: { ...doc.motion, pins } };
}

/** From files with z up, (x, y, z) becomes (x, z, -y). */
function changeOf(from: Orientation, to: Orientation): { scale: number; turn: number } {
  return { scale: to.unit / from.unit, turn: Number(to.up === 'z') - Number(from.up === 'z') };
}

/** Converts positions from one offset to another. */
export function relativeTo(positions: Float32Array, before: Point, after: Point): Float32Array {
  return positions.map((value, i) => value + (before[i % 3]! - after[i % 3]!));
}

/** Label of the undo step. */
export function orientationStep(from: Orientation, to: Orientation): string {
  if (from.up === to.up) return 'unit of the files';
  return to.up === 'z' ? 'stand the shape up' : 'lay the shape down';
}
