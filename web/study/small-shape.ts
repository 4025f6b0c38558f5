/** A simplified shape for fits: its vertices are vertices of the shape, so its motion is nearly the shape's. */
import type { Engine, Keys, Shape } from '../engine/api/api.ts';
import type { EncodingOptions } from '../engine/api/types.ts';
import { runsOf } from './timing-fit.ts';

export interface SmallShape {
  shape: Shape;
  /** Runs of faces of each region; a single region without faces of its own for the whole. */
  regions: number[][];
  /** Its vertices among those of the shape, 3 x vertices each. */
  verticesOf(positions: Float32Array): Float32Array;
  dispose(): void;
}

const MAX_FACES = 2000;
/** A patch needs this number of faces for a well-defined rotation. */
const FACES_PER_PATCH = 16;

/** regionOf: of each face of the shape, or null for one region. */
export async function smallShape(
  engine: Engine,
  keys: Keys,
  { stretch, reference }: EncodingOptions,
  regionOf: Int32Array | null,
): Promise<SmallShape> {
  const { faces, names, times } = keys.info;
  const count = faces.length / 3;
  if (count <= MAX_FACES) {
    const shape = await engine.encode(keys, { stretch, reference });
    const regions = regionOf ? runsOf(regionOf) : [[0, count]];
    return { shape, regions, verticesOf: (positions) => positions, dispose: () => shape.dispose() };
  }
  const full = await engine.encode(keys, { ghostFaces: MAX_FACES });
  const motion = await full.motion();
  motion.dispose();
  const ghost = (await full.ghost())!;
  full.dispose();
  const verticesOf = (positions: Float32Array): Float32Array => {
    const own = new Float32Array(3 * ghost.vertexOf.length);
    ghost.vertexOf.forEach((vertex, i) => own.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
    return own;
  };
  const poses = names.map((name, key) => ({ name, time: times[key]!, positions: verticesOf(keys.positions(key)) }));
  const small = await engine.createKeys({ faces: ghost.faces, poses });
  const smallFaces = ghost.faces.length / 3;
  const shape = await engine.encode(small, {
    stretch,
    reference,
    patches: Math.floor(smallFaces / FACES_PER_PATCH),
  });
  small.dispose();
  const regions = regionOf ? runsOf(majority(regionOf, ghost.ghostFaceOf, smallFaces)) : [[0, smallFaces]];
  return { shape, regions, verticesOf, dispose: () => shape.dispose() };
}

/** The region of most faces that follow a face of the small mesh. */
function majority(regionOf: Int32Array, followed: Int32Array, faces: number): Int32Array {
  const votes = Array.from({ length: faces }, () => new Map<number, number>());
  followed.forEach((face, i) => {
    const region = regionOf[i]!;
    if (face >= 0 && region >= 0) votes[face]!.set(region, (votes[face]!.get(region) ?? 0) + 1);
  });
  return Int32Array.from(votes, (counts) => {
    const [first] = [...counts].sort(([, a], [, b]) => b - a);
    return first?.[0] ?? -1;
  });
}
