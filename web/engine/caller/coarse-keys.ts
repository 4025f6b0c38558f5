/**
 * Keys of a coarse mesh of the same poses: vertices that stay near each other become one of them. Its motion is there
 * long before that of the many faces of a large mesh.
 */
import type { SequenceOptions } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';

/** Cells along the longest side of a pose. */
const CELLS = 48;
/** Of other poses: what is together in one pose only is kept apart. */
const APART = 12;

export interface CoarseMesh {
  /** Of each of its vertices, which one of the shape it is. */
  vertices: Uint32Array;
  /** 3 of its vertices for each face. */
  faces: Uint32Array;
}

export function coarseKeys(keys: KeyData): { keys: KeyData; mesh: CoarseMesh } {
  const { info, positions } = keys;
  const mesh = coarseMesh([positions[0]!, positions.at(-1)!], info.faces);
  const report = { ...info.report, vertices: mesh.vertices.length, faces: mesh.faces.length / 3 };
  return {
    mesh,
    keys: {
      info: { ...info, report, faces: mesh.faces },
      positions: positions.map((pose) => coarsePositions(mesh, pose)),
      normals: null,
    },
  };
}

/** The same motion of a coarse mesh, but for what is said of single vertices and components. */
export function coarseOptions(options: SequenceOptions, mesh: CoarseMesh): SequenceOptions {
  const { startTangent, endTangent } = options;
  return {
    ...options,
    startTangent: startTangent && coarsePositions(mesh, startTangent),
    endTangent: endTangent && coarsePositions(mesh, endTangent),
    pins: [],
    turns: options.turns.filter(({ component }) => component === undefined),
    ghostFaces: 0,
  };
}

/** `poses`: in each of them vertices that become one are in the same cell of a grid. 3 x vertices each. */
export function coarseMesh(poses: readonly Float32Array[], faces: Uint32Array): CoarseMesh {
  const count = poses[0]!.length / 3;
  const grids = poses.map((pose, i) => gridOf(pose, i === 0 ? CELLS : APART));
  const numberOf = new Map<number, number>();
  const coarseOf = new Uint32Array(count);
  for (let v = 0; v < count; v += 1) {
    let key = 0;
    for (const cellOf of grids) key = key * CELLS ** 3 + cellOf(v);
    let number = numberOf.get(key);
    if (number === undefined) {
      number = numberOf.size;
      numberOf.set(key, number);
    }
    coarseOf[v] = number;
  }
  return { vertices: middles(poses[0]!, coarseOf, numberOf.size), faces: coarseFaces(faces, coarseOf, numberOf.size) };
}

/** Those whose vertices stay apart, each once, turned as most of them are. */
function coarseFaces(faces: Uint32Array, coarseOf: Uint32Array, count: number): Uint32Array {
  const turns = new Map<number, number>();
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [coarseOf[faces[i]!]!, coarseOf[faces[i + 1]!]!, coarseOf[faces[i + 2]!]!];
    if (a === b || b === c || c === a) continue;
    const [low, high] = [Math.min(a, b, c), Math.max(a, b, c)];
    const face = (low * count + (a + b + c - low - high)) * count + high;
    const isAscending = (a < b ? 1 : 0) + (b < c ? 1 : 0) + (c < a ? 1 : 0) === 2;
    turns.set(face, (turns.get(face) ?? 0) + (isAscending ? 1 : -1));
  }
  const coarse: number[] = [];
  for (const [face, turn] of turns) {
    const [low, middle, high] = [Math.floor(face / count / count), Math.floor(face / count) % count, face % count];
    if (turn > 0) coarse.push(low, middle, high);
    if (turn < 0) coarse.push(low, high, middle);
  }
  return Uint32Array.from(coarse);
}

/** Of each group of vertices the one nearest to their mean: one at the rim would turn faces over. */
function middles(pose: Float32Array, groupOf: Uint32Array, groups: number): Uint32Array {
  const mean = new Float64Array(3 * groups);
  const size = new Uint32Array(groups);
  for (let v = 0; v < groupOf.length; v += 1) {
    const group = groupOf[v]!;
    size[group]! += 1;
    const share = 1 / size[group]!;
    for (let i = 0; i < 3; i += 1) mean[3 * group + i]! += share * (pose[3 * v + i]! - mean[3 * group + i]!);
  }
  const middle = new Uint32Array(groups);
  const least = new Float64Array(groups).fill(Infinity);
  for (let v = 0; v < groupOf.length; v += 1) {
    const group = groupOf[v]!;
    let distance = 0;
    for (let i = 0; i < 3; i += 1) distance += (pose[3 * v + i]! - mean[3 * group + i]!) ** 2;
    if (distance >= least[group]!) continue;
    least[group] = distance;
    middle[group] = v;
  }
  return middle;
}

/** xyz of its vertices, of those of the shape. */
export function coarsePositions({ vertices }: CoarseMesh, positions: Float32Array): Float32Array {
  const coarse = new Float32Array(3 * vertices.length);
  for (let i = 0; i < coarse.length; i += 1) coarse[i] = positions[3 * vertices[Math.floor(i / 3)]! + (i % 3)]!;
  return coarse;
}

/** In which cell a vertex of the pose lies. */
function gridOf(pose: Float32Array, cells: number): (vertex: number) => number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < pose.length; i += 1) {
    low[i % 3] = Math.min(low[i % 3]!, pose[i]!);
    high[i % 3] = Math.max(high[i % 3]!, pose[i]!);
  }
  const size = Math.max(...high.map((end, axis) => end - low[axis]!)) / cells;
  const at = (vertex: number, axis: number): number =>
    Math.min(Math.floor((pose[3 * vertex + axis]! - low[axis]!) / size) || 0, cells - 1);
  return (vertex) => (at(vertex, 0) * cells + at(vertex, 1)) * cells + at(vertex, 2);
}
