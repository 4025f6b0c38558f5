/** The slopes of a cubic spline at its keys, as the solution of a small system (paper section 3.2). */
import { solveDense, solveTridiagonal } from './solve.ts';
import type { System } from './solve.ts';

export type Ends = 'natural' | 'hermite' | 'periodic';

export interface Data {
  /** J >= 2, strictly increasing. */
  times: readonly number[];
  values: readonly number[];
}

/** End speeds, relative to the mean speed between the first two and the last two keys; only for Hermite ends. */
export type Speeds = readonly [number, number];

/**
 * The J equations for the J slopes. At inner keys the second derivative is continuous, and each end has one equation.
 * In a loop the first and last key are neighbours, which gives two entries in the corners.
 */
export function slopeSystem({ times, values }: Data, ends: Ends, speeds: Speeds): System {
  const n = times.length;
  const h = intervals(times, ends);
  const chord = chords(values, h, ends);
  const matrix = times.map(() => new Array<number>(n).fill(0));
  const rhs = new Array<number>(n).fill(0);
  const loop = ends === 'periodic';
  for (let i = 0; i < n; i += 1) {
    if (!loop && (i === 0 || i === n - 1)) continue;
    const before = (i + n - 1) % n;
    const [a, b] = [1 / h[before]!, 1 / h[i]!];
    matrix[i]![before]! += a;
    matrix[i]![(i + 1) % n]! += b;
    matrix[i]![i]! += 2 * (a + b);
    rhs[i] = 3 * (chord[before]! * a + chord[i]! * b);
  }
  if (loop) return { matrix, rhs };
  const last = n - 1;
  const free = ends === 'natural';
  matrix[0]![0] = matrix[last]![last] = free ? 2 : 1;
  if (free) matrix[0]![1] = matrix[last]![last - 1] = 1;
  rhs[0] = (free ? 3 : speeds[0]) * chord[0]!;
  rhs[last] = (free ? 3 : speeds[1]) * chord[last - 1]!;
  return { matrix, rhs };
}

export function splineSlopes(data: Data, ends: Ends, speeds: Speeds): number[] {
  const system = slopeSystem(data, ends, speeds);
  return ends === 'periodic' ? solveDense(system) : solveTridiagonal(system);
}

/**
 * The mean of the adjacent slopes (Catmull and Rom 1974, Kochanek and Bartels 1984), which depends only on neighbouring
 * keys. At the ends, the only adjacent slope.
 */
export function catmullRomSlopes({ times, values }: Data): number[] {
  const chord = chords(values, intervals(times, 'natural'), 'natural');
  return times.map((_, i) => ((chord[i - 1] ?? chord[i]!) + (chord[i] ?? chord[i - 1]!)) / 2);
}

export interface Shaping {
  tension: number;
  bias: number;
}

/**
 * Tension and bias (Kochanek and Bartels 1984). A share |bias| of the slope is replaced by the chord before the key, or
 * after it for negative bias. The result is scaled by 1 - tension.
 */
export function shapedSlopes(data: Data, ends: Ends, slopes: readonly number[], shaping: readonly Shaping[]): number[] {
  const chord = chords(data.values, intervals(data.times, ends), ends);
  const n = slopes.length;
  const side = (i: number, bias: number): number => {
    const index = bias > 0 ? i - 1 : i;
    return ends === 'periodic' ? chord[(index + n) % n]! : chord[Math.min(Math.max(index, 0), n - 2)]!;
  };
  return slopes.map((slope, i) => {
    const { tension = 0, bias = 0 } = shaping[i] ?? {};
    const leaning = bias === 0 ? slope : (1 - Math.abs(bias)) * slope + Math.abs(bias) * side(i, bias);
    return tension === 0 ? leaning : (1 - tension) * leaning;
  });
}

/** Period of a loop: the interval from the last key to the first is the mean of the others. */
export function loopTime(times: readonly number[]): number {
  return (times.at(-1)! - times[0]!) / (times.length - 1);
}

function intervals(times: readonly number[], ends: Ends): number[] {
  const between = times.slice(1).map((t, i) => t - times[i]!);
  return ends === 'periodic' ? [...between, loopTime(times)] : between;
}

/** Difference quotients, one per interval. */
function chords(values: readonly number[], h: readonly number[], ends: Ends): number[] {
  const next = ends === 'periodic' ? [...values.slice(1), values[0]!] : values.slice(1);
  return next.map((value, i) => (value - values[i]!) / h[i]!);
}
