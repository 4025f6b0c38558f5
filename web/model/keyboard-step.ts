/** Keyboard control of the playhead. */
import { steppedFrameTime } from './frames.ts';
import { clampTime, length } from './time-scale.ts';
import type { TimeScale } from './time-scale.ts';

interface Press {
  readonly key: string;
  readonly shiftKey: boolean;
}

/** The playhead after a key press, or null for other keys. */
export function keyboardStep(event: Press, time: number, scale: TimeScale, fps: number | null): number | null {
  const {
    range,
    whole: [low, high],
  } = scale;
  const step = (by: number): number =>
    clampTime(fps === null ? time + 0.01 * by * length(range) : steppedFrameTime(time, fps, by), range);
  switch (event.key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return step(event.shiftKey ? -10 : -1);
    case 'ArrowRight':
    case 'ArrowUp':
      return step(event.shiftKey ? 10 : 1);
    case 'PageDown':
      return step(-10);
    case 'PageUp':
      return step(10);
    case 'Home':
      return time <= range[0] ? low : range[0];
    case 'End':
      return time >= range[1] ? high : range[1];
    default:
      return null;
  }
}
