/** Keeps the timeline's pace in step with the motion: asked for when frames leave time, the newest only. */
import type { Sequence } from '../../engine/api/api.ts';
import type { Pace } from '../../model/pace.ts';
import { paceOf, paceTimes } from '../../model/pace.ts';

export interface MotionPaceParts {
  /** The first running sequence. */
  sequence(): Sequence | undefined;
  onPace(pace: Pace | null): void;
}

export interface MotionPaceFollower {
  /** The motion has changed. */
  refresh(): void;
}

export function createMotionPace({ sequence, onPace }: MotionPaceParts): MotionPaceFollower {
  let stale = false;
  let running = false;

  const work = async (): Promise<void> => {
    const asked = sequence();
    if (!asked) return onPace(null);
    const { range } = asked;
    const times = paceTimes(range, asked.keyTimes);
    const pace = await asked.motionPace(times);
    if (sequence() === asked && !stale) onPace(paceOf(times, pace, range));
  };

  return {
    async refresh() {
      stale = true;
      if (running) return;
      running = true;
      while (stale) {
        stale = false;
        // A sequence that was exchanged in the middle has a successor, which calls again.
        await work().catch(() => undefined);
      }
      running = false;
    },
  };
}
