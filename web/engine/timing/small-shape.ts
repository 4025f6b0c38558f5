/** A simplified shape for fits: its vertices are vertices of the shape, so its motion is nearly the shape's. */
import type { Engine, Keys, Shape } from '../api/api.ts';
import type { EncodingOptions } from '../api/types.ts';

export interface SmallShape {
  shape: Shape;
  /** The region of each of its patches. */
  regionOfPatch: number[];
  /** Its vertices among those of the shape, 3 x vertices each. */
  verticesOf(positions: Float32Array): Float32Array;
  dispose(): void;
}

const MAX_FACES = 2000;
/** A patch needs this number of faces for a well-defined rotation. */
const FACES_PER_PATCH = 8;

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
    const regionOfPatch = await regionsOf(shape, regionOf ?? new Int32Array(count));
    return { shape, regionOfPatch, verticesOf: (positions) => positions, dispose: () => shape.dispose() };
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
  const regionOfFace = regionOf ? majority(regionOf, ghost.ghostFaceOf, smallFaces) : new Int32Array(smallFaces);
  const regionOfPatch = await regionsOf(shape, regionOfFace);
  return { shape, regionOfPatch, verticesOf, dispose: () => shape.dispose() };
}

/** The region of most faces of each patch. */
async function regionsOf(shape: Shape, regionOfFace: Int32Array): Promise<number[]> {
  const motion = await shape.motion(); // encodes the patches
  motion.dispose();
  const patchOf = await shape.patches();
  const patches = patchOf.reduce((most, patch) => Math.max(most, patch), -1) + 1;
  return Array.from(majority(regionOfFace, patchOf, patches), (region) => Math.max(region, 0));
}

/** For each of `count` groups, the value of most of its members; -1 without any. */
function majority(values: Int32Array, groupOf: Int32Array, count: number): Int32Array {
  const votes = Array.from({ length: count }, () => new Map<number, number>());
  groupOf.forEach((group, i) => {
    const value = values[i]!;
    if (group >= 0 && value >= 0) votes[group]!.set(value, (votes[group]!.get(value) ?? 0) + 1);
  });
  return Int32Array.from(votes, (counts) => {
    const [first] = [...counts].sort(([, a], [, b]) => b - a);
    return first?.[0] ?? -1;
  });
}
