/** The ends of the motion: the boundary and its options. */
import { METHOD, type MethodFacts } from '../engine/api/methods.ts';
import type { Boundary } from '../engine/api/types.ts';
import { keyLabel } from '../model/key-names.ts';
import type { End, Speeds } from '../model/speeds.ts';
import { DEFAULT_SPEED, MAX_SPEED, SPEED_NAME, SPEED_STEP, TANGENT_NAME, TYPED_SPEED } from '../model/speeds.ts';
import type { Encoding, KeyRef, Motion } from '../model/state.ts';
import { BOUNDARIES } from '../model/state.ts';
import type { NumberControl } from './controls.ts';
import { button, fieldRow, numberField, segments, select, setIdle, slider } from './controls.ts';
import type { Component, Fields } from './dom.ts';
import { h, setField, setHidden, setText } from './dom.ts';
import type { DropPoint } from './file-drop.ts';

const BOUNDARY_WORDS: Record<Boundary, { label: string; hint: string }> = {
  natural: {
    label: 'Free',
    hint: 'Natural spline: no bending at the ends; the motion continues straight beyond the first and the last key.',
  },
  hermite: {
    label: 'Ease',
    hint: 'Hermite spline: you set how fast the motion leaves the first key and arrives at the last.',
  },
  periodic: { label: 'Loop', hint: 'Periodic spline: a closed loop without a seam.' },
};

const END_WORDS: Record<End, { speed: string; tangent: string; neighbour: string }> = {
  start: { speed: 'Start speed', tangent: 'Leaves the first key towards', neighbour: 'the next key' },
  end: { speed: 'End speed', tangent: 'Arrives at the last key from', neighbour: 'the key before' },
};

/** A value that no pose has. */
const FROM_FILE = 'file';

export interface MotionEndsProps {
  motion: Motion;
  encoding: Encoding;
  /** The largest offered end speeds. */
  maxSpeeds: Speeds;
  keys: readonly KeyRef[];
  /** Name of any opened pose, including poses that are not keys. */
  poseName: (pose: number) => string;
  /** The default period, for the field's placeholder. */
  period: number;
}

export interface MotionEndsEvents {
  onMotion(change: Partial<Motion>): void;
  onSpeed(end: End, speed: number): void;
  onEncoding(change: Partial<Encoding>): void;
  /** Lets the user choose a file for the end tangent. */
  onTangentFile(end: End): void;
}

export interface MotionEnds extends Fields<MotionEndsProps> {
  /** The end whose tangent field is at this point of the page, or null. */
  endAt(at: DropPoint): End | null;
}

const FREE = 'This method has free ends.';

/** Reasons why a kind of curve does not support these ends. */
const REFUSED: Record<MethodFacts['curve'], Partial<Record<Boundary, string>>> = {
  spline: {},
  polygon: { hermite: 'Ease sets speeds at the ends; this method moves straight from key to key.' },
  fitted: { hermite: FREE, periodic: FREE },
};

export function createMotionEnds(events: MotionEndsEvents): MotionEnds {
  const boundary = segments<Boundary>(
    'Ends',
    'boundary',
    BOUNDARIES.map((value) => ({ value, ...BOUNDARY_WORDS[value] })),
    (value) => events.onMotion({ boundary: value }),
  );
  const hint = h('p', { class: 'hint' });
  const ends = (['start', 'end'] as const).map((end) => ({
    end,
    speed: speedSlider(end, events),
    tangent: tangentSelect(end, events),
  }));
  const parts = [...ends.map(({ speed }) => speed), ...ends.map(({ tangent }) => tangent)];
  const ease = h('div', { class: 'group' }, ...parts.map(({ element }) => element));
  const period = createPeriod(events);
  return {
    elements: [boundary.element, hint, ease, period.element],
    update(props) {
      const { motion, encoding, maxSpeeds } = props;
      boundary.update(motion.boundary, REFUSED[METHOD[motion.method].curve]);
      setText(hint, BOUNDARY_WORDS[motion.boundary].hint);
      setHidden(ease, motion.boundary !== 'hermite');
      for (const { end, speed, tangent } of ends) {
        speed.update(motion[SPEED_NAME[end]], undefined, maxSpeeds[end]);
        tangent.update(props, encoding[TANGENT_NAME[end]]);
      }
      setHidden(period.element, motion.boundary !== 'periodic');
      period.update(props);
    },
    endAt({ x, y }) {
      const [under] = document.elementsFromPoint(x, y).filter((one) => ease.contains(one));
      return (under && ends.find(({ tangent }) => tangent.element.contains(under))?.end) ?? null;
    },
  };
}

function createPeriod({ onMotion }: MotionEndsEvents): Component<MotionEndsProps> {
  let keysLast = 0;
  const period = numberField({
    label: 'Period',
    testId: 'period',
    validationError: (value) =>
      value > keysLast ? null : `longer than the time from the first key to the last, ${keysLast} s`,
    onInput: (value) => onMotion({ period: value }),
  });
  const reset = button({
    label: 'Reset the period',
    testId: 'period-reset',
    icon: 'reset',
    onClick: () => onMotion({ period: null }),
  });
  return {
    element: fieldRow('Period', period, reset),
    update({ motion, keys, period: fallback }) {
      keysLast = Number(((keys.at(-1)?.time ?? 0) - (keys[0]?.time ?? 0)).toFixed(4));
      setField(period, String(Number((motion.period ?? fallback).toFixed(4))));
      setIdle(reset, motion.period === null);
    },
  };
}

function speedSlider(end: End, { onSpeed }: MotionEndsEvents): NumberControl {
  return slider({
    label: END_WORDS[end].speed,
    testId: `${end}-speed`,
    min: 0,
    max: MAX_SPEED,
    typedMax: TYPED_SPEED,
    step: SPEED_STEP,
    fallback: DEFAULT_SPEED,
    onInput: (value) => onSpeed(end, value),
    format: (value) => `${Number(value.toFixed(2))}`,
    hint: 'Relative to the constant speed towards the neighbouring key or tangent pose. 0 eases in or out. You can type any value',
  });
}

/** The end tangent's shape: the neighbour, another key, or one from a file. */
function tangentSelect(
  end: End,
  { onEncoding, onTangentFile }: MotionEndsEvents,
): { element: HTMLElement; update(props: MotionEndsProps, pose: number | null): void } {
  let shown = '';
  const { tangent, neighbour } = END_WORDS[end];
  const field = select<string>(tangent, `${end}-tangent`, [], (value) => {
    if (value !== FROM_FILE) return onEncoding({ [TANGENT_NAME[end]]: value === '' ? null : Number(value) });
    // The displayed choice stays unchanged until a shape is chosen.
    field.update(shown);
    onTangentFile(end);
  });
  return {
    element: field.element,
    update({ keys, poseName }, pose) {
      shown = String(pose ?? '');
      const other = pose !== null && keys.every((key) => key.pose !== pose);
      field.update(shown, [
        { value: '', label: neighbour },
        ...keys.map((key, index) => ({ value: String(key.pose), label: keyLabel(index, key.name) })),
        ...(other ? [{ value: shown, label: poseName(pose) }] : []),
        { value: FROM_FILE, label: 'a shape from a file…' },
      ]);
    },
  };
}
