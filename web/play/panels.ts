/** The controls beside the figures: choice of plots, and options of the shown curves. */
import { button, segments, select, slider } from '../ui/controls.ts';
import type { Component } from '../ui/dom.ts';
import { h, setHidden, setText } from '../ui/dom.ts';
import type { Spacing } from '../model/key-spacing.ts';
import { DEFAULT_SPEED, MAX_SPEED, SPEED_STEP, TYPED_SPEED } from '../model/speeds.ts';
import type { End } from '../plots/end-handle.ts';
import { ENDS_WORDS } from './figures/words.ts';
import type { Ends } from './splines/slopes.ts';
import type { PlayState } from './state.ts';
import { INITIAL, MAX_KEYS, MAX_SAMPLES, MIN_KEYS, MIN_SAMPLES } from './state.ts';

export interface PanelEvents {
  onPlane(plane: boolean): void;
  onAdd(): void;
  onRemoveSelected(): void;
  onSpacing(spacing: Spacing | 'hand'): void;
  onEnds(ends: Ends): void;
  onSamples(samples: number): void;
  onShaping(change: { tension?: number; bias?: number }): void;
  onSpeed(end: End, speed: number): void;
}

export type Panel = Component<PlayState>;

/** Controls above the curve: dimensions, keys, times. */
export function createTools(events: PanelEvents): Panel {
  const dimensions = segments(
    'Dimensions',
    'dimensions',
    [
      { value: 'line', label: 'One', hint: 'A value over time' },
      { value: 'plane', label: 'Two', hint: 'Two coordinates, plotted against each other' },
    ],
    (value) => events.onPlane(value === 'plane'),
  );
  const spacing = select<Spacing | 'hand'>(
    'Times of the keys',
    'spacing',
    [
      { value: 'hand', label: 'by hand' },
      { value: 'even', label: 'even' },
      { value: 'root', label: 'by square root of distance' },
      { value: 'difference', label: 'by distance' },
    ],
    events.onSpacing,
  );
  const add = button({
    label: 'Add a key',
    testId: 'add-key',
    icon: 'plus',
    text: 'Add',
    onClick: events.onAdd,
  });
  const remove = button({
    label: 'Delete the selected key',
    testId: 'remove-key',
    icon: 'trash',
    text: 'Delete',
    shortcut: 'Delete',
    onClick: events.onRemoveSelected,
  });
  return {
    element: h(
      'div',
      { class: 'tools' },
      dimensions.element,
      spacing.element,
      h('div', { class: 'tool-buttons', role: 'group', 'aria-label': 'Keys' }, add, remove),
    ),
    update(state) {
      dimensions.update(state.plane ? 'plane' : 'line');
      spacing.update(state.spacing);
      add.disabled = state.keys.length >= MAX_KEYS;
      remove.disabled = state.keys.length <= MIN_KEYS;
    },
  };
}

/** Controls below the list of curves: options of the shown curves. */
export function createCurveControls(events: PanelEvents): Panel {
  const samples = slider({
    label: 'Number of brute-force samples, K',
    testId: 'samples',
    first: MIN_SAMPLES,
    last: MAX_SAMPLES,
    step: 1,
    fallback: INITIAL.samples,
    onInput: events.onSamples,
  });
  const speed = (end: End, label: string, testId: string) =>
    slider({
      label,
      testId,
      first: 0,
      last: MAX_SPEED,
      max: TYPED_SPEED,
      step: SPEED_STEP,
      fallback: DEFAULT_SPEED,
      hint: 'Relative to the constant speed to the neighbouring key; 0 eases in or out',
      onInput: (value) => events.onSpeed(end, value),
    });
  const speeds = [
    speed('start', 'Speed at the first key', 'start-speed'),
    speed('end', 'Speed at the last key', 'end-speed'),
  ];
  const shaping = (name: 'tension' | 'bias', label: string, hint: string) =>
    slider({
      label,
      testId: name,
      first: -1,
      last: 1,
      step: 0.05,
      fallback: 0,
      hint,
      onInput: (value) => events.onShaping({ [name]: value }),
    });
  const tension = shaping('tension', 'Tension', '1 stops at the key; below 0, the curve passes it faster');
  const bias = shaping(
    'bias',
    'Bias',
    'Above 0: the slope follows the interval before the key more; below 0: the interval after it',
  );
  const selected = h('p', { class: 'selected-key', 'data-testid': 'selected-key' });
  const shaped = h('div', { class: 'control-group' }, selected, tension.element, bias.element);
  const ends = h('div', { class: 'control-group' }, ...speeds.map(({ element }) => element));
  return {
    element: h('div', { class: 'curve-controls' }, samples.element, ends, shaped),
    update(state) {
      const shows = (...layers: PlayState['layers']): boolean => layers.some((layer) => state.layers.includes(layer));
      const key = state.keys[state.selected]!;
      setHidden(samples.element, !shows('samples'));
      setHidden(ends, !(shows('hermite') || (shows('shaped') && state.ends === 'hermite')));
      setHidden(shaped, !shows('shaped'));
      samples.update(state.samples);
      speeds.forEach((control, end) => control.update(state.speeds[end]!));
      setText(selected, `Tension and bias at key ${state.selected + 1}. Click the dot of another key to select it`);
      tension.update(key.tension);
      bias.update(key.bias);
    },
  };
}

/** Controls above the system and the weights: their end conditions. */
export function createEndsChoice(events: PanelEvents): Panel {
  const { element, update } = segments<Ends>(
    'Ends',
    'ends',
    (Object.keys(ENDS_WORDS) as Ends[]).map((value) => ({ value, label: ENDS_WORDS[value] })),
    events.onEnds,
  );
  return { element, update: (state) => update(state.ends) };
}
