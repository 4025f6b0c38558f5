/** Positions timeline elements at a time, or over a range of time. */
import type { Range } from '../model/time-scale.ts';
import { clamp } from '../model/time-scale.ts';
import { fractionIn } from '../model/time-window.ts';
import { setHidden, setStyle } from './dom.ts';

/** Moves an element to a time, or hides it if the time is null or outside the window. */
export function positionAtTime(element: HTMLElement, t: number | null, window: Range): void {
  const at = t === null ? -1 : fractionIn(t, window);
  setHidden(element, at < -1e-9 || at > 1 + 1e-9);
  setStyle(element, 'left', percent(at));
}

/** Fits an element to the visible part of a range of time. */
export function stretch(element: HTMLElement, [from, to]: Range, window: Range): void {
  const [left, right] = [clamp(fractionIn(from, window), 0, 1), clamp(fractionIn(to, window), 0, 1)];
  setHidden(element, right <= left);
  setStyle(element, 'left', percent(left));
  setStyle(element, 'width', percent(right - left));
}

function percent(fraction: number): string {
  return `${(fraction * 100).toFixed(4)}%`;
}
