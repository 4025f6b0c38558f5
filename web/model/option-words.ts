/**
 * The page's words for the options of the table: each option of the page has a row here, and its control shows it
 * (`web/ui/option-field`). Bounds and defaults are in `web/engine/api/option-table`.
 */
import { ENCODING, MOTION, type PER_KEY } from '../engine/api/option-table.ts';
import { METHOD_WORDS } from './method-words.ts';
import { pageOptions } from './page-options.ts';
import { MAX_SPEED } from './speeds.ts';
import { GHOST_FACES } from './state.ts';

type OnPage<T> = { [N in keyof T]: T[N] extends { page: string } ? N : never }[keyof T];
export type PageOptionName = OnPage<typeof MOTION> | OnPage<typeof ENCODING>;
export type WordedOption = PageOptionName | keyof typeof PER_KEY;

export interface OptionWords {
  label: string;
  /** Label of a change in the undo history; default: the label in lower case. */
  undo?: string;
  /** Tooltip. */
  hint?: string;
  /** Text below the control. */
  note?: string;
  unit?: string;
  /** Name for screen readers and refusals, if the label is not enough. */
  name?: string;
  /** Key of the command that changes it. */
  shortcut?: string;
  /** Words of the choices. The hints are tooltips; `explains`: the chosen one's is also below the control. */
  choices?: Readonly<Record<string, { label: string; hint?: string }>>;
  explains?: true;
  /** The choice of a ticked check box, for an option with two choices. */
  ticked?: string;
  /** Ends of the slider, within the option's bounds. The number beside it has those bounds. */
  slider?: readonly [first: number, last: number];
  step?: number;
  /** Value set by the reset button; default: the option's default. */
  start?: number;
  /** An empty field stands for the default. */
  canBeEmpty?: true;
  /** Reason shown at another option that this one excludes. */
  excludes?: string;
}

const HELD = 'Not with parts held in place.';
const SPEED = {
  hint: 'Relative to the constant speed towards the neighbouring key or tangent pose. 0 eases in or out. You can type any value',
  slider: [0, MAX_SPEED],
} as const;

export const OPTION_WORDS: Readonly<Record<WordedOption, OptionWords>> = {
  method: { label: 'Method', shortcut: 'M', choices: METHOD_WORDS, explains: true },
  hold: {
    label: 'Hold still parts',
    undo: 'hold',
    ticked: 'on',
    note: 'Vertices that hardly move between two keys stay in place. Off: as published; planted feet can slide.',
    excludes: HELD,
  },
  pins: { label: 'Pins', excludes: HELD },
  regions: { label: 'Regions', excludes: 'Not with regions that have timings of their own.' },
  boundary: {
    label: 'Ends',
    choices: {
      natural: {
        label: 'Free',
        hint: 'Natural spline: no bending at the ends; the motion continues straight beyond the first and the last key.',
      },
      hermite: {
        label: 'Ease',
        hint: 'Hermite spline: you set how fast the motion leaves the first key and arrives at the last.',
      },
      periodic: { label: 'Loop', hint: 'Periodic spline: a closed loop without a seam.' },
    },
    explains: true,
    excludes: 'Requires free ends.',
  },
  startSpeed: { label: 'Start speed', ...SPEED },
  endSpeed: { label: 'End speed', ...SPEED },
  startTangent: { label: 'Leaves the first key towards', undo: 'start tangent pose' },
  endTangent: { label: 'Arrives at the last key from', undo: 'end tangent pose' },
  period: { label: 'Period' },
  keepLengths: {
    label: 'Keep lengths',
    undo: 'kept lengths',
    choices: { 0: { label: 'Off' }, 1: { label: '1' }, 2: { label: '2' }, 3: { label: '3' } },
    note: 'Shapes between two keys whose edges keep their lengths: for cloth and paper.',
  },
  spaceFaces: {
    label: 'Fitted mesh',
    unit: 'faces',
    note: 'Shapes are fitted on a mesh with at most this many faces, which the full shape follows. More: finer, but slower to build.',
  },
  spaceSamples: {
    label: 'Intervals',
    undo: 'fitted shapes',
    note: 'Shapes are fitted at both ends of this many intervals. More: closer to the exact curve, but slower to build.',
  },
  tension: {
    label: 'Tension',
    hint: 'Reduces the slope at this key. 0: smooth; 1: stops at the key, which removes overshoot',
    slider: [0, 1],
  },
  bias: {
    label: 'Bias',
    hint: 'Above 0: the slope follows the interval before this key more; below 0: the interval after it',
    slider: [-1, 1],
  },
  earlier: {
    label: 'Earlier or later',
    hint: 'After this key. Above 0: the motion is ahead on the way to the next key; below 0: behind. Keys stay exact',
    slider: [-0.35, 0.35],
    excludes: 'Not with timing.',
  },
  swing: {
    label: 'Swing',
    hint: 'After this key. -1: straight to the next key; 0: as smooth as possible; 1: swings out twice as far',
    slider: [-1, 1.5],
    excludes: 'Not with timing.',
  },
  turns: {
    label: 'Extra turns since the previous key',
    undo: 'turns',
    hint:
      'Full turns to add since the previous key, because keys cannot determine their number. ' +
      'Negative turns have the opposite direction',
    excludes: 'Not with extra turns.',
  },
  reference: { label: 'Reference pose' },
  patches: {
    label: 'Patches',
    name: 'Number of patches; empty: chosen automatically',
    hint: 'Regions of the shape. Each region rotates as a whole, and its faces rotate within it',
    canBeEmpty: true,
  },
  stretch: {
    label: 'Stretch',
    choices: {
      linear: { label: 'Linear', hint: 'Blends stretches, as in the paper' },
      log: { label: 'Logarithmic', hint: 'Blends logarithms of stretches; no face turns inside out' },
    },
  },
  ghostFaces: { label: 'Faces', undo: 'ghost faces', name: 'Faces of the ghost mesh', step: 100, start: GHOST_FACES },
  transfer: {
    label: 'Transfer',
    choices: {
      exact: {
        label: 'Exact',
        hint: 'Passes through every key; details missing from the ghost are interpolated as well',
      },
      paper: {
        label: 'As published',
        hint: 'The details of the reference follow the ghost; the motion passes other keys approximately',
      },
    },
  },
  placement: { label: 'Optimal vertex placement (off the surface)', undo: 'placement', ticked: 'optimal' },
};

export function undoWords(name: WordedOption): string {
  return OPTION_WORDS[name].undo ?? OPTION_WORDS[name].label.toLowerCase();
}

const NAMES = new Map([MOTION, ENCODING].flatMap(pageOptions).map(({ page, name }) => [page, name as PageOptionName]));

/** Undo label of a change of options: that of the first option. */
export function undoName(change: object): string {
  const name = NAMES.get(Object.keys(change)[0] ?? '');
  return name ? undoWords(name) : '';
}
