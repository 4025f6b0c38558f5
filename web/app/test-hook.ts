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
  /** Resolves when nothing is under way: no import, no build, no frame. */
  settled(): Promise<void>;
  /**
   * Returns to the state in which the page opens with this fragment in its URL, for a returning visitor without stored
   * files, without loading it again; resolves when settled.
   */
  reset(fragment?: string): Promise<void>;
  readonly state: AppState;
  /** The time on the screen, which follows that of the state. */
  readonly shown: { time: number };
  /** Counters of the main sequence: encodings, factorisations, solves. */
  stats(): Promise<SequenceStats | null>;
  /** The engine's own answer for a moment, 3 x vertices, without drawing it. */
  evaluate(t: number): Promise<Float32Array>;
  /** The main motion's ghost mesh with 3 x ghost vertices of the present moment; null without one. */
  ghost(): Promise<(Ghost & { positions: Float32Array }) | null>;
  /** What is shown as colours now: per vertex the distance to the shape without a ghost, in % of the diagonal. */
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

export interface TestHookParts {
  ready: Promise<void>;
  viewer: Viewer;
  /** The first running sequence. */
  sequence(): Motion | undefined;
  state(): AppState;
  shown(): { t: number };
  difference(): Float32Array | null;
  /** Stops what plays and draws the exact shape of a moment. */
  seekExactly(t: number): Promise<void>;
  reset(fragment: string): Promise<void>;
  /** One round of waiting: what ends may start something else. */
  idle(): Promise<void>;
  busy(): boolean;
}

export function createTestHook(parts: TestHookParts): TestHook {
  const { viewer, sequence, state } = parts;
  const settled = async (): Promise<void> => {
    do {
      await parts.idle();
      await viewer.drawn();
      // What the last frame changed is shown by the components on the next one.
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
