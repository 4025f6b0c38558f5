/**
 * Paths of pinned vertices over the motion, for drawing. Computed when no frames are waiting; only the newest request
 * counts.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { Pins } from '../../model/pins.ts';

export interface PinPathsParts {
  /** The first running motion. */
  motion(): Motion | undefined;
  pins(): Pins;
  /** Resolves when drawing is idle. */
  idle(): Promise<void>;
  onPaths(): void;
}

export interface PinPaths {
  /** The path of each pin as 3 x TIMES coordinates, from the motion's first time to its last. */
  readonly now: readonly Float32Array[];
  /** Call after changes of the motion or its pins. */
  refresh(): void;
}

const TIMES = 33;

export function createPinPaths({ motion, pins, idle, onPaths }: PinPathsParts): PinPaths {
  let now: readonly Float32Array[] = [];
  let newest = 0;
  const show = (paths: readonly Float32Array[]): void => {
    now = paths;
    onPaths();
  };
  const compute = async (round: number): Promise<void> => {
    const [asked, wanted] = [motion(), pins()];
    if (!asked || wanted.length === 0) return show([]);
    const [start, end] = asked.range;
    const paths = wanted.map(() => new Float32Array(3 * TIMES));
    for (let i = 0; i < TIMES; i += 1) {
      await idle();
      if (round !== newest) return;
      const [frame] = await asked.evaluateMany([start + (i / (TIMES - 1)) * (end - start)]);
      if (!frame) return;
      wanted.forEach(({ vertex }, pin) => paths[pin]!.set(frame.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
      frame.release();
    }
    if (round === newest) show(paths);
  };
  return {
    get now() {
      return now;
    },
    refresh() {
      newest += 1;
      // The successor of a replaced motion calls again.
      void compute(newest).catch(() => undefined);
    },
  };
}
