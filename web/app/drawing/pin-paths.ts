/** Where pinned vertices go over the motion, for drawing. Computed when frames leave time; only the newest counts. */
import type { Motion } from '../../engine/api/api.ts';
import type { Pins } from '../../model/pins.ts';

export interface PinPathsParts {
  /** The first running motion. */
  motion(): Motion | undefined;
  pins(): Pins;
  /** Resolves when nothing else is to be drawn. */
  idle(): Promise<void>;
  onPaths(): void;
}

export interface PinPaths {
  /** Of each pin 3 x TIMES coordinates, from the first time of the motion to the last. */
  readonly now: readonly Float32Array[];
  /** The motion or its pins have changed. */
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
      // A motion that was exchanged in the middle has a successor, which calls again.
      void compute(newest).catch(() => undefined);
    },
  };
}
