/** Where the keys define the motion. */
import type { Doc } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';

/** `served` is the running sequence's: only the engine knows the period of a closed motion that names none. */
export function motionRange({ keys, motion }: Doc, served: Range): Range {
  const first = keys[0]?.time ?? 0;
  const last = keys.at(-1)?.time ?? 1;
  if (motion.boundary !== 'periodic') return [first, last];
  return motion.period !== null ? [first, first + motion.period] : served;
}
