/** Interpolation of the keys: method, compared motions, and boundary. */
import { METHODS } from '../engine/api/methods.ts';
import { hasEffect } from '../engine/api/rules.ts';
import type { Method } from '../engine/api/types.ts';
import type { Motion } from '../model/state.ts';
import type { Spacing } from '../model/key-spacing.ts';
import { METHOD_WORDS, PLAIN_WORDS, fittedText } from '../model/method-words.ts';
import { DEFAULT_SHAPING } from '../model/shaping.ts';
import { departsFromPaper } from '../model/spline-options.ts';
import { DEFAULT_MOTION, MAX_COMPARED } from '../model/state.ts';
import { button, buttonGroup, checkbox, panelSection, slider } from './controls.ts';
import type { MotionEnds, MotionEndsEvents, MotionEndsProps } from './motion-ends.ts';
import { createMotionEnds } from './motion-ends.ts';
import { fillPanel, numberBounds, optionField } from './option-field.ts';
import type { OptionPanelProps } from './option-field.ts';
import { createPinList } from './pin-list.ts';
import type { Component } from './dom.ts';
import { group, h, setHidden, setText } from './dom.ts';

const SPACING_WORDS: readonly { value: Spacing; text: string; hint: string }[] = [
  { value: 'even', text: 'Evenly', hint: 'Intervals of equal length' },
  { value: 'root', text: 'Softly', hint: 'Intervals proportional to the square root of pose difference' },
  {
    value: 'difference',
    text: 'By pose difference',
    hint: 'Intervals proportional to pose difference: nearly constant speed',
  },
];

export interface MotionPanelProps extends MotionEndsProps, OptionPanelProps<Motion> {
  compare: readonly Method[];
  /** The intervals between keys where the shown motion has fitted shapes; null if it fits none. */
  fitted: readonly boolean[] | null;
  /** The next click on the shape pins that vertex. */
  placing: boolean;
  /** Mean tension of the keys. */
  tightness: number;
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
  const panel = fillPanel<'motion', MotionPanelProps>(panelSection('Motion'), 'motion', events.onReset, [
    animation,
    optionField('method', events.onMotion, ({ fitted }) => {
      const where = fittedText(fitted);
      return { note: where && ` Here ${where} between keys; see the warnings.` };
    }),
    createComparison(events),
    options,
    ends,
    createHolding(events),
    createTightness(events),
    createTiming(events),
  ]);
  return { ...panel, endAt: ends.endAt };
}

/** The compared methods. */
function createComparison({ onCompare }: MotionPanelEvents): Component<MotionPanelProps> {
  let compared: readonly Method[] = [];
  const others = METHODS.map((value) => ({
    value,
    toggle: checkbox(METHOD_WORDS[value].short, `compare-${value}`, (on) => {
      onCompare(METHODS.filter((m) => (m === value ? on : compared.includes(m))));
    }),
  }));
  const most = h('p', { class: 'hint', 'data-testid': 'compare-most' }, 'At most four motions are shown at a time.');
  return {
    element: h(
      'fieldset',
      { class: 'field' },
      h('legend', {}, 'Compare with'),
      h('div', { class: 'chips' }, ...others.map(({ toggle }) => toggle.element)),
      most,
    ),
    update({ motion, keys, compare, disabled }) {
      compared = compare;
      const departing = departsFromPaper({ motion, keys });
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
function createHolding({ onMotion, onPlacing }: MotionPanelEvents): Component<MotionPanelProps> {
  const hold = group<MotionPanelProps>([optionField('hold', onMotion)], ({ keys }) => keys.length > 2);
  const pins = createPinList({
    onPins: (list) => onMotion({ pins: list.length > 0 ? list : DEFAULT_MOTION.pins }),
    onPlacing,
  });
  const list: Component<MotionPanelProps> = {
    element: pins.element,
    update: ({ motion, ...props }) =>
      pins.update({ ...props, pins: motion.pins, periodic: motion.boundary === 'periodic' }),
  };
  return group([hold, list], ({ motion }) => hasEffect('pins', motion), 'rows');
}

/** The tension of all keys. */
function createTightness({ onTightness, onAutoTightness }: MotionPanelEvents): Component<MotionPanelProps> {
  const { element, update } = slider({
    ...numberBounds('tension'),
    label: 'Tightness',
    testId: 'tightness',
    hint: 'Tension of all keys. 0: smooth; 1: stops at each key, without overshoot; below 0: livelier',
    first: -1,
    last: 1,
    fallback: DEFAULT_SHAPING.tension,
    onInput: onTightness,
  });
  const auto = button({
    label: 'Adds tension so that no slope exceeds three times the slope of a straight path to the next or previous key',
    testId: 'tightness-auto',
    text: 'Limit overshoot',
    onClick: onAutoTightness,
  });
  return group<MotionPanelProps>(
    [{ element, update: (props) => update(props.tightness) }, h('div', { class: 'button-row' }, auto)],
    ({ motion }) => hasEffect('tension', motion),
  );
}

/** Spacing and order of the keys. */
function createTiming({ onSpacing, onReverse }: MotionPanelEvents): HTMLElement {
  const spacings = SPACING_WORDS.map(({ value, text, hint }) =>
    button({ label: hint, testId: `space-${value}`, text, onClick: () => onSpacing(value) }),
  );
  const reverse = button({
    label: 'Run from the last key to the first, in the same time',
    testId: 'reverse',
    text: 'Reverse',
    onClick: onReverse,
  });
  return h('div', { class: 'rows' }, buttonGroup('Space keys', ...spacings), buttonGroup('Direction', reverse));
}
