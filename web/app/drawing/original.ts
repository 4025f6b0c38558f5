/** The animation that the keys were taken from, as frames beside the motion. */
import type { ReferenceMotion } from '../../study/reference-motion.ts';

export interface OriginalFrame {
  /** 3 x vertices, the same arrays for every time. */
  positions: Float32Array;
  normals: Float32Array;
}

export type Original = (t: number) => OriginalFrame;

export function originalOf(reference: ReferenceMotion, faces: Uint32Array): Original {
  const normals = new Float32Array(reference.at(reference.times[0]!).length);
  return (t) => {
    const positions = reference.at(t);
    sumNormals(positions, faces, normals);
    return { positions, normals };
  };
}

/** Unit normals of the vertices, faces weighted by their areas. */
function sumNormals(p: Float32Array, faces: Uint32Array, normals: Float32Array): void {
  normals.fill(0);
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f]!, 3 * faces[f + 1]!, 3 * faces[f + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of [a, b, c]) {
      normals[corner]! += x;
      normals[corner + 1]! += y;
      normals[corner + 2]! += z;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) || 1;
    normals[i]! /= length;
    normals[i + 1]! /= length;
    normals[i + 2]! /= length;
  }
}
