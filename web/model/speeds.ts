/**
 * The Hermite speeds as offered by the page, in multiples of the constant speed between the first two or the last two
 * keys. An end tangent's shape replaces the neighbour. 0 eases.
 */
import { MOTION } from '../engine/api/option-table.ts';
import { DEFAULT_MOTION } from './state.ts';
import { clamp } from './time-scale.ts';

export type End = 'start' | 'end';

export const SPEED_NAME = { start: 'startSpeed', end: 'endSpeed' } as const;
export const TANGENT_NAME = { start: 'startTangentPose', end: 'endTangentPose' } as const;
export const DEFAULT_SPEED = DEFAULT_MOTION.startSpeed;
export const MAX_SPEED = 4;
export const SPEED_STEP = 0.05;
/** Limit for offered speeds, even if a tangent's shape is very close. Faster ones can be typed. */
const FASTEST = 10 * MAX_SPEED;

/** Largest speed that can be typed, as in the engine. */
export const TYPED_SPEED = MOTION.startSpeed.max;

export type Speeds = Readonly<Record<End, number>>;

/** Largest speed offered by handles and sliders if neighbours give the tangents. */
export const USUAL_MAX_SPEEDS: Speeds = { start: MAX_SPEED, end: MAX_SPEED };

/**
 * Largest speed offered at a key: equal to `MAX_SPEED` towards the neighbour if the tangent's shape is closer than the
 * neighbour. Distances from the key, in one unit; shape null: the neighbour gives the tangent.
 */
export function maxSpeed(neighbour: number, shape: number | null): number {
  if (shape === null || shape >= neighbour) return MAX_SPEED;
  return Math.min(Math.ceil((MAX_SPEED * neighbour) / shape), FASTEST);
}

/** The closest offered speed. */
export function offeredSpeed(wanted: number, max = MAX_SPEED): number {
  return Number(clamp(Math.round(wanted / SPEED_STEP) * SPEED_STEP, 0, max).toFixed(2));
}

/** The speed after this number of steps. */
export function steppedSpeed(speed: number, steps: number, max = MAX_SPEED): number {
  return offeredSpeed(offeredSpeed(speed, max) + steps * SPEED_STEP, max);
}

export function formatSpeed(speed: number): string {
  return `${Number(speed.toFixed(2))}×`;
}
