/** How the keys are joined: the method, what stands beside it, and the boundary with what it asks for. */
import { METHOD, METHODS } from '../engine/api/methods.ts';
import type { Boundary, Method } from '../engine/api/types.ts';
import type { Encoding, KeyRef, Motion } from '../model/state.ts';
import type { Spacing } from '../model/key-spacing.ts';
import type { End, Speeds } from '../model/speeds.ts';
import { keyLabel } from '../model/key-names.ts';
import type { DropPoint } from './file-drop.ts';
import { METHOD_WORDS, PLAIN_WORDS } from '../model/method-words.ts';
import { DEFAULT_SHAPING } from '../model/shaping.ts';
import { DEFAULT_SPEED, MAX_SPEED, SPEED_STEP, TANGENT_NAME, TYPED_SPEED } from '../model/speeds.ts';
import { BOUNDARIES, DEFAULT_MOTION, holds } from '../model/state.ts';
import { button, checkbox, numberField, segments, select, slider } from './controls.ts';
import { createPinList } from './pin-list.ts';
import { h, memo, setAttribute, setField, setHidden, setText } from './dom.ts';

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

const HOLD_HINT =
  'What hardly moves between two keys stays where it is, as feet do. Off: the method as published, in which they can slide.';

const SPACING_WORDS: readonly { value: Spacing; text: string; hint: string }[] = [
  { value: 'even', text: 'Evenly', hint: 'Intervals of equal length' },
  { value: 'root', text: 'Softly', hint: 'Intervals as the square root of how different the poses are' },
  { value: 'difference', text: 'By difference', hint: 'Intervals as how different the poses are: an even pace' },
];

/** What no pose is called. */
const FROM_FILE = 'file';

export interface MotionPanelProps {
  motion: Motion;
  encoding: Encoding;
  compare: readonly Method[];
  /** The fastest on offer at the ends. */
  mostSpeeds: Speeds;
  keys: readonly KeyRef[];
  /** Of any shape that was opened, a key or not. */
  poseName: (pose: number) => string;
  /** The next click on the shape pins it there. */
  placing: boolean;
  /** Mean tension of the keys. */
  tightness: number;
  /** The default period, for the field's placeholder. */
  period: number;
  disabled: boolean;
  /** What the reset button goes back to. */
  defaults: Motion;
}

export interface MotionPanelEvents {
  onMotion(change: Partial<Motion>): void;
  onSpeed(end: End, speed: number): void;
  onEncoding(change: Partial<Encoding>): void;
  /** A file is to be chosen whose shape gives the end tangent. */
  onTangentFile(end: End): void;
  onCompare(methods: Method[]): void;
  onPlacing(placing: boolean): void;
  /** The same tension for every key. */
  onTightness(tension: number): void;
  /** As much as keeps the slope at each key within its bound. */
  onAutoTightness(): void;
  onSpacing(spacing: Spacing): void;
  /** The motion is to run from its end to its beginning. */
  onReverse(): void;
  onReset(): void;
}

