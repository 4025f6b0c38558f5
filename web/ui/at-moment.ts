/** Where elements of the timeline stand: at a moment, or over a stretch of time. */
import type { Range } from '../model/time-scale.ts';
import { clamp } from '../model/time-scale.ts';
import { fractionIn } from '../model/time-window.ts';
import { setHidden, setStyle } from './dom.ts';

/** Puts an element at a moment, or hides it where the window does not reach, or where there is none. */
export function place(element: HTMLElement, t: number | null, window: Range): void {
  const at = t === null ? -1 : fractionIn(t, window);
  setHidden(element, at < -1e-9 || at > 1 + 1e-9);
  setStyle(element, 'left', percent(at));
}

/** Lets an element span what the window shows of a stretch of time. */
export function stretch(element: HTMLElement, [from, to]: Range, window: Range): void {
  const [left, right] = [clamp(fractionIn(from, window), 0, 1), clamp(fractionIn(to, window), 0, 1)];
  setHidden(element, right <= left);
  setStyle(element, 'left', percent(left));
  setStyle(element, 'width', percent(right - left));
}

function percent(fraction: number): string {
  return `${(fraction * 100).toFixed(4)}%`;
}
