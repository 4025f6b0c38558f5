/** Whether keys keep the lengths of their edges while the motion between them does not, as for cloth and paper. */
import type { Motion } from '../../engine/api/api.ts';

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
/** With larger changes of the angle between two faces, fits find no shapes. */
const FOLD = Math.PI / 2;
/** Angles at faces below this share of the mean area are noise. */
const SLIVER = 1e-3;
/** Larger meshes are not checked. At most SOME_FACES faces and SOME_INTERVALS intervals are measured. */
const MOST_FACES = 100_000;
const SOME_FACES = 10_000;
const SOME_INTERVALS = 16;

/** The largest relative error (rms) of lengths halfway between keys; null if no option helps or none is needed. */
export async function missedLengths(input: SheetInput): Promise<number | null> {
  const { motion, faces, keys, key, signal } = input;
  if (faces.length / 3 > MOST_FACES) return null;
  const some = someFaces(faces);
  const areas = areasOf(some, key(0));
  const lengths = [lengthsOf(some, key(0))];
  while (lengths.length < keys) {
    const next = lengthsOf(some, key(lengths.length));
    if (rms(next, lengths[0]!, areas) > KEPT) return null;
    lengths.push(next);
    await pause(signal);
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
    const splined = blend(lengths, weights.slice(i * row, i * row + keys));
    worst = Math.max(worst, rms(found, splined, areas));
  }
  return worst > MISSED && !(await folds(input)) ? worst : null;
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
  return Float64Array.from(faces, (from, i) => {
    const to = faces[i % 3 === 2 ? i - 2 : i + 1]!;
    return Math.hypot(...[0, 1, 2].map((axis) => positions[3 * to + axis]! - positions[3 * from + axis]!));
  });
}

function areasOf(faces: Uint32Array, positions: Float32Array): Float64Array {
  return Float64Array.from({ length: faces.length / 3 }, (_, f) => size(normalOf(faces, f, positions)) / 2);
}

function blend(lengths: readonly Float64Array[], weights: readonly number[]): Float64Array {
  return lengths[0]!.map((_, i) => weights.reduce((sum, weight, key) => sum + weight * lengths[key]![i]!, 0));
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

/** Whether the angle between two faces changes by more than FOLD from one key to the next. */
async function folds({ faces, keys, key, signal }: SheetInput): Promise<boolean> {
  const pairs = neighbours(faces);
  const areas = areasOf(faces, key(0));
  const least = (SLIVER * areas.reduce((sum, area) => sum + area, 0)) / areas.length;
  const seen = pairs.filter(({ sides }) => sides.every((face) => areas[face]! > least));
  let before: Float64Array | null = null;
  for (let k = 0; k < keys; k += 1) {
    const positions = key(k);
    const angles: Float64Array = Float64Array.from(seen, (pair) => angleAt(pair, faces, positions));
    const turned = (from: number, i: number): boolean => Math.abs(wrapped(angles[i]! - from)) > FOLD;
    if (before?.some(turned)) return true;
    before = angles;
    await pause(signal);
  }
  return false;
}

interface Pair {
  /** The vertices of the edge. */
  edge: [number, number];
  /** The faces beside it. */
  sides: [number, number];
}

/** Faces that share an edge. Edges of more than two faces are left out. */
function neighbours(faces: Uint32Array): Pair[] {
  const beside = new Map<number, { edge: [number, number]; sides: number[] }>();
  const most = faces.reduce((highest, vertex) => Math.max(highest, vertex), 0) + 1;
  for (const [i, a] of faces.entries()) {
    const b = faces[i % 3 === 2 ? i - 2 : i + 1]!;
    const name = Math.min(a, b) * most + Math.max(a, b);
    const found = beside.get(name);
    if (found) found.sides.push(Math.floor(i / 3));
    else beside.set(name, { edge: [a, b], sides: [Math.floor(i / 3)] });
  }
  return [...beside.values()].filter((one): one is Pair => one.sides.length === 2);
}

type Vector = [number, number, number];

function angleAt({ edge: [a, b], sides }: Pair, faces: Uint32Array, positions: Float32Array): number {
  const [m, n] = sides.map((face) => normalOf(faces, face, positions)) as [Vector, Vector];
  const along = between(positions, a, b);
  return Math.atan2(dot(cross(m, n), along) / size(along), dot(m, n));
}

/** The normal, with the length of twice the area. */
function normalOf(faces: Uint32Array, face: number, positions: Float32Array): Vector {
  const [a, b, c] = [faces[3 * face]!, faces[3 * face + 1]!, faces[3 * face + 2]!];
  return cross(between(positions, a, b), between(positions, a, c));
}

function between(positions: Float32Array, from: number, to: number): Vector {
  return [0, 1, 2].map((axis) => positions[3 * to + axis]! - positions[3 * from + axis]!) as Vector;
}

function cross([a, b, c]: Vector, [x, y, z]: Vector): Vector {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

function dot([a, b, c]: Vector, [x, y, z]: Vector): number {
  return a * x + b * y + c * z;
}

function size(vector: Vector): number {
  return Math.hypot(...vector);
}

function wrapped(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

/** Lets the page draw, and stops where the motion has changed. */
async function pause(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, 0));
  signal.throwIfAborted();
}
