/**
 * `window.__shapespline`, for tests of pages that use the app, in the production build too. Everything is plain data;
 * times are in the unit of the key times, positions xyz interleaved.
 */
import type { Ghost, SequenceStats } from '../engine/api/types.ts';
import type { AppState } from '../model/state.ts';

export interface TestHook {
  /** Resolves when the first shape is on the screen. */
  ready: Promise<void>;
  /** Moves to t and resolves when that frame is drawn, exactly. */
  setTime(t: number): Promise<void>;
  /** Resolves when nothing is under way: no import, no build, no frame. */
  settled(): Promise<void>;
  readonly state: AppState;
  /** The moment on the screen, which follows that of the state; `about` while what moves is drawn about right (Sequence.preview). */
  readonly shown: { time: number; about: boolean };
  /** Counters of the main sequence: encodings, factorisations, solves. */
  stats(): Promise<SequenceStats | null>;
  /** The engine's own answer for a moment, 3 x vertices, without drawing it. */
  evaluate(t: number): Promise<Float32Array>;
  /** The main motion's ghost mesh with 3 x ghost vertices of the present moment; null without one. */
  ghost(): Promise<(Ghost & { positions: Float32Array }) | null>;
  /** What is shown as colours now: of each vertex, how far it is from where it would be without a ghost, in % of the diagonal. */
  difference(): Float32Array | null;
  /** What is drawn now in a view, 3 x vertices, copied. */
  positions(view?: number): Float32Array;
  /** Where points appear: x, y in CSS pixels from the canvas' top left corner. */
  project(points: ArrayLike<number>, view?: number): Float32Array;
}

declare global {
  interface Window {
    __shapespline?: TestHook;
  }
}

export function installTestHook(hook: TestHook): void {
  window.__shapespline = hook;
}
