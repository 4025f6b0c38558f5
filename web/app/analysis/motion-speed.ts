/**
 * Keeps the timeline's speed curve and the offered speeds in step with the motion. Requests run when no frames are
 * waiting; only the newest counts.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { SpeedCurve } from '../../model/speed-curve.ts';
import { speedCurveOf, speedTimes } from '../../model/speed-curve.ts';
import { USUAL_MOST } from '../../model/speeds.ts';
import type { Speeds } from '../../model/speeds.ts';
import { mostSpeeds } from './shape-plane.ts';
import type { ShapePlaneInput } from './shape-plane.ts';

export interface MotionSpeedParts {
  /** The first running sequence. */
  sequence(): Motion | undefined;
  /** Shapes that give the end tangents. */
  towards(): ShapePlaneInput['towards'];
  /** `most`: the largest offered end speeds. */
  onSpeed(curve: SpeedCurve | null, most: Speeds): void;
}

export interface MotionSpeedFollower {
  refresh(): void;
}

export function createMotionSpeed({ sequence, towards, onSpeed }: MotionSpeedParts): MotionSpeedFollower {
  let stale = false;
  let running = false;

  const work = async (): Promise<void> => {
    const asked = sequence();
    if (!asked) return onSpeed(null, USUAL_MOST);
    const { range } = asked;
    const times = speedTimes(range, asked.keyTimes);
    const motion = await asked.motionSpeed(times);
    const ends = towards();
    const shaped = ends?.start === 'shape' || ends?.end === 'shape';
    const most = shaped ? mostSpeeds(await asked.shapePlane([]), ends) : USUAL_MOST;
    if (sequence() === asked && !stale) onSpeed(speedCurveOf(times, motion, range), most);
  };

  return {
    async refresh() {
      stale = true;
      if (running) return;
      running = true;
      while (stale) {
        stale = false;
        // The successor of a replaced sequence calls again.
        await work().catch(() => undefined);
      }
      running = false;
    },
  };
}
