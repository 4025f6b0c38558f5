/**
 * The Hermite speeds as the page offers them: times the speed that goes straight from the first key to the second, or
 * from the last but one to the last; where a shape is taken as end tangent, it stands for that neighbour. 0 eases.
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
/** However close a tangent's shape lies; faster ones can be typed. */
const FASTEST = 10 * MAX_SPEED;

/** Largest speed that can be typed: the engine's limit. */
export const TYPED_SPEED = MOTION.startSpeed.most;

export type Speeds = Readonly<Record<End, number>>;

/** The fastest that handles and sliders offer where neighbours give the tangents. */
export const USUAL_MOST: Speeds = { start: MAX_SPEED, end: MAX_SPEED };

/**
 * The fastest that is offered at a key: as fast as `MAX_SPEED` towards the neighbour where the tangent's shape lies
 * closer than that. Distances from the key, in one unit; shape null = the neighbour gives the tangent.
 */
export function mostSpeed(neighbour: number, shape: number | null): number {
  if (shape === null || shape >= neighbour) return MAX_SPEED;
  return Math.min(Math.ceil((MAX_SPEED * neighbour) / shape), FASTEST);
}

/** The nearest speed on offer. */
export function offeredSpeed(wanted: number, most = MAX_SPEED): number {
  return Number(clamp(Math.round(wanted / SPEED_STEP) * SPEED_STEP, 0, most).toFixed(2));
}

/** The speed after this number of steps. */
export function steppedSpeed(speed: number, steps: number, most = MAX_SPEED): number {
  return offeredSpeed(offeredSpeed(speed, most) + steps * SPEED_STEP, most);
}

export function formatSpeed(speed: number): string {
  return `${Number(speed.toFixed(2))}×`;
}
