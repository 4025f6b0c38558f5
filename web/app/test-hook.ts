/**
 * `window.__shapespline`, for tests of pages that use the app, in the production build too. Everything is plain data;
 * times are in the unit of the key times, positions xyz interleaved.
 */
import type { Motion } from '../engine/api/api.ts';
import type { Ghost, SequenceStats } from '../engine/api/types.ts';
import type { AppState } from '../model/state.ts';
import type { Viewer } from '../viewer/viewer.ts';

export interface TestHook {
  /** Resolves when the first shape is on the screen. */
  ready: Promise<void>;
  /** Moves to t and resolves when that frame is drawn, exactly. */
  setTime(t: number): Promise<void>;
  /** Resolves when no import, build or frame is in progress. */
  settled(): Promise<void>;
  /**
   * Restores the state in which the page opens with this fragment, for a returning visitor without stored files. Does
   * not reload the page; resolves when settled.
   */
  reset(fragment?: string): Promise<void>;
  readonly state: AppState;
  /** The time on the screen, which follows the time of the state. */
  readonly shown: { time: number };
  /** Counters of the main sequence: encodings, factorisations, solves. */
  stats(): Promise<SequenceStats | null>;
  /** The engine's result for a time, 3 x vertices, without drawing it. */
  evaluate(t: number): Promise<Float32Array>;
  /** The main motion's ghost mesh with 3 x ghost vertices at the current time; null without a ghost. */
  ghost(): Promise<(Ghost & { positions: Float32Array }) | null>;
  /** The distance of each vertex from the shape without a ghost, as shown by the colours, in % of the diagonal. */
  difference(): Float32Array | null;
  /** A copy of the drawn positions in a view, 3 x vertices. */
  positions(view?: number): Float32Array;
  /** Screen positions of points: x, y in CSS pixels from the canvas's top left corner. */
  project(points: ArrayLike<number>, view?: number): Float32Array;
}

declare global {
  interface Window {
    __shapespline?: TestHook;
  }
}

export interface TestHookParts {
  ready: Promise<void>;
  viewer: Viewer;
  /** The first running sequence. */
  sequence(): Motion | undefined;
  state(): AppState;
  shown(): { t: number };
  difference(): Float32Array | null;
  /** Stops playback and draws the exact shape at a time. */
  seekExactly(t: number): Promise<void>;
  reset(fragment: string): Promise<void>;
  /** Resolves after one round of waiting. Work that ends may start new work. */
  idle(): Promise<void>;
  busy(): boolean;
}

export function createTestHook(parts: TestHookParts): TestHook {
  const { viewer, sequence, state } = parts;
  const settled = async (): Promise<void> => {
    do {
      await parts.idle();
      await viewer.drawn();
      // Components show the last frame's changes on the next animation frame.
      await new Promise((resolve) => requestAnimationFrame(resolve));
    } while (parts.busy());
  };
  return {
    ready: parts.ready,
    setTime: parts.seekExactly,
    settled,
    async reset(fragment = '') {
      await parts.reset(fragment);
      await settled();
    },
    get state() {
      return structuredClone(state());
    },
    stats: async () => (await sequence()?.shape.stats()) ?? null,
    async evaluate(t) {
      const [frame] = (await sequence()?.evaluateMany([t])) ?? [];
      const positions = frame?.positions.slice() ?? new Float32Array();
      frame?.release();
      return positions;
    },
    async ghost() {
      const of = sequence();
      const mesh = (await of?.shape.ghost()) ?? null;
      return mesh && { ...mesh, positions: await of!.ghostPositions(state().time) };
    },
    get shown() {
      return { time: parts.shown().t };
    },
    difference: () => parts.difference()?.slice() ?? null,
    positions: (view = 0) => viewer.positions(view),
    project: (points, view = 0) => viewer.project(Float32Array.from(points), view),
  };
}

export function installTestHook(hook: TestHook): void {
  window.__shapespline = hook;
}
