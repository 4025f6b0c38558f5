/** The playground's state as plain data, and pure edits of it. */
import { clamp } from '../model/time-scale.ts';
import type { Spacing } from '../model/key-spacing.ts';
import type { Ends } from './splines/slopes.ts';

export interface PlayKey {
  time: number;
  value: number;
  /** The second coordinate, drawn to the right in two dimensions. */
  across: number;
  /** Tension: 0 keeps the slope, 1 makes it zero. */
  tension: number;
  /**
   * Bias from -1 to 1. Negative values draw the slope at the key towards that of the interval after it, positive values
   * towards that of the interval before it.
   */
  bias: number;
}

export const LAYERS = ['linear', 'natural', 'samples', 'catmull-rom', 'hermite', 'periodic', 'shaped'] as const;
export type Layer = (typeof LAYERS)[number];

/** The last user action. */
export type LastAction = 'key' | 'plane' | 'spacing' | 'shaping' | 'speed' | 'samples' | 'time' | Layer;

/** A coordinate of a shape that is open in the app. */
export interface CoordinateSource {
  /** Id of the page with the shape. */
  from: string;
  shape: string;
  name: string;
  unit: string;
  /** Number of the shape's keys when taken. Times and ends can be sent back while it is unchanged. */
  keys: number;
}

export interface PlayState {
  keys: PlayKey[];
  layers: Layer[];
  /** Ends of the system, the weights, and the curve with tensions and biases. */
  ends: Ends;
  speeds: [number, number];
  /** Number K of samples in the direct minimisation. */
  samples: number;
  selected: number;
  time: number;
  /** Whether the playground has two dimensions. */
  plane: boolean;
  spacing: Spacing | 'hand';
  taken: CoordinateSource | null;
}

export const MIN_KEYS = 2;
export const MAX_KEYS = 12;
export const MIN_SAMPLES = 5;
export const MAX_SAMPLES = 60;
/** Smallest interval between two keys during dragging, relative to the whole time. */
const MIN_GAP = 0.02;
/** Shown time before and after the keys, relative to the whole. */
const MARGIN = 0.2;
/** Larger times and values are not shown. */
export const MAX_VALUE = 1e6;
/** Smallest time from the first to the last key, relative to the largest absolute time, or to 1 if that is smaller. */
const MIN_SPAN = 1e-3;
/** Smallest interval between two keys, relative to the whole time. Below it, slopes are mostly rounding errors. */
const MIN_SHARE = 1e-6;

const plain = (time: number, value: number, across: number): PlayKey => ({ time, value, across, tension: 0, bias: 0 });

export const INITIAL: Readonly<PlayState> = {
  keys: [plain(0, 0.2, 0), plain(0.25, 0.75, 0.15), plain(0.5, 0.35, 0.3), plain(0.75, 0.9, 1.4), plain(1, 0.5, 1.6)],
  layers: ['natural'],
  ends: 'natural',
  speeds: [1, 1],
  samples: 20,
  selected: 2,
  time: 0.4,
  plane: false,
  spacing: 'hand',
  taken: null,
};

/** First and last time of plots over time. */
export function shownTimes([start, end]: readonly [number, number]): [number, number] {
  return [start - MARGIN * (end - start), end + MARGIN * (end - start)];
}

/** The reason why these keys cannot be shown, or null. */
export function keysValidationError(keys: readonly PlayKey[]): string | null {
  if (keys.length < MIN_KEYS || keys.length > MAX_KEYS) return `there must be ${MIN_KEYS} to ${MAX_KEYS} keys`;
  const within = (most: number, ...numbers: number[]): boolean => numbers.every((one) => Math.abs(one) <= most);
  if (!keys.every(({ time, value, across }) => within(MAX_VALUE, time, value, across)))
    return `times and values must be numbers from ${-MAX_VALUE} to ${MAX_VALUE}`;
  if (!keys.every(({ tension, bias }) => within(1, tension, bias))) return 'tension and bias must be from -1 to 1';
  const times = keys.map(({ time }) => time);
  const span = times.at(-1)! - times[0]!;
  if (!(span >= MIN_SPAN * Math.max(1, ...times.map(Math.abs)))) return 'the last key must be later than the first';
  const close = times.findIndex((time, i) => i > 0 && !(time - times[i - 1]! >= MIN_SHARE * span));
  return close < 0 ? null : `key ${close + 1} must be later than key ${close}`;
}

export function withKey(state: PlayState, index: number, change: Partial<PlayKey>): PlayState {
  const changed = (key: PlayKey): PlayKey => {
    const { value, across, ...rest } = { ...key, ...change };
    return { ...rest, value: clamp(value, -MAX_VALUE, MAX_VALUE), across: clamp(across, -MAX_VALUE, MAX_VALUE) };
  };
  return { ...state, keys: state.keys.map((key, at) => (at === index ? changed(key) : key)) };
}

/** Changes a key's value and time; the time stays between its neighbours'. */
export function moveKey(state: PlayState, index: number, to: { time?: number; value: number }): PlayState {
  const { keys } = state;
  const key = keys[index];
  if (!key) return state;
  const { time } = to;
  if (time === undefined || state.spacing !== 'hand') return withKey(state, index, { value: to.value });
  const [before, after] = [keys[index - 1], keys[index + 1]];
  // The first and last key keep their times, so the whole time does not change.
  if (!before || !after) return withKey(state, index, { value: to.value });
  const gap = Math.min(MIN_GAP * (keys.at(-1)!.time - keys[0]!.time), (after.time - before.time) / 3);
  return withKey(state, index, { value: to.value, time: clamp(time, before.time + gap, after.time - gap) });
}

/** Adds a key halfway between the selected key and the next, or the previous one at the end. `at` gives its value. */
export function addKey(state: PlayState, at: (time: number) => { value: number; across: number }): PlayState {
  const { keys, selected } = state;
  if (keys.length >= MAX_KEYS) return state;
  const index = Math.min(selected, keys.length - 2);
  const time = (keys[index]!.time + keys[index + 1]!.time) / 2;
  const added = { time, ...at(time), tension: 0, bias: 0 };
  const more = [...keys.slice(0, index + 1), added, ...keys.slice(index + 1)];
  return keysValidationError(more) ? state : { ...state, keys: more, selected: index + 1, taken: null };
}

export function removeKey(state: PlayState, index: number): PlayState {
  if (state.keys.length <= MIN_KEYS || !state.keys[index]) return state;
  const keys = state.keys.filter((_, at) => at !== index);
  return { ...state, keys, selected: clamp(index, 0, keys.length - 1), taken: null };
}

export function showLayer(state: PlayState, layer: Layer, on: boolean): PlayState {
  const others = state.layers.filter((one) => one !== layer);
  return { ...state, layers: LAYERS.filter((one) => others.includes(one) || (on && one === layer)) };
}

/** Sets the ends and shows a curve that uses them. */
export function setEnds(state: PlayState, ends: Ends): PlayState {
  return showLayer({ ...state, ends }, ends, true);
}

/** Sets tension or bias of the selected key and shows the curve that uses them. */
export function setShaping(state: PlayState, change: Partial<Pick<PlayKey, 'tension' | 'bias'>>): PlayState {
  return showLayer(withKey(state, state.selected, change), 'shaped', true);
}
