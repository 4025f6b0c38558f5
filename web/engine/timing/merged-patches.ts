/**
 * Regions of a shape that move alike in the keys: neighbouring patches merged greedily, by how their rotations relative
 * to one patch differ over the keys. Neighbours are also patches of attached components.
 */
import type { Keys, Motion } from '../api/api.ts';

type Quaternion = readonly [w: number, x: number, y: number, z: number];

/** A group of patches, with the area-weighted mean of its rotation matrices, 9 numbers per key. */
interface Group {
  area: number;
  mean: Float64Array;
  near: Set<number>;
}

/**
 * The region of each face, numbered by their first faces; -1 for faces without area. `wanted`: largest number of
 * regions, if the shape is connected by its neighbours.
 */
export async function mergedPatches(motion: Motion, keys: Keys, wanted: number): Promise<Int32Array> {
  const ofFace = await motion.shape.patches();
  const count = ofFace.reduce((most, patch) => Math.max(most, patch), -1) + 1;
  const curves = await Promise.all(
    Array.from({ length: count }, (_, patch) => motion.patchCurve(patch, [...motion.keyTimes])),
  );
  const areas = areasOf(keys, ofFace, count);
  const means = rotationsFrom(rootOf(areas), curves, motion.keyTimes.length);
  const groups = new Map<number, Group>(
    curves.map(({ neighbours }, patch) => [
      patch,
      { area: areas[patch]!, mean: means[patch]!, near: new Set(neighbours) },
    ]),
  );
  const groupOf = merge(groups, wanted);
  return numberedByFace(ofFace, groupOf);
}

/** The first of the largest patches. */
const rootOf = (areas: readonly number[]): number => areas.indexOf(Math.max(...areas));

/** Area of each patch in the first key. */
function areasOf(keys: Keys, ofFace: Int32Array, count: number): number[] {
  const [positions, { faces }] = [keys.positions(0), keys.info];
  const areas = new Array<number>(count).fill(0);
  ofFace.forEach((patch, face) => {
    if (patch >= 0) areas[patch]! += areaOf(positions, faces.subarray(3 * face, 3 * face + 3));
  });
  return areas;
}

function areaOf(positions: Float32Array, corners: Uint32Array): number {
  const at = (corner: number, axis: number): number => positions[3 * corners[corner]! + axis]!;
  const edge = (corner: number) => [0, 1, 2].map((axis) => at(corner, axis) - at(0, axis)) as [number, number, number];
  const [u, v] = [edge(1), edge(2)];
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

/** Rotation matrices relative to the root, 9 numbers per key for each patch, along the links of neighbours. */
function rotationsFrom(
  root: number,
  curves: readonly { neighbours: number[]; numbers: number[] }[],
  keys: number,
): Float64Array[] {
  const found: Quaternion[][] = [];
  found[root] = Array.from({ length: keys }, () => [1, 0, 0, 0]);
  for (const queue = [root]; queue.length > 0; ) {
    const patch = queue.shift()!;
    const { neighbours, numbers } = curves[patch]!;
    const width = 1 + 4 * neighbours.length;
    neighbours.forEach((next, n) => {
      if (found[next]) return;
      found[next] = found[patch]!.map((q, key) => times(q, numbers.slice(key * width + 1 + 4 * n) as never));
      queue.push(next);
    });
  }
  return curves.map((_, patch) => Float64Array.from((found[patch] ?? found[root]!).flatMap(matrixOf)));
}

function times([w, x, y, z]: Quaternion, [a, b, c, d]: Quaternion): Quaternion {
  return [
    w * a - x * b - y * c - z * d,
    w * b + x * a + y * d - z * c,
    w * c - x * d + y * a + z * b,
    w * d + x * c - y * b + z * a,
  ];
}

function matrixOf([w, x, y, z]: Quaternion): number[] {
  return [
    1 - 2 * (y * y + z * z),
    2 * (x * y - w * z),
    2 * (x * z + w * y),
    2 * (x * y + w * z),
    1 - 2 * (x * x + z * z),
    2 * (y * z - w * x),
    2 * (x * z - w * y),
    2 * (y * z + w * x),
    1 - 2 * (x * x + y * y),
  ];
}

/** Merges the pair that raises the area-weighted variance least, until `wanted` groups are left. */
function merge(groups: Map<number, Group>, wanted: number): Map<number, number> {
  const groupOf = new Map([...groups.keys()].map((patch) => [patch, patch]));
  while (groups.size > wanted) {
    let best: { cost: number; into: number; from: number } | null = null;
    for (const [into, a] of groups)
      for (const from of a.near) {
        if (from <= into) continue;
        const cost = costOf(a, groups.get(from)!);
        // Coarse, so rounding decides no tie.
        if (!best || cost < best.cost * (1 - 1e-6)) best = { cost, into, from };
      }
    if (!best) break;
    const { into, from } = best;
    join(groups, into, from);
    for (const [patch, group] of groupOf) if (group === from) groupOf.set(patch, into);
  }
  return groupOf;
}

function costOf(a: Group, b: Group): number {
  let squares = 0;
  for (let i = 0; i < a.mean.length; i += 1) squares += (a.mean[i]! - b.mean[i]!) ** 2;
  return ((a.area * b.area) / (a.area + b.area || 1)) * squares;
}

function join(groups: Map<number, Group>, into: number, from: number): void {
  const [a, b] = [groups.get(into)!, groups.get(from)!];
  const area = a.area + b.area || 1;
  a.mean = a.mean.map((value, i) => (a.area * value + b.area * b.mean[i]!) / area);
  a.area += b.area;
  for (const near of b.near) {
    const { near: back } = groups.get(near)!;
    back.delete(from);
    if (near === into) continue;
    back.add(into);
    a.near.add(near);
  }
  a.near.delete(into);
  groups.delete(from);
}

function numberedByFace(ofFace: Int32Array, groupOf: ReadonlyMap<number, number>): Int32Array {
  const numbers = new Map<number, number>();
  return ofFace.map((patch) => {
    if (patch < 0) return -1;
    const group = groupOf.get(patch)!;
    if (!numbers.has(group)) numbers.set(group, numbers.size);
    return numbers.get(group)!;
  });
}
