/** Tests whether colours show amounts, without loading the code that draws them. */
import { isFaceAmount } from '../../model/state.ts';
import type { View } from '../../model/state.ts';
import type { Rect } from '../../viewer/types.ts';
import type { RunningMotion } from '../../playback/frame-set.ts';

export function wantsHeat(sequences: readonly RunningMotion[], view: View): boolean {
  const { colouring, film } = view;
  return !film && (isFaceAmount(colouring) || colouring === 'distance' || differing(sequences, view) >= 0);
}

/** Index of the motion without a ghost that the first one is compared with, or -1. */
export function differing(sequences: readonly RunningMotion[], { ghostDifference, ghostSizes }: View): number {
  const [main] = sequences;
  if (!main?.ghost || !(ghostDifference || ghostSizes)) return -1;
  return sequences.findIndex(({ ghost, method }) => ghost === 0 && method === main.method);
}

/** Views narrower than this, in CSS pixels, have no room for text beside the shape. */
const NARROW_PX = 520;

/** Position of a view's colour bar; `whole`: the full view if a divider shows only a part. */
export function besideOf(rect: Rect, whole = rect): { x: number; y: number; along: boolean } {
  return { x: rect.x, y: rect.y + rect.height / 2, along: whole.width < NARROW_PX };
}
