/**
 * Bending energy of a motion by edge lengths and dihedral angles, which any method's shapes have. Loaded with its first
 * use.
 */
import type { CallOptions } from '../api/api.ts';
import { invalidOption, untilAborted } from '../api/errors.ts';
import { partOf } from '../api/progress.ts';
import { ENCODING_DEFAULTS, type Frame } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';
import type { ShapeClient } from './shape.ts';
import type { ShellsWorker } from './worker-client.ts';

/** Largest mesh that is measured as it is, and size of the coarse mesh of others. */
const MAX_FACES = 1000;
/** Steps of the second differences per range. */
const STEPS = 24;
/** Share of a coarse mesh in the progress. */
const COARSE = 0.3;

type Report = NonNullable<CallOptions['onProgress']>;

/** The measured mesh: the shape's, or a coarse one. */
interface MeasuredMesh {
  faces: Uint32Array;
  keys: readonly Float32Array[];
  /** Positions on this mesh, 3 x its vertices, of a shape. */
  shapeOf(positions: Float32Array): Float32Array;
}

/** The meshes of shapes that were measured. */
const MESHES = new WeakMap<ShapeClient, MeasuredMesh>();

/** The motion to measure. */
interface Measured {
  range: readonly [number, number];
  frame(t: number): Promise<Frame>;
}

export async function shellBending(
  shape: ShapeClient,
  motion: Measured,
  times: readonly number[],
  call: CallOptions,
): Promise<number[]> {
  const { signal, onProgress: report = () => undefined } = call;
  const known = MESHES.get(shape);
  const measured = partOf(report, known ? 0 : COARSE, 1);
  const mesh = known ?? (await coarseMesh(shape, { ...call, onProgress: partOf(report, 0, COARSE) }));
  MESHES.set(shape, mesh);
  const worker = shape.parts.shellsWorker();
  try {
    return await bendingOn(mesh, motion, times, worker, { signal, onProgress: measured });
  } finally {
    worker.terminate(invalidOption('The measure has ended.'));
  }
}

/** The mean over the range, on the whole mesh. */
export async function meanBending(
  { info, positions: keys }: KeyData,
  motion: Measured,
  worker: ShellsWorker,
  call: CallOptions & { onProgress: Report },
): Promise<number> {
  const [first, last] = motion.range;
  const times = Array.from({ length: STEPS - 1 }, (_, i) => first + ((last - first) * (i + 1)) / STEPS);
  const mesh = { faces: info.faces, keys, shapeOf: (positions: Float32Array) => positions.slice() };
  const energies = await bendingOn(mesh, motion, times, worker, call);
  return energies.reduce((sum, energy) => sum + energy / energies.length, 0);
}

async function bendingOn(
  mesh: MeasuredMesh,
  { range, frame }: Measured,
  times: readonly number[],
  worker: ShellsWorker,
  { signal, onProgress }: CallOptions & { onProgress: Report },
): Promise<number[]> {
  const step = (range[1] - range[0]) / STEPS;
  const { sampled, steps } = stepsAround(times, step);
  const shapes: Float32Array[] = [];
  for (const t of sampled) {
    const { positions, release } = await untilAborted(signal, frame(t));
    shapes.push(mesh.shapeOf(positions));
    release();
    onProgress({ stage: 'evaluating', fraction: shapes.length / sampled.length });
  }
  const request = { faces: mesh.faces, keys: mesh.keys, shapes, steps, step };
  const { energy } = await untilAborted(signal, worker.call('shellBending', request));
  return energy.map((one) => one ?? NaN);
}

/** The times a step before and after these times; times on a common grid share shapes. */
function stepsAround(times: readonly number[], step: number) {
  const index = new Map<number, number>();
  const sampled: number[] = [];
  const at = (t: number): number => {
    const place = Math.round((1e6 * t) / step);
    if (!index.has(place)) index.set(place, sampled.push(t) - 1);
    return index.get(place)!;
  };
  const steps = times.map((t): [number, number, number] => [at(t - step), at(t), at(t + step)]);
  return { sampled, steps };
}

/**
 * A function of the keys alone, whatever the shape's encoding. Its vertices are vertices of the shape: then no face is
 * flipped or thin at a key (wasm/core/ghost/simplify.h).
 */
async function coarseMesh(shape: ShapeClient, call: CallOptions & { onProgress: Report }): Promise<MeasuredMesh> {
  const { keys } = shape.parts;
  const { faces } = keys.info;
  if (faces.length / 3 <= MAX_FACES) return { faces, keys: keys.positions, shapeOf: (positions) => positions.slice() };
  const ghosted = await shape.derive(
    keys,
    { ...ENCODING_DEFAULTS, ghostFaces: MAX_FACES, placement: 'vertices' },
    { ...call, onProgress: partOf(call.onProgress, 0, 0.2) },
  );
  try {
    const motion = await ghosted.motion({}, { ...call, onProgress: partOf(call.onProgress, 0.2, 1) });
    motion.dispose();
    const ghost = (await ghosted.ghost())!;
    const shapeOf = (positions: Float32Array): Float32Array => {
      const coarse = new Float32Array(3 * ghost.vertexOf.length);
      ghost.vertexOf.forEach((vertex, i) => coarse.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
      return coarse;
    };
    return { faces: ghost.faces, keys: keys.positions.map(shapeOf), shapeOf };
  } finally {
    ghosted.dispose();
  }
}
