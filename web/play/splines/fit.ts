/** The curves of the playground, each from the same keys. */
import type { Curve } from './curve.ts';
import { catmullRomSlopes, loopTime, shapedSlopes, splineSlopes } from './slopes.ts';
import type { Data, Ends, Shaping, Speeds } from './slopes.ts';

export type CurveKind = 'linear' | 'natural' | 'hermite' | 'periodic' | 'catmull-rom' | 'shaped';

export interface FitOptions {
  speeds: Speeds;
  /** Ends of the curve with tensions and biases. */
  ends: Ends;
  shaping: readonly Shaping[];
}

export function fitCurve(kind: CurveKind, data: Data, { speeds, ends, shaping }: FitOptions): Curve {
  if (kind === 'linear') return open(data, null);
  if (kind === 'catmull-rom') return open(data, catmullRomSlopes(data));
  const held: Ends = kind === 'shaped' ? ends : kind;
  const slopes = splineSlopes(data, held, speeds);
  const shaped = kind === 'shaped' ? shapedSlopes(data, held, slopes, shaping) : slopes;
  return held === 'periodic' ? closed(data, shaped) : open(data, shaped);
}

/**
 * Weight curves of the keys: that of key k is 1 at key k and 0 at all others. The spline is their weighted sum, because
 * it is linear in its keys.
 */
export function weightCurves(kind: CurveKind, times: readonly number[], options: FitOptions): Curve[] {
  return times.map((_, k) => fitCurve(kind, { times, values: times.map((__, j) => (j === k ? 1 : 0)) }, options));
}

function open({ times, values }: Data, slopes: number[] | null): Curve {
  return { times, values, slopes, closed: false };
}

function closed({ times, values }: Data, slopes: number[]): Curve {
  return {
    times: [...times, times.at(-1)! + loopTime(times)],
    values: [...values, values[0]!],
    slopes: [...slopes, slopes[0]!],
    closed: true,
  };
}
