/** One pose of the keys' mesh from files of its own: an end tangent, or a key to be added. */
import type { Engine, Keys } from '../api/api.ts';
import { EngineError } from '../api/errors.ts';
import type { ImportOptions, InputFile } from '../api/types.ts';

/**
 * 3 x vertices; `options` say how the keys were read. Errors: those of an import, and another number of vertices or
 * other faces than the keys have.
 */
export async function readPose(
  engine: Engine,
  files: InputFile[],
  keys: Keys,
  { up, unit }: ImportOptions = {},
): Promise<Float32Array> {
  // An import holds at least two keys: the same pose stands for both.
  const pose = await engine.importKeyframes([...files, { ...files[0]! }], { up, unit, like: keys.info.faces });
  try {
    const [file, positions, { vertices, faces }] = [files[0]!.name, pose.positions(0), keys.info.report];
    if (positions.length !== 3 * vertices) {
      const sentence = `${file} has ${positions.length / 3} vertices, the keys have ${vertices}: a pose must be of the same mesh.`;
      throw new EngineError('vertex-count-mismatch', sentence, { file });
    }
    const { faces: indices } = pose.info;
    if (indices.length !== 3 * faces) {
      const sentence = `${file} has ${indices.length / 3} faces, the keys have ${faces}: a pose must be of the same mesh.`;
      throw new EngineError('face-count-mismatch', sentence, { file });
    }
    const face = firstOtherFace(indices, keys.info.faces);
    if (face >= 0) {
      const sentence = `${file} has other faces than the keys from face ${face + 1} on: a pose must be of the same mesh.`;
      throw new EngineError('face-mismatch', sentence, { file, face });
    }
    return positions;
  } finally {
    pose.dispose();
  }
}

/** The first triangle that is another one, or -1; they may start at other corners. */
export function firstOtherFace(a: Uint32Array, b: Uint32Array): number {
  const same = (at: number, turn: number): boolean =>
    [0, 1, 2].every((corner) => a[at + corner] === b[at + ((corner + turn) % 3)]);
  const place = a.findIndex((_, at) => at % 3 === 0 && !same(at, 0) && !same(at, 1) && !same(at, 2));
  return place < 0 ? place : place / 3;
}
