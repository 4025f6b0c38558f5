/** The stretch of time that the slider shows: all that it reaches, or a part of it, as when one zooms into a map. */
import type { Range } from './time-scale.ts';
import { clamp, length, limits } from './time-scale.ts';

/** How many times larger than the whole the slider can show a part. */
export const MAX_ZOOM = 200;

/** The window that is shown: the wanted one as far as the slider reaches, or everything. */
export function windowOf(wanted: Range | null, range: Range): Range {
  const whole = limits(range);
  if (!wanted) return whole;
  const size = clamp(length(wanted), length(whole) / MAX_ZOOM, length(whole));
  const start = clamp(wanted[0], whole[0], whole[1] - size);
  return [start, start + size];
}

/** Where t lies in the window: 0 at its left end, 1 at its right, less or more outside. */
export function fractionIn(t: number, window: Range): number {
  return (t - window[0]) / length(window);
}

export function timeIn(fraction: number, window: Range): number {
  return window[0] + fraction * length(window);
}

/** The window made `factor` times larger, t staying where it is; null once everything is shown. */
export function zoomed(window: Range, range: Range, factor: number, t: number): Range | null {
  const whole = limits(range);
  const size = clamp(length(window) / factor, length(whole) / MAX_ZOOM, length(whole));
  const start = t - fractionIn(t, window) * size;
  return orNull([start, start + size], range);
}

/** The window moved by a stretch of time, as far as the slider reaches. */
export function panned(window: Range, range: Range, by: number): Range | null {
  return orNull([window[0] + by, window[1] + by], range);
}

/** The window moved just far enough to hold t; a page further where t runs out of it. */
export function revealing(window: Range, range: Range, t: number): Range | null {
  if (t >= window[0] && t <= window[1]) return orNull(window, range);
  const lead = 0.05 * length(window);
  return panned(window, range, t > window[1] ? t - lead - window[0] : t + lead - window[1]);
}

function orNull(window: Range, range: Range): Range | null {
  const shown = windowOf(window, range);
  return length(shown) >= length(limits(range)) * (1 - 1e-9) ? null : shown;
}

/** Round places for numbers along the window, at most `most` of them: 1, 2 or 5 times a power of ten apart. */
export function ruler(window: Range, most: number): number[] {
  const rough = length(window) / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((times) => times * power >= rough * (1 - 1e-9)) ?? 10);
  const first = Math.ceil(window[0] / step - 1e-9);
  const count = Math.floor(window[1] / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(count, 0) }, (_, index) => (first + index) * step);
}
