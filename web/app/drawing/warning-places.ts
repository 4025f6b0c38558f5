/** Adds the location on the shape, in words, to warnings about rotations. Each location appears once. */
import type { KeysInfo, Warning } from '../../engine/api/types.ts';
import { rangeAlong } from '../../viewer/bounds.ts';

/** Warnings about neighbouring regions, which two tests can both report. */
const BETWEEN_NEIGHBOURS = ['ambiguous-patch-turn', 'ambiguous-face-turn'];
/** Low and high along x, y and z, as seen from the front. */
const SIDES = [
  ['left', 'right'],
  ['bottom', 'top'],
  ['back', 'front'],
] as const;

/** `positionsOf` returns the positions of a key, V x 3. */
export function withPlaces(
  warnings: readonly Warning[],
  faces: KeysInfo['faces'],
  positionsOf: (key: number) => Float32Array | null,
): Warning[] {
  const told = new Set<string>();
  return warnings.flatMap((warning) => {
    const { code, key, face, about, start, text } = warning;
    const positions = about === 'Between' && face >= 0 ? positionsOf(key) : null;
    if (!positions) return [warning];
    const part = partOf(positions, faces, face);
    if (BETWEEN_NEIGHBOURS.includes(code)) {
      if (told.has(`${key} ${part}`)) return [];
      told.add(`${key} ${part}`);
    }
    return [{ ...warning, message: `${start}, ${part}, ${text}` }];
  });
}

/** The third of the shape's bounding box, along each axis, that contains a face: "at the top left front". */
export function partOf(positions: Float32Array, faces: KeysInfo['faces'], face: number): string {
  const words = ([1, 0, 2] as const).flatMap((axis) => {
    const [low, high] = rangeAlong(positions, axis);
    const corners = [0, 1, 2].map((corner) => positions[3 * faces[3 * face + corner]! + axis]!);
    const share = (corners.reduce((sum, x) => sum + x, 0) / 3 - low) / Math.max(high - low, Number.MIN_VALUE);
    return share < 1 / 3 ? [SIDES[axis][0]] : share > 2 / 3 ? [SIDES[axis][1]] : [];
  });
  return words.length === 0 ? 'in the middle' : `at the ${words.join(' ')}`;
}
