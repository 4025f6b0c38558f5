/**
 * Keeps the timeline's speed curve and the offered speeds in step with the motion. Requests run when no frames are
 * waiting; only the newest counts.
 */
import type { Motion } from '../../engine/api/api.ts';
import type { SpeedCurve } from '../../model/speed-curve.ts';
import { speedCurveOf, speedTimes } from '../../model/speed-curve.ts';
import { USUAL_MAX_SPEEDS } from '../../model/speeds.ts';
import type { Speeds } from '../../model/speeds.ts';
import { maxSpeeds } from './shape-plane.ts';
import type { ShapePlaneInput } from './shape-plane.ts';

export interface MotionSpeedParts {
  /** The first running sequence. */
  sequence(): Motion | undefined;
  /** Shapes that give the end tangents. */
  towards(): ShapePlaneInput['towards'];
  /** `max`: the largest offered end speeds. */
  onSpeed(curve: SpeedCurve | null, max: Speeds): void;
}

export interface MotionSpeedFollower {
  refresh(): void;
}

export function createMotionSpeed({ sequence, towards, onSpeed }: MotionSpeedParts): MotionSpeedFollower {
  let stale = false;
  let running = false;

  const work = async (): Promise<void> => {
    const asked = sequence();
    if (!asked) return onSpeed(null, USUAL_MAX_SPEEDS);
    const { range } = asked;
    const times = speedTimes(range, asked.keyTimes);
    const motion = await asked.motionSpeed(times);
    const ends = towards();
    const shaped = ends?.start === 'shape' || ends?.end === 'shape';
    const max = shaped ? maxSpeeds(await asked.shapePlane([]), ends) : USUAL_MAX_SPEEDS;
    if (sequence() === asked && !stale) onSpeed(speedCurveOf(times, motion, range), max);
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
