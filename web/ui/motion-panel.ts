/** Interpolation of the keys: method, compared motions, and boundary. */
import { METHOD, METHODS } from '../engine/api/methods.ts';
import type { Method } from '../engine/api/types.ts';
import type { Motion } from '../model/state.ts';
import type { Spacing } from '../model/key-spacing.ts';
import { METHOD_WORDS, PLAIN_WORDS, fittedText } from '../model/method-words.ts';
import { DEFAULT_SHAPING } from '../model/shaping.ts';
import { departsFromPaper } from '../model/spline-options.ts';
import { DEFAULT_MOTION, MAX_COMPARED } from '../model/state.ts';
import { button, buttonGroup, checkbox, select, setIdle, slider } from './controls.ts';
import type { MotionEnds, MotionEndsEvents, MotionEndsProps } from './motion-ends.ts';
import { createMotionEnds } from './motion-ends.ts';
import { createPinList } from './pin-list.ts';
import type { Component, Fields } from './dom.ts';
import { h, memo, setHidden, setText } from './dom.ts';

const HOLD_HINT =
  'Vertices that hardly move between two keys stay in place. Off: as published; planted feet can slide.';

const SPACING_WORDS: readonly { value: Spacing; text: string; hint: string }[] = [
  { value: 'even', text: 'Evenly', hint: 'Intervals of equal length' },
  { value: 'root', text: 'Softly', hint: 'Intervals proportional to the square root of pose difference' },
  {
    value: 'difference',
    text: 'By pose difference',
    hint: 'Intervals proportional to pose difference: nearly constant speed',
  },
];

export interface MotionPanelProps extends MotionEndsProps {
  compare: readonly Method[];
  /** The intervals between keys where the shown motion has fitted shapes; null if it fits none. */
  fitted: readonly boolean[] | null;
  /** The next click on the shape pins that vertex. */
  placing: boolean;
  /** Mean tension of the keys. */
  tightness: number;
  disabled: boolean;
  /** Values restored by the reset button. */
  defaults: Motion;
}

export interface MotionPanelEvents extends MotionEndsEvents {
  onCompare(methods: Method[]): void;
  onPlacing(placing: boolean): void;
  /** Sets the same tension for all keys. */
  onTightness(tension: number): void;
  /** Sets each key's tension to keep its slope within its bound. */
  onAutoTightness(): void;
  onSpacing(spacing: Spacing): void;
  /** Reverses the motion. */
  onReverse(): void;
  onReset(): void;
}

/** `animation`: section on the source of the keys, shown at the top; `options`: of the shape spline. */
export function createMotionPanel(
  events: MotionPanelEvents,
  animation: HTMLElement,
  options: HTMLElement,
): Component<MotionPanelProps> & Pick<MotionEnds, 'endAt'> {
  const ends = createMotionEnds(events);
  const methods = createMethods(events);
  const others = [ends, createHolding(events), createTiming(events)];
  const parts = [methods, ...others];
  const reset = button({
    label: 'Reset the motion to its state when opened',
    testId: 'motion-reset',
    icon: 'reset',
    onClick: () => events.onReset(),
  });
  const element = h(
    'section',
    { class: 'panel', id: 'panel-motion', 'aria-labelledby': 'motion-title', 'data-testid': 'panel-motion' },
    h('header', {}, h('h2', { id: 'motion-title' }, 'Motion'), reset),
    animation,
    ...methods.elements,
    options,
    ...others.flatMap(({ elements }) => elements),
  );
  const draw = memo((props: MotionPanelProps) => {
    for (const part of parts) part.update(props);
    const names = Object.keys(DEFAULT_MOTION) as (keyof Motion)[];
    setIdle(
      reset,
      names.every((name) => props.motion[name] === props.defaults[name]),
    );
  });
  return { element, update: draw, endAt: ends.endAt };
}

