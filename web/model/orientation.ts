/** How files are read that do not say it themselves: which of their axes is up, and how long a unit is in metres. */
import type { ImportOptions } from '../engine/api/types.ts';

export type Orientation = Required<Pick<ImportOptions, 'up' | 'unit'>>;

/** Positions that were read in one way, as if they had been read in another. */
export function reoriented(positions: Float32Array, from: Orientation, to: Orientation): Float32Array {
  const scale = to.unit / from.unit;
  // From files with z up, (x, y, z) becomes (x, z, -y).
  const turn = Number(to.up === 'z') - Number(from.up === 'z');
  const turned = new Float32Array(positions.length);
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const [y, z] = [positions[i + 1]!, positions[i + 2]!];
    turned[i] = scale * positions[i]!;
    turned[i + 1] = scale * (turn === 0 ? y : turn * z);
    turned[i + 2] = scale * (turn === 0 ? z : -turn * y);
  }
  return turned;
}

/** What was done, as undo names it. */
export function orientationStep(from: Orientation, to: Orientation): string {
  if (from.up === to.up) return 'unit of the files';
  return to.up === 'z' ? 'stand the shape up' : 'lay the shape down';
}
