/**
 * Keys of a coarse mesh of the same poses: vertices that stay near each other become one of them. Its motion is there
 * long before that of the many faces of a large mesh.
 */
import type { SequenceOptions } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';

/** Cells along the longest side of a pose. */
const CELLS = 40;

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
  const grids = poses.map(gridOf);
  const numberOf = new Map<number, number>();
  const coarseOf = new Uint32Array(count);
  const vertices: number[] = [];
  for (let v = 0; v < count; v += 1) {
    let key = 0;
    for (const cellOf of grids) key = key * CELLS ** 3 + cellOf(v);
    let number = numberOf.get(key);
    if (number === undefined) {
      number = vertices.push(v) - 1;
      numberOf.set(key, number);
    }
    coarseOf[v] = number;
  }
  const corners = new Uint32Array(faces.length);
  let used = 0;
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [coarseOf[faces[i]!]!, coarseOf[faces[i + 1]!]!, coarseOf[faces[i + 2]!]!];
    if (a === b || b === c || c === a) continue;
    corners[used] = a;
    corners[used + 1] = b;
    corners[used + 2] = c;
    used += 3;
  }
  return { vertices: Uint32Array.from(vertices), faces: corners.slice(0, used) };
}

/** xyz of its vertices, of those of the shape. */
export function coarsePositions({ vertices }: CoarseMesh, positions: Float32Array): Float32Array {
  const coarse = new Float32Array(3 * vertices.length);
  for (let i = 0; i < coarse.length; i += 1) coarse[i] = positions[3 * vertices[Math.floor(i / 3)]! + (i % 3)]!;
  return coarse;
}

/** In which cell a vertex of the pose lies. */
function gridOf(pose: Float32Array): (vertex: number) => number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < pose.length; i += 1) {
    low[i % 3] = Math.min(low[i % 3]!, pose[i]!);
    high[i % 3] = Math.max(high[i % 3]!, pose[i]!);
  }
  const size = Math.max(...high.map((end, axis) => end - low[axis]!)) / CELLS;
  const at = (vertex: number, axis: number): number =>
    Math.min(Math.floor((pose[3 * vertex + axis]! - low[axis]!) / size) || 0, CELLS - 1);
  return (vertex) => (at(vertex, 0) * CELLS + at(vertex, 1)) * CELLS + at(vertex, 2);
}
