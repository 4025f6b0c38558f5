/** The visible window of the timeline: the motion with its margins, a part of it, or more. */
import type { Range, TimeScale } from './time-scale.ts';
import { clamp, length, reach } from './time-scale.ts';

/** Largest zoom factor of the timeline. */
export const MAX_ZOOM = 200;

/** The requested window, clipped to the allowed times, or the whole. */
export function windowOf(wanted: Range | null, { range, whole }: TimeScale): Range {
  if (!wanted) return whole;
  const furthest = reach(range);
  const size = clamp(length(wanted), length(whole) / MAX_ZOOM, length(furthest));
  const start = clamp(wanted[0], furthest[0], furthest[1] - size);
  return [start, start + size];
}

/** Position of t in the window: 0 at the left end, 1 at the right, outside [0, 1] beyond them. */
export function fractionIn(t: number, window: Range): number {
  return (t - window[0]) / length(window);
}

export function timeIn(fraction: number, window: Range): number {
  return window[0] + fraction * length(window);
}

/**
 * The window scaled by `factor` around t. Zooming out pauses at the whole range (null) and then continues to the
 * largest window.
 */
export function zoomed(window: Range, scale: TimeScale, factor: number, t: number): Range | null {
  const { whole, range } = scale;
  const zoomedIn = length(window) < length(whole) * (1 - NEARLY);
  const most = length(zoomedIn ? whole : reach(range));
  const size = clamp(length(window) / factor, length(whole) / MAX_ZOOM, most);
  if (zoomedIn && size >= most * (1 - NEARLY)) return null;
  const start = t - fractionIn(t, window) * size;
  return orNull([start, start + size], scale);
}

/** The window moved in time, within the allowed times. */
export function panned(window: Range, scale: TimeScale, by: number): Range | null {
  return orNull([window[0] + by, window[1] + by], scale);
}

/** The window moved by the least amount that makes t visible, or by a page if t leaves it during playback. */
export function revealing(window: Range, scale: TimeScale, t: number): Range | null {
  if (t >= window[0] && t <= window[1]) return orNull(window, scale);
  const lead = 0.05 * length(window);
  return panned(window, scale, t > window[1] ? t - lead - window[0] : t + lead - window[1]);
}

/** The window enlarged by the least amount that makes t visible; null if the whole is shown. */
export function including(window: Range, scale: TimeScale, t: number): Range | null {
  if (t >= window[0] && t <= window[1]) return orNull(window, scale);
  const [start, end] = [Math.min(window[0], t), Math.max(window[1], t)];
  const lead = 0.05 * (end - start);
  return orNull([t < window[0] ? start - lead : start, t > window[1] ? end + lead : end], scale);
}

/** Relative tolerance for equal lengths. */
const NEARLY = 1e-9;

function orNull(window: Range, scale: TimeScale): Range | null {
  const shown = windowOf(window, scale);
  const near = NEARLY * length(scale.whole);
  const same = scale.whole.every((end, side) => Math.abs(end - shown[side as 0 | 1]) <= near);
  return same ? null : shown;
}

/** Round marks in seconds or whole frames along the window. */
export function rulerMarks(window: Range, fps: number | null, most: number): { time: number; text: string }[] {
  const unit = fps ?? 1;
  const numbers = ruler([window[0] * unit, window[1] * unit], most).filter((n) => fps === null || Number.isInteger(n));
  const decimals = Math.max(Math.ceil(-Math.log10((numbers[1] ?? 1) - (numbers[0] ?? 0)) - 1e-9), 0);
  const text = (n: number): string => `${(n + 0).toFixed(decimals)}${fps === null ? ' s' : ''}`;
  return numbers.map((n) => ({ time: n / unit, text: text(n) }));
}

/** At most `most` round numbers along the window, spaced by 1, 2 or 5 times a power of ten. */
export function ruler(window: Range, most: number): number[] {
  const rough = length(window) / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((times) => times * power >= rough * (1 - 1e-9)) ?? 10);
  const first = Math.ceil(window[0] / step - 1e-9);
  const count = Math.floor(window[1] / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(count, 0) }, (_, index) => (first + index) * step);
}
