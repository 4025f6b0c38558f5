/** Times of the keys taken from an animation, in seconds of its own timeline. */
import { MAX_SAMPLED } from '../engine/api/option-table.ts';
import type { AnimationInfo, KeysInfo } from '../engine/api/types.ts';
import { clamp } from './time-scale.ts';

export type Span = Pick<AnimationInfo, 'start' | 'end'>;

export function evenTimes({ start, end }: Span, count: number): number[] {
  return Array.from({ length: count }, (_, i) => (i === count - 1 ? end : start + ((end - start) * i) / (count - 1)));
}

export function sameTimes(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((t, index) => Math.abs(t - b[index]!) < 1e-6);
}

export function shortTime(t: number): string {
  return String(Number(t.toFixed(4)));
}

/** Whether the keys are from the animation, rather than compared with it. */
export function areSampled({ animation, animations, times }: KeysInfo): boolean {
  const span = animations[animation];
  return span !== undefined && times.length <= MAX_SAMPLED && times.every((t) => t >= span.start && t <= span.end);
}

/** The times in a list, or the problem with it. */
export function readTimes(text: string, { start, end }: Span): number[] | string {
  const times = text
    .split(/[\s,;]+/)
    .filter((word) => word !== '')
    .map(Number);
  const unread = times.findIndex((t) => !Number.isFinite(t));
  if (unread >= 0) return `Time ${unread + 1} of the list is not a number. Separate the times with commas.`;
  const slack = 1e-4; // shown times are rounded
  const outside = times.find((t) => t < start - slack || t > end + slack);
  if (outside !== undefined)
    return `${shortTime(outside)} s is outside the animation, which runs from ${shortTime(start)} to ${shortTime(end)} s.`;
  if (new Set(times).size < 2) return 'Give at least two times.';
  if (times.length > MAX_SAMPLED) return `Give at most ${MAX_SAMPLED} times.`;
  return times.map((t) => clamp(t, start, end));
}
