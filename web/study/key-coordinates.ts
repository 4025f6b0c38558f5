/**
 * Single coordinates of a shape at its keys, to explain the values that splines interpolate: rotations between
 * neighbouring patches (log(G_i^-1 G_j) in the paper's Eq. 5, about its main axis) and stretches. The core computes the
 * method's coordinates; these are measured independently from the keys' vertices.
 */
import { rotationVector, unwound } from './rotation-vectors.ts';
import type { Quaternion, Vector } from './rotation-vectors.ts';
import { leadingEigenvector } from './symmetric-eigen.ts';

export interface KeyCoordinate {
  kind: 'angle' | 'stretch';
  /** Indices of the patches, 0-based: two for an angle, one for a stretch. */
  patches: number[];
  /** One value per key: degrees, or edge length relative to the reference. */
  values: number[];
}

export interface KeyPoses {
  /** Vertex indices, 3 x faces. */
  faces: Uint32Array;
  /** Patch of each face; -1 for none. */
  patches: Int32Array;
  /** Positions of each key, 3 x vertices. */
  poses: readonly Float32Array[];
  /** Index of the reference key. */
  reference: number;
}

const EDGES = [
  [0, 1],
  [1, 2],
  [2, 0],
] as const;

/** The coordinates that change most, angles first: at most `count` of each kind. */
export function keyCoordinates(keys: KeyPoses, count: number): KeyCoordinate[] {
  const fitted = keys.poses.map((pose) => fitPatches(keys, pose));
  const angles = neighbours(keys).map(([i, j]): KeyCoordinate => {
    const vectors = unwound(fitted.map(({ rotation }) => rotationVector(rotation[i]!, rotation[j]!)));
    return { kind: 'angle', patches: [i, j], values: alongMainAxis(vectors).map((angle) => (angle * 180) / Math.PI) };
  });
  const stretches = fitted[0]!.stretch.map((_, patch): KeyCoordinate => {
    return { kind: 'stretch', patches: [patch], values: fitted.map(({ stretch }) => stretch[patch]!) };
  });
  const range = ({ values }: KeyCoordinate): number => Math.max(...values) - Math.min(...values);
  const most = (list: KeyCoordinate[]): KeyCoordinate[] =>
    list
      .filter(({ values }) => values.every(Number.isFinite))
      .sort((a, b) => range(b) - range(a))
      .slice(0, count);
  return [...most(angles), ...most(stretches)];
}

interface FittedPatches {
  rotation: Quaternion[];
  stretch: number[];
}

/** The rotation of each patch that best maps its edges in the reference to those in the pose (Horn 1987). */
function fitPatches({ faces, patches, poses, reference }: KeyPoses, pose: Float32Array): FittedPatches {
  const count = patches.reduce((most, patch) => Math.max(most, patch + 1), 0);
  const products = Array.from({ length: count }, () => new Float64Array(9));
  const [before, after] = [new Float64Array(count), new Float64Array(count)];
  const rest = poses[reference]!;
  patches.forEach((patch, face) => {
    if (patch < 0) return;
    for (const [a, b] of EDGES) {
      const [from, to] = [3 * faces[3 * face + a]!, 3 * faces[3 * face + b]!];
      for (let r = 0; r < 3; r += 1) {
        const edge = rest[to + r]! - rest[from + r]!;
        const moved = pose[to + r]! - pose[from + r]!;
        before[patch]! += edge * edge;
        after[patch]! += moved * moved;
        for (let c = 0; c < 3; c += 1) products[patch]![3 * r + c]! += edge * (pose[to + c]! - pose[from + c]!);
      }
    }
  });
  return {
    rotation: products.map((product) => rotationOf(product)),
    stretch: Array.from(before, (length, patch) => Math.sqrt(after[patch]! / length)),
  };
}

/** m: sums of products, 3 * (reference axis) + (pose axis). */
function rotationOf(m: Float64Array): Quaternion {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m as unknown as number[];
  const matrix = [
    ...[xx! + yy! + zz!, yz! - zy!, zx! - xz!, xy! - yx!],
    ...[yz! - zy!, xx! - yy! - zz!, xy! + yx!, zx! + xz!],
    ...[zx! - xz!, xy! + yx!, yy! - xx! - zz!, yz! + zy!],
    ...[xy! - yx!, zx! + xz!, yz! + zy!, zz! - xx! - yy!],
  ];
  return leadingEigenvector(matrix, 4) as unknown as Quaternion;
}

/**
 * The vectors' components along their direction of largest change, oriented so that the last is not below the first.
 */
function alongMainAxis(vectors: readonly Vector[]): number[] {
  const mean = [0, 1, 2].map((i) => vectors.reduce((sum, vector) => sum + vector[i]!, 0) / vectors.length);
  const products = Array.from({ length: 9 }, (_, entry) => {
    const [i, j] = [Math.floor(entry / 3), entry % 3];
    return vectors.reduce((sum, vector) => sum + (vector[i]! - mean[i]!) * (vector[j]! - mean[j]!), 0);
  });
  const axis = leadingEigenvector(products, 3);
  const along = vectors.map((vector) => vector.reduce((sum, part, i) => sum + part * axis[i]!, 0));
  return along.at(-1)! < along[0]! ? along.map((value) => -value) : along;
}

/** Pairs of patches that share an edge, each once. */
function neighbours({ faces, patches }: KeyPoses): [number, number][] {
  const patchAt = new Map<number, number>();
  const pairs = new Map<string, [number, number]>();
  const vertices = faces.reduce((most, vertex) => Math.max(most, vertex + 1), 0);
  patches.forEach((patch, face) => {
    if (patch < 0) return;
    for (const [a, b] of EDGES) {
      const [from, to] = [faces[3 * face + a]!, faces[3 * face + b]!];
      const edge = Math.min(from, to) * vertices + Math.max(from, to);
      const other = patchAt.get(edge);
      if (other === undefined) patchAt.set(edge, patch);
      else if (other !== patch)
        pairs.set(`${Math.min(other, patch)} ${Math.max(other, patch)}`, [
          Math.min(other, patch),
          Math.max(other, patch),
        ]);
    }
  });
  return [...pairs.values()];
}
