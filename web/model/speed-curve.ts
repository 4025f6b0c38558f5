/** Speed of a motion for its timeline: sample times, and drawing of the curve. */
import type { MotionSpeed } from '../engine/api/types.ts';
import type { Range } from './time-scale.ts';
import { length, timeScale } from './time-scale.ts';
import { fractionIn } from './time-window.ts';

/** Smallest reported overshoot beyond a key, relative to the mean distance of the keys. */
export const SEEN_OVERSHOOT = 0.01;

export interface SpeedCurve extends MotionSpeed {
  times: readonly number[];
  /** Mean speed from the first key to the last. */
  mean: number;
}

/** Number of samples in total, and the minimum between two keys. */
const SAMPLES = 240;
const MIN_SAMPLES = 6;
/** Distance from a key, relative to the range, where the speed of a piecewise linear motion jumps. */
const NEAR = 1e-7;

/** Increasing times that resolve the speed everywhere on the timeline, including both sides of every key. */
export function speedTimes(range: Range, keyTimes: readonly number[]): number[] {
  const [low, high] = timeScale(range, keyTimes.length).whole;
  const gap = NEAR * length(range);
  const ends = [...new Set([low, ...keyTimes, range[1], high])].sort((a, b) => a - b);
  return ends.slice(1).flatMap((end, i) => {
    const start = ends[i]!;
    if (end - start <= 4 * gap) return [];
    const steps = Math.max(Math.round((SAMPLES * (end - start)) / (high - low)), MIN_SAMPLES);
    const [from, to] = [start + gap, end - gap];
    return Array.from({ length: steps + 1 }, (_, step) => from + ((to - from) * step) / steps);
  });
}

export function speedCurveOf(times: readonly number[], { speed, overshoot }: MotionSpeed, range: Range): SpeedCurve {
  let area = 0;
  let span = 0;
  for (let i = 1; i < times.length; i += 1) {
    if (times[i - 1]! < range[0] || times[i]! > range[1]) continue;
    const step = times[i]! - times[i - 1]!;
    area += (step * (speed[i]! + speed[i - 1]!)) / 2;
    span += step;
  }
  return { times, speed, overshoot, mean: span > 0 ? area / span : 0 };
}

/** The speed at a time as a multiple of the mean, and whether the motion overshoots a key. */
export function speedAt(
  { times, speed, overshoot, mean }: SpeedCurve,
  t: number,
): { speed: number; past: boolean } | null {
  if (mean <= 0 || times.length === 0) return null;
  const after = times.findIndex((time) => time >= t);
  const i = after < 0 ? times.length - 1 : after;
  return { speed: speed[i]! / mean, past: overshoot[i]! > SEEN_OVERSHOOT };
}

export interface SpeedPaths {
  /** The speed over time. */
  line: string;
  /** Areas below the curve between the first and last key: all of it, and the overshoots. */
  area: string;
  past: string;
}

/** Height of the largest speed, relative to the plot. */
const TOP = 0.9;

export interface SpeedPicture {
  /** The range that the keys define. */
  range: Range;
  /** The visible part of the timeline. */
  part: Range;
  width: number;
  height: number;
}

/** The curve as SVG paths. */
export function speedPaths(curve: SpeedCurve, { range, part, width, height }: SpeedPicture): SpeedPaths {
  const fastest = Math.max(...curve.speed, 1e-300);
  const points = curve.times.map((t, i) => ({
    x: fractionIn(t, part) * width,
    y: height * (1 - (TOP * curve.speed[i]!) / fastest),
  }));
  const at = ({ x, y }: { x: number; y: number }): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
  const below = (run: typeof points): string =>
    `M${run[0]!.x.toFixed(1)} ${height}L${run.map(at).join('L')}L${run.at(-1)!.x.toFixed(1)} ${height}Z`;
  const within = points.filter((_, i) => curve.times[i]! >= range[0] && curve.times[i]! <= range[1]);
  const past = runsOf(curve.overshoot).map(([from, to]) => points.slice(from, to));
  return {
    line: points.length > 0 ? `M${points.map(at).join('L')}` : '',
    area: within.length > 0 ? below(within) : '',
    past: past.map(below).join(''),
  };
}

/** Index ranges (end exclusive) of runs of times that overshoot a key, including their neighbours. */
function runsOf(overshoot: readonly number[]): [number, number][] {
  const runs: [number, number][] = [];
  overshoot.forEach((value, i) => {
    if (value <= SEEN_OVERSHOOT) return;
    const last = runs.at(-1);
    if (last && last[1] >= i) last[1] = i + 1;
    else runs.push([i, i + 1]);
  });
  return runs.filter(([from, to]) => to - from > 1);
}
