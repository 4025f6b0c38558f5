/**
 * Finds the fewest shapes of an animation that the method needs as keys to reproduce the others. Adds keys at the
 * motion's largest errors until the error is small enough.
 */
import type { CallOptions, Engine } from '../engine/api/api.ts';
import { farthest } from '../engine/api/distances.ts';
import type { SequenceOptions } from '../engine/api/types.ts';
import type { ReferenceMotion } from './reference-motion.ts';

export interface FewestKeys {
  times: number[];
  /**
   * Largest distance of a vertex at a sample, relative to the diagonal. It exceeds the limit if `max` keys do not
   * suffice.
   */
  error: number;
}

export interface FewestKeysOptions extends CallOptions {
  /** Tolerance as a share of the diagonal. */
  tolerance: number;
  max: number;
  /** Options of the motion between the keys. */
  options: Partial<SequenceOptions>;
}

/** Every interval with at least this share of the largest error gets a key in the same round. */
const NEAR_WORST = 0.6;

export async function fewestKeys(
  engine: Engine,
  reference: ReferenceMotion,
  { tolerance, max, options, signal, onProgress }: FewestKeysOptions,
): Promise<FewestKeys> {
  const last = reference.times.length - 1;
  const target = tolerance * reference.keys.info.report.diagonal;
  let chosen = [0, last];
  let first = 0;
  for (;;) {
    const worst = await worstSamples(engine, reference, chosen, options, signal);
    const error = Math.max(...worst.map((one) => one.distance));
    first ||= error;
    // Errors decrease roughly with the fourth power of the key distance.
    onProgress?.({
      stage: `${chosen.length} keys`,
      fraction: first <= target ? 1 : Math.min(Math.max(Math.log(first / error) / Math.log(first / target), 0), 1),
    });
    const done = error <= target || chosen.length >= Math.min(max, last + 1);
    if (done) {
      const share = error / reference.keys.info.report.diagonal;
      return { times: chosen.map((index) => reference.times[index]!), error: share };
    }
    const added = worst
      .filter(({ distance }) => distance > target && distance >= NEAR_WORST * error)
      .sort((a, b) => b.distance - a.distance)
      .slice(0, max - chosen.length);
    chosen = [...chosen, ...added.map(({ index }) => index)].sort((a, b) => a - b);
  }
}

interface Sample {
  index: number;
  distance: number;
}

/** The sample with the largest error in each interval between two keys. */
async function worstSamples(
  engine: Engine,
  reference: ReferenceMotion,
  chosen: readonly number[],
  options: Partial<SequenceOptions>,
  signal?: AbortSignal,
): Promise<Sample[]> {
  const times = chosen.map((index) => reference.times[index]!);
  const keys = reference.keys.arrange([...chosen], times);
  const call = signal ? { signal } : {};
  const sequence = await engine.createSequence(keys, options, call).finally(() => keys.dispose());
  try {
    const worst = chosen.slice(1).map((): Sample => ({ index: -1, distance: 0 }));
    let stretch = 0;
    for (let index = 0; index < reference.times.length; index += 1) {
      while (index > chosen[stretch + 1]!) stretch += 1;
      signal?.throwIfAborted();
      const [frame] = await sequence.evaluateMany([reference.times[index]!], call);
      const wanted = reference.keys.positions(index);
      const distance = farthest(frame!.positions, wanted, wanted, 0);
      frame!.release();
      if (!chosen.includes(index) && distance > worst[stretch]!.distance) worst[stretch] = { index, distance };
    }
    return worst;
  } finally {
    sequence.dispose();
  }
}
