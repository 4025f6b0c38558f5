/**
 * Keeps the timeline's pace and the speeds on offer in step with the motion: asked for when frames leave time, the
 * newest only.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { Pace } from '../../model/pace.ts';
import { paceOf, paceTimes } from '../../model/pace.ts';
import { USUAL_MOST } from '../../model/speeds.ts';
import type { Speeds } from '../../model/speeds.ts';
import { mostSpeeds } from './shape-plane.ts';
import type { ShapePlaneInput } from './shape-plane.ts';

export interface MotionPaceParts {
  /** The first running sequence. */
  sequence(): Motion | undefined;
  /** What the ends lead towards. */
  towards(): ShapePlaneInput['towards'];
  /** `most`: the fastest on offer at the ends. */
  onPace(pace: Pace | null, most: Speeds): void;
}

export interface MotionPaceFollower {
  /** The motion has changed. */
  refresh(): void;
}

export function createMotionPace({ sequence, towards, onPace }: MotionPaceParts): MotionPaceFollower {
  let stale = false;
  let running = false;

  const work = async (): Promise<void> => {
    const asked = sequence();
    if (!asked) return onPace(null, USUAL_MOST);
    const { range } = asked;
    const times = paceTimes(range, asked.keyTimes);
    const pace = await asked.motionPace(times);
    const ends = towards();
    const shaped = ends?.start === 'shape' || ends?.end === 'shape';
    const most = shaped ? mostSpeeds(await asked.shapePlane([]), ends) : USUAL_MOST;
    if (sequence() === asked && !stale) onPace(paceOf(times, pace, range), most);
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
