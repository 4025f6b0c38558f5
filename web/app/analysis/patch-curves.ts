/** A patch over time: its rotation against each neighbour, the rotation axes, and its stretch. */
import type { PatchCurve } from '../../engine/api/types.ts';
import { rotationVector, unwound } from '../../study/rotation-vectors.ts';
import type { Quaternion, Vector } from '../../study/rotation-vectors.ts';

export interface PatchNeighbour {
  patch: number;
  /**
   * The rotation log(G_i^T G_j) at each time, in degrees, in the axes of the reference pose. It may exceed 180 degrees.
   */
  turn: Vector[];
}

export interface PatchCurves {
  /** The neighbours, sorted by largest rotation, descending. */
  neighbours: PatchNeighbour[];
  stretch: number[];
}

const NONE: Quaternion = [1, 0, 0, 0];

/** `rows`: numbers or natural of the curve; `reference`: index of the time with zero rotation. */
export function patchCurves({ neighbours }: PatchCurve, rows: readonly number[], reference: number): PatchCurves {
  const width = 1 + 4 * neighbours.length;
  const count = rows.length / width;
  const indices = Array.from({ length: count }, (_, i) => i);
  const vectorAt = (row: number, k: number): Vector => {
    const [w, x, y, z] = rows.slice(row * width + 1 + 4 * k, row * width + 5 + 4 * k) as [...Quaternion];
    return rotationVector(NONE, [w, x, y, z]);
  };
  const turns = neighbours.map((patch, k): PatchNeighbour => {
    const vectors = indices.map((row) => vectorAt(row, k));
    const after = unwound(vectors.slice(reference));
    const before = unwound(vectors.slice(0, reference + 1).reverse()).reverse();
    const turn = [...before.slice(0, -1), ...after].map((vector) => vector.map(degrees) as Vector);
    return { patch, turn };
  });
  const furthest = ({ turn }: PatchNeighbour): number => Math.max(...turn.map(angleOf));
  return {
    neighbours: turns.sort((a, b) => furthest(b) - furthest(a)),
    stretch: indices.map((row) => rows[row * width]!),
  };
}

/** The rotation angle in degrees, including full turns. */
export function angleOf(turn: Vector): number {
  return Math.hypot(...turn);
}

function degrees(radians: number): number {
  return (180 / Math.PI) * radians;
}
