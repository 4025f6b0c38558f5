/** The demonstration that plays until the first user action: a loop of scenes. */
import { INITIAL, MAX_SAMPLES, MIN_SAMPLES, withKey } from './state.ts';
import type { PlayState, LastAction } from './state.ts';

export interface Scene {
  seconds: number;
  /** Shows the sentence for this action. */
  lastAction: LastAction;
  /** share: progress of the scene, from 0 to 1. */
  at(share: number): PlayState;
}

/** Smooth back-and-forth movement. */
const swing = (share: number): number => Math.sin(share * 2 * Math.PI);
const rise = (share: number): number => 0.5 - 0.5 * Math.cos(Math.min(share / 0.8, 1) * Math.PI);

const bobbing = (state: PlayState, share: number): PlayState =>
  withKey(state, 2, { value: INITIAL.keys[2]!.value + 0.22 * swing(share) });

export const SCENES: readonly Scene[] = [
  { seconds: 6, lastAction: 'linear', at: (share) => bobbing({ ...INITIAL, layers: ['linear'] }, share) },
  { seconds: 6, lastAction: 'natural', at: (share) => bobbing({ ...INITIAL, layers: ['linear', 'natural'] }, share) },
  {
    seconds: 8,
    lastAction: 'samples',
    at: (share) => ({
      ...INITIAL,
      layers: ['natural', 'samples'],
      samples: Math.round(MIN_SAMPLES + (MAX_SAMPLES - MIN_SAMPLES) * rise(share) ** 2),
    }),
  },
  {
    seconds: 6,
    lastAction: 'catmull-rom',
    at: (share) => bobbing({ ...INITIAL, layers: ['natural', 'catmull-rom'] }, share),
  },
  {
    seconds: 8,
    lastAction: 'hermite',
    at: (share) => ({
      ...INITIAL,
      layers: ['natural', 'hermite'],
      ends: 'hermite',
      speeds: [1 + swing(share), 1 - swing(share)],
    }),
  },
  { seconds: 8, lastAction: 'time', at: (share) => ({ ...INITIAL, time: 0.5 - 0.62 * Math.cos(share * 2 * Math.PI) }) },
  {
    seconds: 9,
    lastAction: 'spacing',
    at: (share) => ({
      ...INITIAL,
      plane: true,
      layers: ['linear', 'natural'],
      spacing: (['even', 'root', 'difference'] as const)[Math.min(Math.floor(share * 3), 2)]!,
    }),
  },
];

export interface Demonstration {
  readonly running: boolean;
  start(): void;
  stop(): void;
}

/** Shows a state on every frame while running. */
export function createDemonstration(show: (state: PlayState, scene: Scene, index: number) => void): Demonstration {
  const whole = SCENES.reduce((sum, { seconds }) => sum + seconds, 0);
  let frame = 0;
  let start: number | null = null;
  const step = (now: number): void => {
    start ??= now;
    let passed = ((now - start) / 1000) % whole;
    const index = SCENES.findIndex(({ seconds }) => {
      if (passed < seconds) return true;
      passed -= seconds;
      return false;
    });
    const scene = SCENES[Math.max(index, 0)]!;
    show(scene.at(passed / scene.seconds), scene, Math.max(index, 0));
    frame = requestAnimationFrame(step);
  };
  return {
    get running() {
      return frame !== 0;
    },
    start() {
      if (frame !== 0) return;
      start = null;
      frame = requestAnimationFrame(step);
    },
    stop() {
      cancelAnimationFrame(frame);
      frame = 0;
    },
  };
}
