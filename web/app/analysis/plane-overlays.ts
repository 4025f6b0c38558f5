/**
 * Additional curves in the shape plane: the discretised minimisation that the spline solves in closed form (the paper's
 * third curve in Fig. 2b), and motions that leave the plane.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { Method } from '../../engine/api/types.ts';
import type { AnalysisInput } from './analysis.ts';
import { inPlane } from './shape-plane.ts';

export interface MinimisedCurve {
  /** The curve's points, 2 numbers per sample. */
  points: number[];
  /** Bending energies of the samples, and of the spline at the samples' times. */
  energy: number;
  splineEnergy: number;
  /** The largest distance of a sample from the spline in the plane, as a share of the keys' extent in it. */
  off: number;
}

export interface OutsideCurve {
  method: Method;
  /** The curve's points, 2 numbers per point. */
  points: number[];
  /** The largest distance from the plane, as a share of the mean distance from one key to the next. */
  off: number;
}

export async function minimisedCurve(sequence: Motion, samples: number): Promise<MinimisedCurve> {
  const { times, plane: points, energy, curveEnergy } = await sequence.discretePath(samples);
  const { curve, keys } = await sequence.shapePlane(times);
  const distances = times.map((_, i) =>
    Math.hypot(points[2 * i]! - curve[2 * i]!, points[2 * i + 1]! - curve[2 * i + 1]!),
  );
  const extent = Math.hypot(
    ...[0, 1].map((axis) => {
      const along = keys.filter((_, index) => index % 2 === axis);
      return Math.max(...along) - Math.min(...along);
    }),
  );
  return { points, energy, splineEnergy: curveEnergy, off: extent > 0 ? Math.max(...distances) / extent : 0 };
}

/** Encoding the shape of one point takes this many times as long as a frame. */
const ENCODE_FRAMES = 25;
const BUDGET_MS = 1200;
const MAX_POINTS = 49;
const MIN_POINTS = 13;

/** The motions outside the plane, over the plotted range. Their shapes are encoded one by one. */
export async function outsideCurves({ sequences, range, ms }: AnalysisInput): Promise<OutsideCurve[]> {
  const affordable = BUDGET_MS / Math.max(ms * ENCODE_FRAMES, 0.1);
  const count = Math.round(Math.min(Math.max(affordable, MIN_POINTS), MAX_POINTS));
  const times = Array.from({ length: count }, (_, i) => range[0] + ((range[1] - range[0]) * i) / (count - 1));
  const curves: OutsideCurve[] = [];
  for (const one of sequences) {
    if (inPlane(one)) continue;
    const { method, sequence } = one;
    const { curve, distance } = await sequence.shapePlane(times);
    curves.push({ method, points: curve, off: Math.max(...distance) });
  }
  return curves;
}
