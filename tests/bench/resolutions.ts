/** The same motion at two resolutions (the paper's Fig. 10): a mesh, and the mesh with every face split into four. */
import type { Engine } from '../../web/engine/api/api.ts';
import { distanceOf, NO_DISTANCE, worse, type Distance } from './distance.ts';
import { evenTimes } from './ghost-frames.ts';

const SHAPES = 13;

export interface Resolutions {
  coarseFaces: number;
  fineFaces: number;
  /** Distance over common vertices and the whole range. */
  distance: Distance;
}

/** The split mesh begins with the other mesh's vertices. */
export async function compareResolutions(engine: Engine, coarse: Uint8Array, fine: Uint8Array): Promise<Resolutions> {
  const few = await shapesOf(engine, coarse, Infinity);
  const many = await shapesOf(engine, fine, few.shapes[0]!.length);
  const distance = few.shapes.reduce(
    (far: Distance, shape, k) => worse(far, distanceOf(many.shapes[k]!, shape)),
    NO_DISTANCE,
  );
  return { coarseFaces: few.faces, fineFaces: many.faces, distance };
}

/** The first `numbers` of each shape. */
async function shapesOf(
  engine: Engine,
  mesh: Uint8Array,
  numbers: number,
): Promise<{ faces: number; shapes: Float32Array[] }> {
  const keys = await engine.importKeyframes([{ name: 'bench.glb', bytes: mesh }]);
  const sequence = await engine.createSequence(keys);
  const shapes: Float32Array[] = [];
  for (const t of evenTimes(sequence.range, SHAPES)) {
    const [frame] = await sequence.evaluateMany([t]);
    shapes.push(frame!.positions.slice(0, numbers));
    frame!.release();
  }
  sequence.dispose();
  const { faces } = keys.info.report;
  keys.dispose();
  return { faces, shapes };
}
