/** Effect of own paths of faces on the error against the animation of the keys. */
import type { Motion } from '../../engine/api/api.ts';
import { motionOf } from '../../engine/api/options.ts';
import { MotionError } from '../../study/motion-error.ts';
import type { TimedShapes } from '../../study/reference-motion.ts';
import { idleSlices } from './idle-slices.ts';

export interface GainInput {
  motion: Motion;
  /** The animation that the keys are from, at their times. */
  reference: TimedShapes;
  /** Milliseconds per frame. */
  ms: number;
  signal: AbortSignal;
}

/** KG errors in percent. */
export interface Gain {
  off: number;
  own: number;
}

const BUDGET_MS = 5000;
const [LEAST_TIMES, MOST_TIMES] = [13, 97];

export async function ownPathsGain({ motion, reference, ms, signal }: GainInput): Promise<Gain> {
  const times = someTimes(reference.times, motion.keyTimes, BUDGET_MS / Math.max(2 * ms, 0.1));
  const off = await errorOf(motion, reference, times, signal);
  const own = await motion.shape.motion(
    { ...motionOf(motion.options), ownPaths: 'absolute', keyTimes: [...motion.keyTimes] },
    { signal },
  );
  try {
    return { off, own: await errorOf(own, reference, times, signal) };
  } finally {
    own.dispose();
  }
}

/** Samples of the animation within the range of the keys. */
function someTimes(all: readonly number[], keyTimes: readonly number[], affordable: number): number[] {
  const [first, last] = [keyTimes[0]!, keyTimes.at(-1)!];
  const inside = all.filter((t) => t >= first && t <= last);
  const step = Math.ceil(inside.length / Math.min(Math.max(affordable, LEAST_TIMES), MOST_TIMES));
  return inside.filter((_, i) => i % step === 0);
}

async function errorOf(
  motion: Motion,
  reference: TimedShapes,
  times: readonly number[],
  signal: AbortSignal,
): Promise<number> {
  const error = new MotionError(1);
  const pause = idleSlices(signal);
  for (const t of times) {
    await pause();
    const [frame] = await motion.evaluateMany([t], { signal });
    error.add(reference.at(t), frame!.positions);
    frame!.release();
  }
  return error.percent;
}
