/** Handles for the speeds at the ends of the curve. */
import { clamp } from '../../model/time-scale.ts';
import { ENDS, createEndHandle } from '../../plots/end-handle.ts';
import type { End } from '../../plots/end-handle.ts';
import { MAX_SPEED } from '../../model/speeds.ts';
import type { PlayState } from '../state.ts';
import type { Box } from './plot.ts';

export interface EndHandles {
  elements: SVGGElement[];
  /** `points`: positions of the keys in the plot. */
  update(state: PlayState, points: readonly Point[], box: Box): void;
}

type Point = readonly [number, number];

/** Length of a handle at speed 1, relative to the distance of the next key. */
const HANDLE = 1 / 2;

export function createEndHandles(picture: SVGSVGElement, onSpeed: (end: End, speed: number) => void): EndHandles {
  let speeds: Record<End, number> = { start: 1, end: 1 };
  const setSpeed = (end: End, speed: number): void => onSpeed(end, clamp(speed, 0, MAX_SPEED));
  const events = {
    label: (end: End) => (end === 'start' ? 'Speed at the first key' : 'Speed at the last key'),
    words: (speed: number) => speed.toFixed(2),
    onSpeed: setSpeed,
    onKey(end: End, event: KeyboardEvent) {
      const step = { ArrowUp: 0.1, ArrowRight: 0.1, ArrowDown: -0.1, ArrowLeft: -0.1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      // Several key presses can arrive before the page is redrawn. Each continues from the last requested value.
      speeds = { ...speeds, [end]: clamp(speeds[end] + step * (event.shiftKey ? 10 : 1), 0, MAX_SPEED) };
      onSpeed(end, speeds[end]);
    },
    onReset: (end: End) => onSpeed(end, 1),
  };
  const handles = {
    start: createEndHandle('start', picture, events),
    end: createEndHandle('end', picture, events),
  };
  return {
    elements: ENDS.map((end) => handles[end].element),
    update(state, points, box) {
      speeds = { start: state.speeds[0], end: state.speeds[1] };
      const on = hasSpeeds(state);
      const ways = { start: points.slice(0, 2), end: points.slice(-2).reverse() };
      for (const end of ENDS) {
        const [from, to] = ways[end] as [Point, Point];
        const unit: Point = [(to[0] - from[0]) * HANDLE, (to[1] - from[1]) * HANDLE];
        handles[end].place(on ? { from, unit, ...box } : null);
        handles[end].setSpeed(on ? speeds[end] : null, MAX_SPEED);
      }
    },
  };
}

/** Whether a shown curve has given end speeds. */
export function hasSpeeds({ layers, ends }: PlayState): boolean {
  return layers.includes('hermite') || (ends === 'hermite' && layers.includes('shaped'));
}
