/** Options of the shape spline that other choices rule out, and whether it still is the published motion. */
import { OWN_METHOD } from '../engine/api/methods.ts';
import { listsOf } from './shaping.ts';
import { DEFAULT_MOTION, holds } from './state.ts';
import type { Encoding, KeyRef, Motion } from './state.ts';

/** The parts of a document that decide. */
export interface Edited {
  keys: readonly Pick<KeyRef, 'shaping'>[];
  motion: Motion;
  encoding: Encoding;
}

/** What rules out an option. */
export type RuledOut = 'ends' | 'held' | 'turns' | 'paths' | 'transfer';

/** Why no shapes between the keys can keep lengths; null if they can. */
export function whyNoLengths({ keys, motion }: Edited): RuledOut | null {
  if (motion.boundary !== 'natural') return 'ends';
  if (holds({ ...motion, method: OWN_METHOD })) return 'held';
  return addsTurns(keys) ? 'turns' : motion.ownPaths !== 'off' ? 'paths' : null;
}

/** Why faces cannot have paths of their own; null if they can. */
export function whyNoPaths({ keys, encoding }: Edited): RuledOut | null {
  if (addsTurns(keys)) return 'turns';
  return encoding.ghostFaces > 0 && encoding.transfer === 'paper' ? 'transfer' : null;
}

/** The options in effect. Choices that rule them out keep them, so they return. */
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
