/**
 * The Hermite speeds as the page offers them: times the speed that goes straight from the first key to the second, or
 * from the last but one to the last; where a shape is taken as end tangent, it stands for that neighbour. 0 eases.
 */
import { DEFAULT_MOTION } from './state.ts';
import { clamp } from './time-scale.ts';

export type End = 'start' | 'end';

export const SPEED_NAME = { start: 'startSpeed', end: 'endSpeed' } as const;
export const TANGENT_NAME = { start: 'startTangentPose', end: 'endTangentPose' } as const;
export const DEFAULT_SPEED = DEFAULT_MOTION.startSpeed;
export const MAX_SPEED = 4;
export const SPEED_STEP = 0.05;

/** The nearest speed on offer. */
export function offeredSpeed(wanted: number): number {
  return Number(clamp(Math.round(wanted / SPEED_STEP) * SPEED_STEP, 0, MAX_SPEED).toFixed(2));
}

/** The speed so many steps faster. */
export function steppedSpeed(speed: number, steps: number): number {
  return offeredSpeed(offeredSpeed(speed) + steps * SPEED_STEP);
}

export function formatSpeed(speed: number): string {
  return `${Number(speed.toFixed(2))}×`;
}
