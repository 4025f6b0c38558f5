/** Distance of the shown motions from the first one, or from an animation. */
import type { Method } from '../../engine/api/types.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import { MotionError } from '../../study/motion-error.ts';
import type { MotionName } from '../../study/motion-measures.ts';
import type { AnalysisInput } from './analysis.ts';

/** The reference of the comparison, and the diagonal that distances are relative to. */
export interface Compared {
  /** Returns the animation's shape at a time; null if no animation is shown. */
  original: ((t: number) => { positions: Float32Array }) | null;
  /** Name of the animation if it comes from other files than the keys, else null. */
  referenceName?: string | null;
  diagonal: number;
}

export interface MotionDistances {
  times: number[];
  /** The reference motion's method; null means the animation. */
  from: Method | null;
  /** Mean distance in percent of the diagonal at each time; the KG error of all times in percent. */
  motions: (MotionName & { mean: number[]; largest: number[]; kg: number })[];
}

const BUDGET_MS = 1200;
const MIN_TIMES = 13;
const MAX_TIMES = 97;
/** Number of shapes held in memory at a time. */
const AT_ONCE = 8;

/**
 * Distances of the motions over the keys' range, because the animation does not extend beyond it; null without a
 * reference.
 */
export async function motionDistances(
  { sequences, keyTimes, range, ms }: AnalysisInput,
  { original, diagonal }: Compared,
): Promise<MotionDistances | null> {
  const others = sequences.slice(original ? 0 : 1);
  if (others.length === 0) return null;
  const affordable = BUDGET_MS / Math.max(ms * sequences.length, 0.1);
  const count = Math.round(Math.min(Math.max(affordable, MIN_TIMES), MAX_TIMES));
  const [start, end] = [keyTimes[0]!, keyTimes.at(-1)!];
  const times = plottedTimes(range, keyTimes, count).filter((t) => !original || (t >= start && t <= end));
  const errors = others.map(() => new MotionError(diagonal));
  for (let from = 0; from < times.length; from += AT_ONCE) {
    const some = times.slice(from, from + AT_ONCE);
    const frames = await Promise.all(sequences.map(({ sequence }) => sequence.evaluateMany(some)));
    some.forEach((t, i) => {
      const reference = original?.(t).positions ?? frames[0]![i]!.positions;
      errors.forEach((error, k) => error.add(reference, frames[k + sequences.length - others.length]![i]!.positions));
    });
    for (const frame of frames.flat()) frame.release();
  }
  return {
    times,
    from: original ? null : sequences[0]!.method,
    motions: others.map(({ method, plain }, k) => ({
      method,
      ...(plain && { plain }),
      mean: errors[k]!.over.mean,
      largest: errors[k]!.over.largest,
      kg: errors[k]!.percent,
    })),
  };
}
