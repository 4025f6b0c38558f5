/** The slider's scale, snapping, stepping, and the position of a time among the keys. */
import { keyLabel, lowerFirst } from './key-names.ts';

/** Margin of the default timeline beyond either end, as a share of the mean key interval. */
export const MARGIN = 0.8;
/** Zooming and typed times are limited to this many lengths of the motion beyond its ends. */
const FURTHEST = 2;
/** Times closer than this share of the range are equal. */
export const SAME_TIME = 1e-6;

export type Range = readonly [number, number];

export function length(range: Range): number {
  return range[1] - range[0];
}

/** The range of the keys, and the whole range of the timeline when not zoomed. */
export interface TimeScale {
  range: Range;
  whole: Range;
}

export function timeScale(range: Range, keys: number): TimeScale {
  return { range, whole: widened(range, MARGIN / Math.max(keys - 1, 1)) };
}

/** Lowest and highest allowed time. */
export function reach(range: Range): Range {
  return widened(range, FURTHEST);
}

function widened(range: Range, share: number): Range {
  const margin = share * length(range);
  return [range[0] - margin, range[1] + margin];
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}

export function clampTime(t: number, range: Range): number {
  const [low, high] = reach(range);
  return clamp(t, low, high);
}

/** The key time within `reach` of t, or t itself. */
export function snap(t: number, keyTimes: readonly number[], reach: number): number {
  const near = nearestKey(t, keyTimes);
  const keyTime = keyTimes[near];
  return keyTime !== undefined && Math.abs(keyTime - t) <= reach ? keyTime : t;
}

/** Index of the key nearest in time, -1 without keys. */
export function nearestKey(t: number, keyTimes: readonly number[]): number {
  let best = -1;
  let bestDistance = Infinity;
  keyTimes.forEach((keyTime, index) => {
    const distance = Math.abs(keyTime - t);
    if (distance < bestDistance) {
      best = index;
      bestDistance = distance;
    }
  });
  return best;
}

/** The next key time after t, or the previous one before it; t itself if there is none. */
export function neighbourKey(t: number, keyTimes: readonly number[], direction: 1 | -1, range: Range): number {
  const gap = SAME_TIME * length(range);
  const candidates = keyTimes.filter((keyTime) => (keyTime - t) * direction > gap);
  if (candidates.length === 0) return t;
  return direction > 0 ? Math.min(...candidates) : Math.max(...candidates);
}

/** Keeps a dragged key strictly between its neighbours; the outermost keys can move outwards freely. */
export function clampKeyTime(times: readonly number[], index: number, wanted: number): number {
  const gap = ((times.at(-1) ?? 1) - (times[0] ?? 0)) * 0.01;
  const low = times[index - 1];
  const high = times[index + 1];
  return clamp(wanted, low === undefined ? -Infinity : low + gap, high === undefined ? Infinity : high - gap);
}

/** `off`: not on the curve. */
export type PhaseKind = 'key' | 'between' | 'beyond' | 'off';

/** The paper's colours for the phases, as in the style sheet. */
export const PHASE_COLOURS: Record<PhaseKind, string> = {
  key: '#0072b2',
  between: '#009e73',
  beyond: '#e69f00',
  off: '#8f8f8f',
};

/** Position of a time among the keys; `kind` selects the colour, `text` describes it. */
export interface Phase {
  kind: PhaseKind;
  text: string;
}

export const OFF_CURVE: Phase = { kind: 'off', text: 'Off the curve: a mixture of the keys' };

export interface PhaseInput {
  t: number;
  keys: readonly { time: number; name: string }[];
  range: Range;
  /** A closed motion repeats outside its range instead of being extrapolated. */
  periodic: boolean;
  /** Distance from a key that counts as being at it, relative to the range. */
  tolerance?: number;
}

export function phaseOf({ t, keys, range, periodic, tolerance = SAME_TIME }: PhaseInput): Phase {
  const reach = tolerance * length(range);
  const inside = periodic ? wrap(t, range) : t;
  const times = keys.map((key) => key.time);
  const near = nearestKey(inside, times);
  const key = keys[near];
  if (key && Math.abs(key.time - inside) <= reach) {
    return { kind: 'key', text: `At ${lowerFirst(keyLabel(near, key.name))}` };
  }
  const first = times[0] ?? 0;
  const last = times.at(-1) ?? 1;
  if (!periodic && inside < first) {
    return { kind: 'beyond', text: 'Before the first key (extrapolated)' };
  }
  if (!periodic && inside > last) {
    return { kind: 'beyond', text: 'Beyond the last key (extrapolated)' };
  }
  const before = times.filter((time) => time <= inside).length;
  const after = before >= times.length ? 1 : before + 1;
  return { kind: 'between', text: `Between keys ${Math.max(before, 1)} and ${after}` };
}

/** Maps t into the range by whole periods. The end of the range is unchanged. */
export function wrap(t: number, range: Range): number {
  const period = length(range);
  if (period <= 0 || (t >= range[0] && t <= range[1])) return t;
  return range[0] + ((((t - range[0]) % period) + period) % period);
}

/** A time for users: up to three decimals, as many as are significant in this range. */
export function formatTime(t: number, range: Range = [0, 1]): string {
  const size = Math.max(length(range), 1e-9);
  const decimals = clamp(Math.ceil(3 - Math.log10(size) - 1e-9), 0, 6);
  const text = t.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text;
}

/** Evenly spaced times over the whole timeline when not zoomed, and the times of the keys. */
export function plottedTimes(range: Range, keyTimes: readonly number[], count: number): number[] {
  const [low, high] = timeScale(range, keyTimes.length).whole;
  const gap = length(range) * 1e-6;
  const even = Array.from({ length: count }, (_, index) => low + ((high - low) * index) / (count - 1));
  return [...even.filter((t) => keyTimes.every((key) => Math.abs(key - t) > gap)), ...keyTimes].sort((a, b) => a - b);
}