/** The method, and the compared methods. */
function createMethods({ onMotion, onCompare }: MotionPanelEvents): Fields<MotionPanelProps> {
  const method = select<Method>(
    'Method',
    'method',
    METHODS.map((value) => ({ value, ...METHOD_WORDS[value] })),
    (value) => onMotion({ method: value }),
    'M',
  );
  const hint = h('p', { class: 'hint', 'data-testid': 'method-hint' });
  let compared: readonly Method[] = [];
  const others = METHODS.map((value) => ({
    value,
    toggle: checkbox(METHOD_WORDS[value].short, `compare-${value}`, (on) => {
      onCompare(METHODS.filter((m) => (m === value ? on : compared.includes(m))));
    }),
  }));
  const most = h('p', { class: 'hint', 'data-testid': 'compare-most' }, 'At most four motions are shown at a time.');
  const comparison = h(
    'fieldset',
    { class: 'field' },
    h('legend', {}, 'Compare with'),
    h('div', { class: 'chips' }, ...others.map(({ toggle }) => toggle.element)),
    most,
  );
  return {
    elements: [method.element, hint, comparison],
    update({ motion, keys, compare, fitted, disabled }) {
      compared = compare;
      const departing = departsFromPaper({ motion, keys });
      method.update(motion.method);
      const where = fittedText(fitted);
      setText(hint, `${METHOD_WORDS[motion.method].hint}${where && ` Here ${where} between keys; see the warnings.`}`);
      const isFull = compared.filter((m) => m !== motion.method || departing).length >= MAX_COMPARED;
      setHidden(most, !isFull);
      for (const { value, toggle } of others) {
        const { short } = value === motion.method ? PLAIN_WORDS : METHOD_WORDS[value];
        setHidden(toggle.element, value === motion.method && !departing);
        setText(toggle.element.querySelector('span')!, short);
        const isShown = compared.includes(value);
        toggle.update(isShown, disabled || (isFull && !isShown));
      }
    },
  };
}

/** Parts held in place, automatically or by pins. */
function createHolding({ onMotion, onPlacing }: MotionPanelEvents): Fields<MotionPanelProps> {
  const hold = checkbox('Hold still parts', 'hold', (on) => onMotion({ hold: on ? 'on' : 'off' }));
  const holding = h('div', { class: 'group' }, hold.element, h('p', { class: 'hint' }, HOLD_HINT));
  const pins = createPinList({
    onPins: (list) => onMotion({ pins: list.length > 0 ? list : DEFAULT_MOTION.pins }),
    onPlacing,
  });
  return {
    elements: [holding, pins.element],
    update({ motion, keys, placing, disabled }) {
      const can = METHOD[motion.method].holds;
      hold.update(motion.hold === 'on');
      setHidden(holding, !can || keys.length < 3);
      setHidden(pins.element, !can);
      pins.update({ pins: motion.pins, keys, placing, periodic: motion.boundary === 'periodic', disabled });
    },
  };
}

/** Tension, spacing and order of the keys. */
function createTiming(events: MotionPanelEvents): Fields<MotionPanelProps> {
  const tightness = slider({
    label: 'Tightness',
    testId: 'tightness',
    hint: 'Tension of all keys. 0: smooth; 1: stops at each key, without overshoot; below 0: livelier',
    min: -1,
    max: 1,
    step: 0.05,
    fallback: DEFAULT_SHAPING.tension,
    onInput: (value) => events.onTightness(value),
  });
  const auto = button({
    label: 'Adds tension so that no slope exceeds three times the slope of a straight path to the next or previous key',
    testId: 'tightness-auto',
    text: 'Limit overshoot',
    onClick: () => events.onAutoTightness(),
  });
  const tight = h('div', { class: 'group' }, tightness.element, h('div', { class: 'button-row' }, auto));
  const spacings = SPACING_WORDS.map(({ value, text, hint }) =>
    button({ label: hint, testId: `space-${value}`, text, onClick: () => events.onSpacing(value) }),
  );
  const reverse = button({
    label: 'Run from the last key to the first, in the same time',
    testId: 'reverse',
    text: 'Reverse',
    onClick: () => events.onReverse(),
  });
  return {
    elements: [tight, buttonGroup('Space keys', ...spacings), buttonGroup('Direction', reverse)],
    update({ motion, tightness: mean }) {
      tightness.update(Number(mean.toFixed(3)));
      setHidden(tight, METHOD[motion.method].curve !== 'spline');
    },
  };
}
