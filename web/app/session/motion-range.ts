/** The time range that the keys define. */
import type { Doc } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';

/**
 * `applied`: range of the running sequence. Only the engine knows the period of a closed motion without a given period.
 */
export function motionRange({ keys, motion }: Doc, applied: Range): Range {
  const first = keys[0]?.time ?? 0;
  const last = keys.at(-1)?.time ?? 1;
  if (motion.boundary !== 'periodic') return [first, last];
  return motion.period !== null ? [first, first + motion.period] : applied;
}
