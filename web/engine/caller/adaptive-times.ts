/**
 * Finds the fewest times such that linear interpolation between their shapes stays close to the motion. The error of a
 * chord over h is h^2/8 times the second derivative. Each stretch is therefore divided evenly in the root of that
 * derivative, sampled at a few times. Each chord's error is then measured in the middle, its maximum for even bending.
 * Large errors are also measured at other points.
 */
import { EngineError } from '../api/errors.ts';
import { farthest } from '../api/distances.ts';

export interface Motion {
  /** The shape at t, 3 x vertices; the receiver owns the array. */
  at(t: number): Promise<Float32Array>;
}

export interface Wanted {
  /** Required times; the motion is smooth between two of them. */
  corners: readonly number[];
  /** Largest distance of a vertex, in the unit of the positions. */
  tolerance: number;
  /** Allowed times in addition to the corners, increasing; null: any time. */
  grid: readonly number[] | null;
  /** Limit for the number of times; more are refused. */
  max: number;
  onProgress?: (fraction: number) => void;
}

export interface AdaptiveTimes {
  times: number[];
  /** The largest measured distance. */
  error: number;
}

/** Number of samples of the second derivative, in total and per stretch. */
const SURVEYED = 120;
const [MIN_CELLS, MAX_CELLS] = [2, 12];
/** Shares of the tolerance to aim for and to accept. The measured error is slightly below the maximum. */
const [AIM, ACCEPTED] = [0.8, 0.97];
const ROUNDS = 8;

export async function adaptiveTimes(motion: Motion, wanted: Wanted): Promise<AdaptiveTimes> {
  const { corners, onProgress } = wanted;
  const stretches = corners.length - 1;
  const times = [corners[0]!];
  let error = 0;
  for (let i = 0; i < stretches; i += 1) {
    const stretch = await divided(motion, [corners[i]!, corners[i + 1]!], stretches, wanted);
    times.push(...stretch.times);
    error = Math.max(error, stretch.error);
    if (times.length > wanted.max) throw tooMany(times.length, wanted.max);
    onProgress?.((i + 1) / stretches);
  }
  return { times, error };
}

function tooMany(count: number, max: number): EngineError {
  const sentence =
    `This tolerance needs more than ${max.toLocaleString('en')} morph targets (${count.toLocaleString('en')} so far). ` +
    'Use a larger tolerance, or export a shorter range.';
  return new EngineError('too-large', sentence);
}

/** Times of one stretch, excluding its start. */
async function divided(
  motion: Motion,
  [start, end]: readonly [number, number],
  stretches: number,
  { tolerance, grid, max }: Wanted,
): Promise<AdaptiveTimes> {
  const free = grid?.filter((t) => t > start && t < end) ?? null;
  const finest = free ? free.length + 1 : Infinity;
  const bending = await survey(motion, start, end, stretches);
  let count = Math.max(1, Math.ceil(bending.at(-1)! / Math.sqrt(8 * AIM * tolerance)));
  for (let round = 1; ; round += 1) {
    if (count > max) throw tooMany(count, max);
    const times = cut(bending, [start, end], Math.min(count, finest), free);
    const isLast = count >= finest || round === ROUNDS;
    const error = await largestError(motion, [start, ...times], isLast ? Infinity : ACCEPTED * tolerance);
    if (isLast || error <= ACCEPTED * tolerance) return { times, error };
    count = Math.max(count + 1, Math.ceil(count * Math.min(Math.sqrt(error / (AIM * tolerance)), 4)));
  }
}

/** The root of the second derivative at the inner ones of evenly spaced times. */
async function curvature(motion: Motion, start: number, end: number, stretches: number): Promise<number[]> {
  const cells = Math.min(Math.max(Math.ceil(SURVEYED / stretches), MIN_CELLS), MAX_CELLS);
  const step = (end - start) / cells;
  const roots: number[] = [];
  let [before, middle] = [await motion.at(start), await motion.at(start + step)];
  for (let i = 2; i <= cells; i += 1) {
    const after = await motion.at(i === cells ? end : start + i * step);
    // At the middle of three times: twice the distance from the chord, over the step squared.
    roots.push(Math.sqrt((2 * farthest(middle, before, after, 0.5)) / step ** 2));
    [before, middle] = [middle, after];
  }
  return roots;
}

/** Integral of the root of the second derivative, from the start to each of evenly spaced times. */
async function survey(motion: Motion, start: number, end: number, stretches: number): Promise<number[]> {
  const roots = await curvature(motion, start, end, stretches);
  const cells = roots.length + 1;
  const step = (end - start) / cells;
  const at = (i: number): number => roots[Math.min(Math.max(i - 1, 0), roots.length - 1)]!;
  const sums = [0];
  for (let i = 0; i < cells; i += 1) sums.push(sums[i]! + ((at(i) + at(i + 1)) / 2) * step);
  return sums;
}

