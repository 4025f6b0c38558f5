/** Compares several methods with the exact frame of the default precision over a sweep of times. */
import type { Sequence } from '../../web/engine/api/api.ts';
import type { Frame } from '../../web/engine/api/types.ts';
import { distanceOf } from './distance.ts';
import { frameOf } from './frames.ts';
import { SWEEP, sweptParts, type DistanceAt, type SweptParts } from './sweep.ts';

export interface Errors {
  /** Distance from the shape computed in double. */
  double: SweptParts;
  /** Distance from the shape computed with a ghost mesh; null without one. */
  ghost: SweptParts | null;
}

/** The shape at the k-th time of the sweep in double: 3 numbers per vertex. */
export type Reference = (k: number) => Promise<Float64Array>;

async function withFrame<T>(pending: Promise<Frame | null>, use: (positions: Float32Array) => T): Promise<T> {
  const frame = await frameOf(pending);
  const result = use(frame.positions);
  frame.release();
  return result;
}

export async function errorsOf(sequence: Sequence, withGhost: Sequence | null, reference: Reference): Promise<Errors> {
  const double: DistanceAt[] = [],
    ghost: DistanceAt[] = [];
  for (const [k, t] of SWEEP.entries()) {
    const exact = await frameOf(sequence.evaluate(t));
    double.push({ t, ...distanceOf(exact.positions, await reference(k)) });
    if (withGhost)
      ghost.push({
        t,
        ...(await withFrame(withGhost.evaluate(t), (positions) => distanceOf(positions, exact.positions))),
      });
    exact.release();
  }
  return { double: sweptParts(double), ghost: withGhost ? sweptParts(ghost) : null };
}
