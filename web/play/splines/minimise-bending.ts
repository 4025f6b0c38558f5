/**
 * Least bending by direct minimisation: K samples that minimise the sum of their squared second differences with fixed
 * keys (paper Eq. 1-2, Fig. 2a). Needs K + J equations, where a cubic spline needs J.
 */
import type { Curve } from './curve.ts';
import { solveDense } from './solve.ts';
import { fitCurve } from './fit.ts';
import type { Data } from './slopes.ts';

/** Limit for samples, because the work grows with their third power. */
export const MAX_SOLVED_SAMPLES = 200;

/** The fewest samples with one in every interval between keys; fewer could not meet all keys. */
export function minSamples(times: readonly number[]): number {
  const span = times.at(-1)! - times[0]!;
  const shortest = Math.min(...times.slice(1).map((t, i) => t - times[i]!));
  return Math.max(4, Math.ceil((span / shortest) * (1 - 1e-9)) + 1);
}

/**
 * K evenly spaced samples, at least minSamples. A key between samples constrains the cubic through the nearest four.
 */
export function minimiseBending({ times, values }: Data, samples: number): Data {
  const [start, keys] = [times[0]!, times.length];
  const step = (times.at(-1)! - start) / (samples - 1);
  const size = samples + keys;
  const matrix = Array.from({ length: size }, () => new Array<number>(size).fill(0));
  const difference = [1, -2, 1];
  for (let i = 1; i < samples - 1; i += 1)
    for (let a = 0; a < 3; a += 1)
      for (let b = 0; b < 3; b += 1) matrix[i - 1 + a]![i - 1 + b]! += difference[a]! * difference[b]!;
  times.forEach((t, j) => {
    const place = (t - start) / step;
    const first = Math.min(Math.max(Math.floor(place) - 1, 0), samples - 4);
    const around = [0, 1, 2, 3].map((i) => first + i);
    for (const sample of around) {
      const others = around.filter((other) => other !== sample);
      const factor = others.reduce((product, other) => (product * (place - other)) / (sample - other), 1);
      matrix[samples + j]![sample] = factor;
      matrix[sample]![samples + j] = factor;
    }
  });
  // The gradient of the sum is a combination of the constraints (Lagrange).
  const rhs = [...new Array<number>(samples).fill(0), ...values];
  const path = solveDense({ matrix, rhs }).slice(0, samples);
  return { times: path.map((_, i) => start + i * step), values: path };
}

/** A sample this close to a key, relative to the step, coincides with it. */
const SAME = 1e-6;

/**
 * The smoothest curve through samples and keys. Its bending is an integral, as for every other curve, so it is never
 * less than that of the natural spline through the keys alone. A sum over the samples can be less.
 */
export function curveThrough(samples: Data, keys: Data): Curve {
  const near = SAME * (samples.times[1]! - samples.times[0]!);
  const pairs = (data: Data): [number, number][] => data.times.map((t, i) => [t, data.values[i]!]);
  const apart = pairs(samples).filter(([t]) => keys.times.every((key) => Math.abs(key - t) > near));
  const points = [...pairs(keys), ...apart].sort(([a], [b]) => a - b);
  const data = { times: points.map(([t]) => t), values: points.map(([, value]) => value) };
  return fitCurve('natural', data, { speeds: [1, 1], ends: 'natural', shaping: [] });
}
