/** Whether a surface folds between two keys: the angle at an edge changes much. Fits find no shapes there. */
import { faceAreas, faceNormals } from './face-normals.ts';
import { joinVertices } from './join-vertices.ts';
import type { KeyShapes } from './join-vertices.ts';

export interface FoldInput extends KeyShapes {
  /** Vertex indices, 3 per face. */
  faces: Uint32Array;
}

const FOLD = Math.PI / 2;
/** Angles at faces below this share of the mean area are noise. */
const SLIVER = 1e-3;
/** Edges between two pauses. */
const AT_ONCE = 500;

export async function folds(input: FoldInput): Promise<boolean> {
  const { faces, keys, key, pause } = input;
  const edges = await sharedEdges(input);
  const before = new Float64Array(edges.length);
  for (let k = 0; k < keys; k += 1) {
    const positions = key(k);
    const normals = faceNormals(faces, positions);
    for (const [i, { from, to, m, n }] of edges.entries()) {
      if (i % AT_ONCE === 0) await pause();
      const angle = angleBetween(normals, m, n, vector(positions, from, to));
      const turned = angle - before[i]!;
      if (k > 0 && Math.abs(Math.atan2(Math.sin(turned), Math.cos(turned))) > FOLD) return true;
      before[i] = angle;
    }
  }
  return false;
}

interface Edge {
  /** Its vertices, in the order of face `m`. */
  from: number;
  to: number;
  /** The faces beside it. */
  m: number;
  n: number;
}

/** Edges of exactly two faces with area. */
async function sharedEdges(input: FoldInput): Promise<Edge[]> {
  const { faces, key, pause } = input;
  const vertexOf = await joinVertices(input);
  const areas = faceAreas(faces, key(0));
  const least = (SLIVER * areas.reduce((sum, area) => sum + area, 0)) / areas.length;
  /** The sides of each edge by its vertices; null for more than two. */
  const known = new Map<number, Edge | null>();
  for (let i = 0; i < faces.length; i += 1) {
    if (i % AT_ONCE === 0) await pause();
    const [from, to] = [vertexOf[faces[i]!]!, vertexOf[faces[i % 3 === 2 ? i - 2 : i + 1]!]!];
    const name = Math.min(from, to) * vertexOf.length + Math.max(from, to);
    const other = known.get(name);
    const face = Math.floor(i / 3);
    if (other === undefined) known.set(name, { from, to, m: face, n: -1 });
    else known.set(name, other && other.n < 0 ? { ...other, n: face } : null);
  }
  const isShared = (edge: Edge | null): edge is Edge =>
    edge !== null && edge.n >= 0 && areas[edge.m]! > least && areas[edge.n]! > least;
  return [...known.values()].filter(isShared);
}

type Vector = [number, number, number];

/** Of the normals of two faces, around the edge between them. */
function angleBetween(normals: Float64Array, m: number, n: number, edge: Vector): number {
  const [ax, ay, az] = [normals[3 * m]!, normals[3 * m + 1]!, normals[3 * m + 2]!];
  const [bx, by, bz] = [normals[3 * n]!, normals[3 * n + 1]!, normals[3 * n + 2]!];
  const around = edge[0] * (ay * bz - az * by) + edge[1] * (az * bx - ax * bz) + edge[2] * (ax * by - ay * bx);
  return Math.atan2(around / Math.hypot(...edge), ax * bx + ay * by + az * bz);
}

function vector(positions: Float32Array, from: number, to: number): Vector {
  const along = (axis: number): number => positions[3 * to + axis]! - positions[3 * from + axis]!;
  return [along(0), along(1), along(2)];
}