/** `animation`: where the keys come from, on top of it. */
export function createMotionPanel(
  events: MotionPanelEvents,
  animation: HTMLElement,
): {
  element: HTMLElement;
  update(props: MotionPanelProps): void;
  /** The end whose tangent is asked for at this place of the page, or null. */
  endAt(at: DropPoint): End | null;
} {
  const method = select<Method>(
    'Method',
    'method',
    METHODS.map((value) => ({ value, ...METHOD_WORDS[value] })),
    (value) => events.onMotion({ method: value }),
    'M',
  );
  const methodHint = h('p', { class: 'hint', 'data-testid': 'method-hint' });
  let compared: readonly Method[] = [];
  const others = METHODS.map((value) => ({
    value,
    toggle: checkbox(METHOD_WORDS[value].short, `compare-${value}`, (on) => {
      events.onCompare(METHODS.filter((m) => (m === value ? on : compared.includes(m))));
    }),
  }));
  const boundary = segments<Boundary>(
    'Ends',
    'boundary',
    BOUNDARIES.map((value) => ({ value, ...BOUNDARY_WORDS[value] })),
    (value) => events.onMotion({ boundary: value }),
  );
  const boundaryHint = h('p', { class: 'hint' });
  const start = speedSlider('Start speed', 'start-speed', (value) => events.onSpeed('start', value));
  const end = speedSlider('End speed', 'end-speed', (value) => events.onSpeed('end', value));
  const tangents = {
    start: tangentSelect('Leaves the first key towards', 'start', events),
    end: tangentSelect('Arrives at the last key from', 'end', events),
  };
  const hermite = h(
    'div',
    { class: 'group' },
    start.element,
    end.element,
    tangents.start.element,
    tangents.end.element,
  );
  const period = numberField({
    label: 'Period',
    testId: 'period',
    min: 1e-6,
    onInput: (value) => events.onMotion({ period: value }),
  });
  const periodReset = button({
    label: 'Reset the period',
    testId: 'period-reset',
    icon: 'reset',
    onClick: () => events.onMotion({ period: null }),
  });
  const periodic = h('div', { class: 'field row' }, h('span', { class: 'label' }, 'Period'), period, periodReset);
  const hold = checkbox('Hold what rests', 'hold', (on) => events.onMotion({ hold: on ? 'on' : 'off' }));
  const pins = createPinList({
    onPins: (list) => events.onMotion({ pins: list.length > 0 ? list : DEFAULT_MOTION.pins }),
    onPlacing: events.onPlacing,
  });
  const holding = h('div', { class: 'group' }, hold.element, h('p', { class: 'hint' }, HOLD_HINT));
  const tightness = slider({
    label: 'Tightness',
    testId: 'tightness',
    hint: 'Tension of all keys: 0 passes them smoothly, to the right with less overshoot, stopping at each at 1; to the left livelier',
    min: -1,
    max: 1,
    step: 0.05,
    fallback: DEFAULT_SHAPING.tension,
    onInput: (value) => events.onTightness(value),
  });
  const auto = button({
    label:
      'Tension at each key as much as keeps its slope within three times that of the straight way to either neighbour',
    testId: 'tightness-auto',
    text: 'Limit overshoot',
    onClick: () => events.onAutoTightness(),
  });
  const tight = h('div', { class: 'group' }, tightness.element, h('div', { class: 'button-row' }, auto));
  const spacing = h(
    'div',
    { class: 'field', role: 'group', 'aria-label': 'Space keys' },
    h('span', { class: 'label' }, 'Space keys'),
    h(
      'div',
      { class: 'button-row' },
      ...SPACING_WORDS.map(({ value, text, hint }) =>
        button({ label: hint, testId: `space-${value}`, text, onClick: () => events.onSpacing(value) }),
      ),
    ),
  );
  const reverse = button({
    label: 'Run from the last key to the first, in the same time',
    testId: 'reverse',
    text: 'Reverse',
    onClick: () => events.onReverse(),
  });
  const direction = h(
    'div',
    { class: 'field', role: 'group', 'aria-label': 'Direction' },
    h('span', { class: 'label' }, 'Direction'),
    h('div', { class: 'button-row' }, reverse),
  );
  const reset = button({
    label: 'Reset the motion to what it was when opened',
    testId: 'motion-reset',
    icon: 'reset',
    onClick: () => events.onReset(),
  });
  const element = h(
    'section',
    { class: 'panel', 'aria-labelledby': 'motion-title', 'data-testid': 'panel-motion' },
    h('header', {}, h('h2', { id: 'motion-title' }, 'Motion'), reset),
    animation,
    method.element,
    methodHint,
    h(
      'fieldset',
      { class: 'field' },
      h('legend', {}, 'Compare with'),
      h('div', { class: 'chips' }, ...others.map((o) => o.toggle.element)),
    ),
    boundary.element,
    boundaryHint,
    hermite,
    periodic,
    holding,
    pins.element,
    tight,
    spacing,
    direction,
  );

  const draw = memo((props: MotionPanelProps) => {
    const { motion } = props;
    compared = props.compare;
    method.update(motion.method);
    setText(methodHint, METHOD_WORDS[motion.method].hint);
    for (const { value, toggle } of others) {
      setHidden(toggle.element, value === motion.method && !holds(motion));
      setText(
        toggle.element.querySelector('span')!,
        value === motion.method ? PLAIN_WORDS.short : METHOD_WORDS[value].short,
      );
      toggle.update(compared.includes(value), props.disabled);
    }
    boundary.update(
      motion.boundary,
      METHOD[motion.method].curve === 'polygon'
        ? { hermite: 'Ease sets speeds at the ends; this method moves straight from key to key.' }
        : {},
    );
    hold.update(motion.hold === 'on');
    setHidden(holding, !METHOD[motion.method].holds || props.keys.length < 3);
    setHidden(pins.element, !METHOD[motion.method].holds);
    const { keys, placing, disabled } = props;
    pins.update({ pins: motion.pins, keys, placing, periodic: motion.boundary === 'periodic', disabled });
    setText(boundaryHint, BOUNDARY_WORDS[motion.boundary].hint);
    setHidden(hermite, motion.boundary !== 'hermite');
    setHidden(periodic, motion.boundary !== 'periodic');
    start.update(motion.startSpeed, undefined, props.mostSpeeds.start);
    end.update(motion.endSpeed, undefined, props.mostSpeeds.end);
    tangents.start.update(props, props.encoding.startTangentPose, 'the next key');
    tangents.end.update(props, props.encoding.endTangentPose, 'the key before');
    tightness.update(Number(props.tightness.toFixed(3)));
    setHidden(tight, METHOD[motion.method].curve === 'polygon');
    setField(period, String(Number((motion.period ?? props.period).toFixed(4))));
    periodReset.disabled = motion.period === null;
    setAttribute(periodReset, 'data-idle', motion.period === null);
    const touched = (Object.keys(DEFAULT_MOTION) as (keyof Motion)[]).some(
      (key) => motion[key] !== props.defaults[key],
    );
    reset.disabled = !touched;
    setAttribute(reset, 'data-idle', !touched);
  });
  return {
    element,
    update: draw,
    endAt({ x, y }) {
      const [under] = document.elementsFromPoint(x, y).filter((one) => hermite.contains(one));
      return (under && (['start', 'end'] as const).find((end) => tangents[end].element.contains(under))) ?? null;
    },
  };
}

