/** Distances of shapes over a sweep of times: between the keys, and in the slider's margins. */
import type { Distance } from './distance.ts';

/** Reach of the slider beyond the first and last key, as a share of the range. */
const MARGIN = 0.4;
/** An even number, so no time is the middle key's. */
const INSIDE = 12;
/** Number of times in each margin, including the slider's end. */
const BESIDE = 4;

/** Generated meshes have evenly spaced keys from 0 to 1. */
export const SWEEP: readonly number[] = [
  ...Array.from({ length: BESIDE }, (_, k) => -MARGIN + (MARGIN * k) / BESIDE),
  ...Array.from({ length: INSIDE }, (_, k) => (k + 0.5) / INSIDE),
  ...Array.from({ length: BESIDE }, (_, k) => 1 + (MARGIN * (k + 1)) / BESIDE),
];

/** A distance at one time of the sweep. */
export interface DistanceAt extends Distance {
  t: number;
}

/** Distances over several times, as shares of the diagonal. */
export interface Swept {
  /** Mean over all vertices at all times. */
  mean: number;
  /** Mean of the shape with the largest mean. */
  largestMean: number;
  worst: number;
  /** Time of the largest distance. */
  at: number;
}

export interface SweptParts {
  inside: Swept;
  margins: Swept;
}

export const isInside = (t: number): boolean => t >= 0 && t <= 1;

function over(distances: readonly DistanceAt[]): Swept {
  const means = distances.map(({ mean }) => mean);
  const worst = distances.reduce((a, b) => (b.worst > a.worst ? b : a));
  return {
    mean: means.reduce((a, b) => a + b) / means.length,
    largestMean: Math.max(...means),
    worst: worst.worst,
    at: worst.t,
  };
}

/** Separates distances between the keys from distances in the margins. */
export function sweptParts(distances: readonly DistanceAt[]): SweptParts {
  return {
    inside: over(distances.filter(({ t }) => isInside(t))),
    margins: over(distances.filter(({ t }) => !isInside(t))),
  };
}
