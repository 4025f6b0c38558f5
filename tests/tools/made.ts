/** Input for the programs: motions with several materials, and the expected result. */
import { createEngine } from '../../web/engine/node.ts';
import type { Keys, Sequence } from '../../web/engine/api/api.ts';
import type { ExportedFile, ExportOptions } from '../../web/engine/api/types.ts';
import { afterAll } from 'vitest';
import { paintedFile } from '../engine/support/painted.ts';

const engine = createEngine();
afterAll(() => engine.dispose());

export { engine };

export interface Made {
  keys: Keys;
  sequence: Sequence;
  diagonal: number;
  at(t: number): Promise<Float32Array>;
  files(options: Partial<ExportOptions>): Promise<ExportedFile[]>;
  glb(options: Partial<ExportOptions>): Promise<Uint8Array>;
}

/** A bar bent by 0, 40 and 80 degrees, with two materials, textures and a normal map. */
export async function paintedMotion(): Promise<Made> {
  const keys = await engine.importKeyframes([await paintedFile()], { keyTimes: [0, 0.5, 1] });
  const sequence = await engine.createSequence(keys);
  const files = (options: Partial<ExportOptions>): Promise<ExportedFile[]> => sequence.export(options);
  return {
    keys,
    sequence,
    diagonal: keys.info.report.diagonal,
    at: async (t) => {
      const [frame] = await sequence.evaluateMany([t]);
      return frame!.positions;
    },
    files,
    glb: async (options) => (await files(options))[0]!.bytes,
  };
}

/** The largest distance of a shown vertex from the mesh's vertex with its number. */
export function farthestShown(
  shown: Iterable<readonly [vertex: number, x: number, y: number, z: number]>,
  wanted: Float32Array,
): number {
  let largest = 0;
  let count = 0;
  for (const [vertex, x, y, z] of shown) {
    const at = 3 * vertex;
    largest = Math.max(largest, Math.hypot(x - wanted[at]!, y - wanted[at + 1]!, z - wanted[at + 2]!));
    count += 1;
  }
  return count >= wanted.length / 3 ? largest : Infinity;
}
