/**
 * Whole frames of the motion's time: frame n is at time n / fps and frame 0 at time 0, as in any animation program.
 * Also the playing range. `fps` is null if the motion plays as smoothly as the screen allows.
 */
import type { KeysInfo } from '../engine/api/types.ts';
import { SAME_FRAME } from '../engine/api/whole-frames.ts';
import type { Range } from './time-scale.ts';
import { clamp, formatTime, length, reach, snap } from './time-scale.ts';

export const MIN_FPS = 0.01;
export const MAX_FPS = 1000;
/** Shorter ranges, relative to the whole, count as a single time. */
const SHORTEST = 1e-4;

export function frameAt(t: number, fps: number): number {
  const frame = t * fps;
  const whole = Math.round(frame);
  return Math.abs(frame - whole) <= SAME_FRAME ? whole : frame;
}

/** The frame shown at t: the last one that has begun, but not before `start`. */
export function frameStartTime(t: number, fps: number | null, start: number): number {
  return fps === null ? t : Math.max(Math.floor(frameAt(t, fps)) / fps, start);
}

/** Usual frame rates, the more usual ones first. */
const RATES = [30, 24, 25, 60, 50, 29.97, 23.976, 48, 15, 12, 120, 20, 100, 90, 59.94, 240] as const;

/** The frame rate of the animation that the keys were taken from; null if unknown. */
export function ownRate({ animation, animations }: Pick<KeysInfo, 'animation' | 'animations'>): number | null {
  const clip = animations[animation];
  const seconds = clip ? clip.end - clip.start : 0;
  if (!clip || !(seconds > 0)) return null;
  // One key per frame.
  const dense = (clip.keys - 1) / seconds;
  const found = RATES.find((rate) => Math.abs(dense / rate - 1) < 5e-4);
  const isWhole = (rate: number): boolean => Math.abs(seconds * rate - Math.round(seconds * rate)) < 0.01;
  return found ?? RATES.find((rate) => dense < rate && isWhole(rate)) ?? null;
}

export function nearestFrameTime(t: number, fps: number): number {
  return Math.round(t * fps) / fps;
}

/** The key within `near` of t, otherwise the nearest frame, if there are frames. */
export function snappedTime(t: number, keyTimes: readonly number[], near: number, fps: number | null): number {
  const key = snap(t, keyTimes, near);
  return key !== t || fps === null ? key : nearestFrameTime(t, fps);
}

/** The time `by` whole frames away. From between two frames, the first step goes to the adjacent frame. */
export function steppedFrameTime(t: number, fps: number, by: number): number {
  const frame = frameAt(t, fps);
  return ((by > 0 ? Math.floor(frame) : Math.ceil(frame)) + by) / fps;
}

/** A time as shown to users: seconds, or a frame number with two decimals between frames. */
export function formatMoment(t: number, range: Range, fps: number | null): string {
  return fps === null ? formatTime(t, range) : String(Number(frameAt(t, fps).toFixed(2)) + 0);
}

/** The time as shown to users, with its unit. */
export function momentWords(t: number, range: Range, fps: number | null): string {
  const moment = formatMoment(t, range, fps);
  return fps === null ? `${moment} s` : `frame ${moment}`;
}

/** The playing range: the chosen one, clipped to the slider, or the range of the keys. */
export function playRange(between: Range | null, range: Range): Range {
  return loopRange(between, range) ?? range;
}

/** The chosen range clipped to the slider; null if nothing is left. */
export function loopRange(between: Range | null, range: Range): Range | null {
  if (!between) return null;
  const [low, high] = reach(range);
  const inside: Range = [clamp(between[0], low, high), clamp(between[1], low, high)];
  return length(inside) > SHORTEST * length(range) ? inside : null;
}

/** The range with one end moved; the other end keeps a distance of at least `gap`. */
export function withEnd(between: Range | null, range: Range, end: 'start' | 'end', t: number, gap: number): Range {
  const [low, high] = reach(range);
  const [start, stop] = playRange(between, range);
  if (end === 'start') {
    const moved = clamp(t, low, high - gap);
    return [moved, Math.max(stop, moved + gap)];
  }
  const moved = clamp(t, low + gap, high);
  return [Math.min(start, moved - gap), moved];
}