/** The ends of `count` parts with equal integrals of the root. */
function cut(
  sums: readonly number[],
  [start, end]: readonly [number, number],
  count: number,
  free: readonly number[] | null,
): number[] {
  if (free && count > free.length) return [...free, end];
  const times: number[] = [];
  const total = sums.at(-1)!;
  let cell = 0;
  for (let i = 1; i < count; i += 1) {
    const wanted = (total * i) / count;
    while (cell < sums.length - 2 && sums[cell + 1]! < wanted) cell += 1;
    const share =
      total > 0 ? (wanted - sums[cell]!) / (sums[cell + 1]! - sums[cell]!) : (i / count) * (sums.length - 1) - cell;
    const t = start + ((cell + share) / (sums.length - 1)) * (end - start);
    const last = times.at(-1) ?? start;
    const taken = free ? nearest(free, t) : t;
    if (taken > last && taken < end) times.push(taken);
  }
  return [...times, end];
}

function nearest(grid: readonly number[], t: number): number {
  let [low, high] = [0, grid.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (grid[middle]! < t) low = middle + 1;
    else high = middle;
  }
  const before = grid[Math.max(low - 1, 0)]!;
  return t - before < grid[low]! - t ? before : grid[low]!;
}

/** A chord's end: its time and shape. */
interface End {
  t: number;
  shape: Float32Array;
}

const endAt = async (motion: Motion, t: number): Promise<End> => ({ t, shape: await motion.at(t) });

/** A chord with errors below this share of another chord's, in the middle and at a quarter, is not worse. */
const SUSPICIOUS = 0.5;

/**
 * Position and size of a chord's largest error, from the distances at a quarter, in the middle and at three quarters.
 * Assumes s (1 - s) times a parabola, as for a fourth-order motion.
 */
export function peakOf(quarter: number, middle: number, last: number): { share: number; distance: number } {
  const parabola = (distance: number, share: number): number => distance / (share * (1 - share));
  const [low, centre, high] = [parabola(quarter, 0.25), parabola(middle, 0.5), parabola(last, 0.75)];
  const [slope, bend] = [2 * (high - low), 8 * (low + high - 2 * centre)];
  let peak = { share: 0.5, distance: middle };
  for (let i = 1; i < 64; i += 1) {
    const x = i / 64 - 0.5;
    const distance = (0.25 - x * x) * (centre + slope * x + bend * x * x);
    if (distance > peak.distance) peak = { share: i / 64, distance };
  }
  return peak;
}

/**
 * Error of a chord if above `min`; smaller errors may be underestimated. If the error in the middle exceeds `enough`,
 * no other point is measured.
 */
async function chordError(
  motion: Motion,
  [start, end]: readonly [End, End],
  min: number,
  enough: number,
): Promise<number> {
  const off = async (share: number): Promise<number> =>
    farthest(await motion.at(start.t + share * (end.t - start.t)), start.shape, end.shape, share);
  const middle = await off(0.5);
  if (middle > enough) return middle;
  const quarter = await off(0.25);
  if (Math.max(quarter, middle) < SUSPICIOUS * min) return Math.max(quarter, middle);
  const last = await off(0.75);
  const largest = Math.max(quarter, middle, last);
  const peak = peakOf(quarter, middle, last);
  return peak.distance > Math.max(min, largest) ? Math.max(largest, await off(peak.share)) : largest;
}

/** Largest error of all chords; above `enough` it may be underestimated. */
export async function largestError(motion: Motion, times: readonly number[], enough = Infinity): Promise<number> {
  let error = 0;
  let start = await endAt(motion, times[0]!);
  for (const t of times.slice(1)) {
    const end = await endAt(motion, t);
    error = Math.max(error, await chordError(motion, [start, end], error, enough));
    start = end;
  }
  return error;
}

/** Limit for measuring all chords. If there are more, only those with the largest expected errors are measured. */
const MEASURED_CHORDS = 24;
const SUSPECTS = 12;

/** Linear interpolation of the values at inner times, at a share of the stretch. */
function between(values: readonly number[], share: number): number {
  const place = share * (values.length + 1) - 1;
  const i = Math.min(Math.max(Math.floor(place), 0), Math.max(values.length - 2, 0));
  const [low, high] = [values[i]!, values[i + 1] ?? values[i]!];
  return low + (place - i) * (high - low);
}

/**
 * Largest error of the chords between given times, at a cost independent of their number. `corners`: as in
 * `adaptiveTimes`.
 */
export async function errorOf(motion: Motion, times: readonly number[], corners: readonly number[]): Promise<number> {
  if (times.length <= MEASURED_CHORDS) return largestError(motion, times);
  const suspects: { chord: readonly [number, number]; expected: number }[] = [];
  let next = 1;
  for (let i = 1; i < corners.length; i += 1) {
    const [start, end] = [corners[i - 1]!, corners[i]!];
    const roots = await curvature(motion, start, end, corners.length - 1);
    for (; next < times.length && times[next]! <= end; next += 1) {
      const chord = [times[next - 1]!, times[next]!] as const;
      const root = between(roots, ((chord[0] + chord[1]) / 2 - start) / (end - start));
      suspects.push({ chord, expected: root * (chord[1] - chord[0]) });
    }
  }
  let error = 0;
  for (const { chord } of suspects.sort((a, b) => b.expected - a.expected).slice(0, SUSPECTS))
    error = Math.max(error, await largestError(motion, chord));
  return error;
}
