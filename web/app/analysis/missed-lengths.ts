/** Whether keys keep the lengths of their edges while the motion between them does not, as for cloth and paper. */
import type { Motion } from '../../engine/api/api.ts';
import { faceAreas } from './face-normals.ts';
import { folds } from './folds.ts';
import { idleSlices } from './idle-slices.ts';

export interface SheetInput {
  motion: Motion;
  faces: Uint32Array;
  /** Number of keys, and their positions. */
  keys: number;
  key(index: number): Float32Array;
  signal: AbortSignal;
}

/** Largest relative difference of the keys' lengths, and largest tolerated difference of the motion's (rms). */
const KEPT = 0.03;
const MISSED = 0.02;
/** Larger meshes are not checked. At most SOME_FACES faces and SOME_INTERVALS intervals are measured. */
const MOST_FACES = 100_000;
const SOME_FACES = 10_000;
const SOME_INTERVALS = 16;

/** The largest relative error (rms) of lengths halfway between keys; null if no option helps or none is needed. */
export async function missedLengths(input: SheetInput): Promise<number | null> {
  const { motion, faces, keys, key, signal } = input;
  if (faces.length / 3 > MOST_FACES) return null;
  const some = someFaces(faces);
  const areas = faceAreas(some, key(0));
  const pause = idleSlices(signal);
  const lengths = [lengthsOf(some, key(0))];
  while (lengths.length < keys) {
    const next = lengthsOf(some, key(lengths.length));
    if (rms(next, lengths[0]!, areas) > KEPT) return null;
    lengths.push(next);
    await pause();
  }
  const times = middles(motion.keyTimes);
  const { weights } = await motion.shapePlane(times);
  // Weights of the keys, then of the tangent poses.
  const row = weights.length / times.length;
  let worst = 0;
  for (const [i, t] of times.entries()) {
    const [frame] = await motion.evaluateMany([t], { signal });
    const found = lengthsOf(some, frame!.positions);
    frame!.release();
    await pause();
    const splined = blend(lengths, weights.slice(i * row, i * row + keys));
    worst = Math.max(worst, rms(found, splined, areas));
  }
  return worst > MISSED && !(await folds({ faces, keys, key, pause })) ? worst : null;
}

/** Times halfway between keys. */
function middles(times: readonly number[]): number[] {
  const all = times.slice(1).map((time, i) => (time + times[i]!) / 2);
  const step = Math.ceil(all.length / SOME_INTERVALS);
  return all.filter((_, i) => i % step === 0);
}

function someFaces(faces: Uint32Array): Uint32Array {
  const step = Math.ceil(faces.length / 3 / SOME_FACES);
  return step === 1 ? faces : faces.filter((_, i) => Math.floor(i / 3) % step === 0);
}

/** Lengths of the sides of the faces, 3 per face. */
function lengthsOf(faces: Uint32Array, positions: Float32Array): Float64Array {
  const lengths = new Float64Array(faces.length);
  for (let i = 0; i < faces.length; i += 1) {
    const [a, b] = [3 * faces[i]!, 3 * faces[i % 3 === 2 ? i - 2 : i + 1]!];
    const x = positions[b]! - positions[a]!;
    const y = positions[b + 1]! - positions[a + 1]!;
    const z = positions[b + 2]! - positions[a + 2]!;
    lengths[i] = Math.sqrt(x * x + y * y + z * z);
  }
  return lengths;
}

function blend(lengths: readonly Float64Array[], weights: readonly number[]): Float64Array {
  const sum = new Float64Array(lengths[0]!.length);
  for (const [key, of] of lengths.entries())
    if (weights[key] !== 0) for (let i = 0; i < sum.length; i += 1) sum[i]! += weights[key]! * of[i]!;
  return sum;
}

/** Relative difference, weighted by the areas of the faces. */
function rms(lengths: Float64Array, wanted: Float64Array, areas: Float64Array): number {
  let [sum, total] = [0, 0];
  for (const [i, length] of lengths.entries()) {
    const area = areas[Math.floor(i / 3)]!;
    if (area === 0) continue;
    sum += area * (length / wanted[i]! - 1) ** 2;
    total += area;
  }
  return total > 0 ? Math.sqrt(sum / total) : 0;
}
