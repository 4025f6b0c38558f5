/** The animation shown beside the motion for comparison. */
import type { TimedShapes } from '../../study/reference-motion.ts';
import { vertexNormals } from './vertex-normals.ts';

export interface OriginalFrame {
  /** The animation's vertices, 3 x vertices. The arrays are reused for every time. */
  positions: Float32Array;
  normals: Float32Array;
}

export type Original = (t: number) => OriginalFrame;

export function originalOf(reference: TimedShapes, faces: Uint32Array): Original {
  const normals = new Float32Array(reference.at(reference.times[0]!).length);
  return (t) => {
    const positions = reference.at(t);
    vertexNormals(positions, faces, normals);
    return { positions, normals };
  };
}
