/** Advances the time during playback: a pure step, called once per drawn frame. */
import type { LoopMode } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { length, wrap } from '../model/time-scale.ts';

export interface Tick {
  time: number;
  direction: 1 | -1;
  playing: boolean;
}

export interface ClockInput {
  time: number;
  direction: 1 | -1;
  /** Step in units of time, at least 0. */
  step: number;
  range: Range;
  loop: LoopMode;
  periodic: boolean;
}

/** From outside the range, the time first runs towards it, so playback from a margin does not jump. */
export function tick({ time, direction, step, range, loop, periodic }: ClockInput): Tick {
  const [start, end] = range;
  if (length(range) <= 0) return { time: start, direction: 1, playing: false };
  const heading = time < start ? 1 : time > end && loop === 'bounce' && !periodic ? -1 : direction;
  const next = time + heading * step;
  const leftEnd = heading > 0 && next >= end;
  const leftStart = heading < 0 && next <= start;
  if (!leftEnd && !leftStart) return { time: next, direction: heading, playing: true };
  if (loop === 'once') return { time: leftEnd ? end : start, direction: 1, playing: false };
  if (periodic || loop === 'loop') return { time: wrap(next, range), direction: 1, playing: true };
  return bounce(next, heading, range);
}

function bounce(next: number, heading: 1 | -1, [start, end]: Range): Tick {
  const over = heading > 0 ? next - end : start - next;
  const inside = Math.min(over, end - start);
  return heading > 0
    ? { time: end - inside, direction: -1, playing: true }
    : { time: start + inside, direction: 1, playing: true };
}
