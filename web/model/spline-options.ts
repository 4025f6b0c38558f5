/** Options of the shape spline that other choices rule out, and whether it still is the published motion. */
import { OWN_METHOD } from '../engine/api/methods.ts';
import { listsOf } from './shaping.ts';
import { DEFAULT_MOTION, holds } from './state.ts';
import type { Encoding, KeyRef, Motion } from './state.ts';

/** The parts of a document that can rule out options. */
export interface Edited {
  keys: readonly Pick<KeyRef, 'shaping'>[];
  motion: Motion;
  encoding: Encoding;
}

/** The choice that rules out an option. */
export type RuledOut = 'ends' | 'held' | 'turns' | 'paths' | 'transfer';

/** The choice that rules out shapes that keep lengths; null if they are possible. */
export function whyNoLengths({ keys, motion }: Edited): RuledOut | null {
  if (motion.boundary !== 'natural') return 'ends';
  if (holds({ ...motion, method: OWN_METHOD })) return 'held';
  return addsTurns(keys) ? 'turns' : motion.ownPaths !== 'off' ? 'paths' : null;
}

/** The choice that rules out own paths of faces; null if they are possible. */
export function whyNoPaths({ keys, encoding }: Edited): RuledOut | null {
  if (addsTurns(keys)) return 'turns';
  return encoding.ghostFaces > 0 && encoding.transfer === 'paper' ? 'transfer' : null;
}

/** The options in effect. An option that is ruled out keeps its value in the document. */
export function splineOptions(edited: Edited): Pick<Motion, 'keepLengths' | 'ownPaths'> {
  const { method, keepLengths, ownPaths } = edited.motion;
  const off = DEFAULT_MOTION;
  if (method !== OWN_METHOD) return { keepLengths: off.keepLengths, ownPaths: off.ownPaths };
  return {
    keepLengths: whyNoLengths(edited) ? off.keepLengths : keepLengths,
    ownPaths: whyNoPaths(edited) ? off.ownPaths : ownPaths,
  };
}

/** Whether options change the motion from the published method. */
export function departs(edited: Edited): boolean {
  const { keepLengths, ownPaths } = splineOptions(edited);
  return holds(edited.motion) || keepLengths > 0 || ownPaths !== 'off';
}

function addsTurns(keys: Edited['keys']): boolean {
  return listsOf(keys.map(({ shaping }) => shaping)).turns.length > 0;
}
