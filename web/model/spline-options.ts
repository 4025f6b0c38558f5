/** What rules out kept lengths, and whether the shape spline still is the published motion. */
import { OWN_METHOD } from '../engine/api/methods.ts';
import { conflicts, type Ruled, type RuledOption } from '../engine/api/rules.ts';
import { listsOf } from './shaping.ts';
import { DEFAULT_MOTION, holds } from './state.ts';
import type { KeyRef, Motion } from './state.ts';

/** The parts of a document that can rule out options. */
export interface Edited {
  keys: readonly Pick<KeyRef, 'shaping'>[];
  motion: Motion;
}

/** The document's options to which the engine's rules apply. */
export function ruledOptions({ keys, motion }: Edited): Ruled {
  return { ...motion, ...listsOf(keys.map(({ shaping }) => shaping)) };
}

/** The option that excludes shapes that keep lengths; null if they are possible. */
export function keepLengthsConflict(edited: Edited): RuledOption | null {
  return (
    conflicts({ ...ruledOptions(edited), method: OWN_METHOD, keepLengths: 1 }).find(
      ({ other }) => other === 'keepLengths',
    )?.option ?? null
  );
}

/** The number of shapes that keep lengths. A number that is excluded stays in the document. */
export function keptLengths(edited: Edited): number {
  const { method, keepLengths } = edited.motion;
  return method !== OWN_METHOD || keepLengthsConflict(edited) ? DEFAULT_MOTION.keepLengths : keepLengths;
}

/** Whether options change the motion from the published method. */
export function departsFromPaper(edited: Edited): boolean {
  return holds(edited.motion) || keptLengths(edited) > 0;
}