function speedSlider(label: string, testId: string, onInput: (value: number) => void): ReturnType<typeof slider> {
  return slider({
    label,
    testId,
    min: 0,
    max: MAX_SPEED,
    typedMax: TYPED_SPEED,
    step: SPEED_STEP,
    fallback: DEFAULT_SPEED,
    onInput,
    format: (value) => `${Number(value.toFixed(2))}`,
    hint: 'Relative to the straight speed towards the neighbour, or the shape of the tangent; 0 eases. Any can be typed',
  });
}

/** A shape for the tangent at an end: the neighbour, another key, or one of a file. */
function tangentSelect(
  label: string,
  end: End,
  { onEncoding, onTangentFile }: Pick<MotionPanelEvents, 'onEncoding' | 'onTangentFile'>,
): {
  element: HTMLElement;
  update(props: Pick<MotionPanelProps, 'keys' | 'poseName'>, pose: number | null, none: string): void;
} {
  let shown = '';
  const field = select<string>(label, `${end}-tangent`, [], (value) => {
    if (value !== FROM_FILE) return onEncoding({ [TANGENT_NAME[end]]: value === '' ? null : Number(value) });
    // Until there is one, the choice is what it was.
    field.update(shown);
    onTangentFile(end);
  });
  return {
    element: field.element,
    update({ keys, poseName }, pose, none) {
      shown = String(pose ?? '');
      const other = pose !== null && keys.every((key) => key.pose !== pose);
      field.update(shown, [
        { value: '', label: none },
        ...keys.map((key, index) => ({ value: String(key.pose), label: keyLabel(index, key.name) })),
        ...(other ? [{ value: shown, label: poseName(pose) }] : []),
        { value: FROM_FILE, label: 'a shape from a file…' },
      ]);
    },
  };
}
