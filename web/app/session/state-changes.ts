/** Classifies changes of the state for its followers. */
import type { AppState, View } from '../../model/state.ts';
import type { ShownMotions } from './sequence-plan.ts';

export interface StateChanges {
  /** Other sequences are needed, or the current ones need refitting. */
  motions: boolean;
  /** The viewer's look changes without a new frame. */
  look: boolean;
  /** The shown frame must be drawn again, exactly. */
  drawing: boolean;
  time: boolean;
  started: boolean;
  stopped: boolean;
  /** Other files are open. */
  opened: boolean;
}

const MOTIONS = ['compare', 'ghostDifference', 'ghostSizes'] as const satisfies readonly (keyof ShownMotions)[];
const LOOK = ['colouring', 'shading', 'wireframe', 'floor', 'split'] as const;
const DRAWING = [
  'onion',
  'onionSkins',
  'onionSpacing',
  'film',
  'filmShapes',
  'colouring',
  'ghostWire',
  'ghostBeside',
] as const;

export function changesBetween(before: AppState, after: AppState): StateChanges {
  const otherView = (names: readonly (keyof View)[]): boolean =>
    names.some((name) => after.view[name] !== before.view[name]);
  return {
    motions: after.doc !== before.doc || showsOtherMotions(after.view, before.view),
    look: otherView(LOOK),
    drawing: otherView(DRAWING),
    time: after.time !== before.time,
    started: after.play.playing && !before.play.playing,
    stopped: !after.play.playing && before.play.playing,
    // Adding files to a project does not open a new one.
    opened: after.source !== before.source && (after.project === null || after.project !== before.project),
  };
}

export function showsOtherMotions(view: ShownMotions, before: ShownMotions): boolean {
  return MOTIONS.some((name) => view[name] !== before[name]);
}
