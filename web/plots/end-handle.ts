/**
 * A handle along the tangent at an end of the curve. A longer handle means a higher speed. Drag it or use the arrow
 * keys.
 */
import { drag } from './drag.ts';
import { make, text } from './svg-parts.ts';

export type End = 'start' | 'end';
export const ENDS: readonly End[] = ['start', 'end'];
type Vector = readonly [number, number];

export interface EndHandleEvents {
  label(end: End): string;
  words(speed: number): string;
  onSpeed(end: End, speed: number): void;
  /** A key was pressed on the handle; the caller interprets it. */
  onKey(end: End, event: KeyboardEvent): void;
  onReset(end: End): void;
}

/** Start of a handle, and its vector at speed 1, in a plot of this size. */
export interface Placed {
  from: Vector;
  unit: Vector;
  width: number;
  height: number;
}

export interface EndHandle {
  element: SVGGElement;
  place(placed: Placed | null): void;
  /** `max`: the largest offered speed. Speed null: no handle. */
  setSpeed(speed: number | null, max: number): void;
}

/** A handle whose longest length is below this could not be dragged. */
const MIN_LENGTH = 56;
/** Distance between the grip and the plot's edge. */
const EDGE = 10;

export function createEndHandle(end: End, picture: SVGSVGElement, events: EndHandleEvents): EndHandle {
  const stem = make('line', { class: 'stem' });
  const grip = make('circle', { class: 'grip-mark', r: 5 });
  const reach = make('circle', { class: 'grip-reach', r: 14 });
  const value = text('grip-value', 0, 0, '');
  const element = make('g', {
    class: 'end-handle',
    role: 'slider',
    tabindex: 0,
    'aria-label': events.label(end),
    'aria-valuemin': 0,
    'data-testid': `plane-${end}-speed`,
    display: 'none',
  });
  element.append(stem, reach, grip, value);
  let at: Placed | null = null;
  let placed: Placed | null = null;
  let speed: number | null = null;
  let max = 1;

  const draw = (): void => {
    element.setAttribute('display', placed && speed !== null ? 'inline' : 'none');
    if (!placed || speed === null) return;
    const [x1, y1] = placed.from;
    const length = Math.min(Math.max(speed, 0), max);
    const [x2, y2] = [x1 + placed.unit[0] * length, y1 + placed.unit[1] * length];
    set(stem, { x1, y1, x2, y2 });
    for (const circle of [grip, reach]) set(circle, { cx: x2, cy: y2 });
    set(value, beside([x2, y2], placed.unit));
    value.textContent = events.words(speed);
    element.setAttribute('aria-valuemax', String(max));
    element.setAttribute('aria-valuenow', String(Number(speed.toFixed(6))));
    element.setAttribute('aria-valuetext', events.words(speed));
  };

  element.addEventListener('pointerdown', (event) => {
    if (!placed || speed === null || event.button !== 0) return;
    const [from, { unit }, scale] = [speed, placed, placed.width / picture.getBoundingClientRect().width];
    event.preventDefault();
    element.focus({ preventScroll: true });
    drag(element, event, (to) => {
      const along = ((to.clientX - event.clientX) * unit[0] + (to.clientY - event.clientY) * unit[1]) * scale;
      events.onSpeed(end, from + along / (unit[0] ** 2 + unit[1] ** 2));
    });
  });
  element.addEventListener('keydown', (event) => events.onKey(end, event));
  element.addEventListener('dblclick', () => events.onReset(end));

  return {
    element,
    place(next) {
      at = next;
      placed = at && usable(at, max);
      draw();
    },
    setSpeed(next, nextMax) {
      if (next === speed && nextMax === max) return;
      [speed, max] = [next, nextMax];
      placed = at && usable(at, max);
      draw();
    },
  };
}

/** Position of the number's centre: above the handle, or below it at the top of the plot. */
function beside([x, y]: Vector, [ux, uy]: Vector): { x: number; y: number } {
  const length = Math.hypot(ux, uy);
  const side = ((ux < 0 ? -1 : 1) * (y < 24 ? -1 : 1)) / length;
  return { x: x + 18 * uy * side, y: y - 13 * ux * side + 4 };
}

/**
 * A handle that can be dragged and stays inside the plot at its longest; null if the tangent has no direction in the
 * plane.
 */
function usable(placed: Placed, max: number): Placed | null {
  const { from, unit, width, height } = placed;
  const length = Math.hypot(...unit);
  if (!(length > 1e-6)) return null;
  const room = [
    [from[0], unit[0], width],
    [from[1], unit[1], height],
  ].map(([at, step, size]) => (step === 0 ? Infinity : ((step! > 0 ? size! - EDGE : EDGE) - at!) / step!) / max);
  const scale = Math.min(Math.max(1, MIN_LENGTH / (length * max)), ...room.map((share) => Math.max(share, 0)));
  return { ...placed, unit: [unit[0] * scale, unit[1] * scale] };
}

function set(element: SVGElement, attributes: Record<string, number>): void {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value.toFixed(2));
}
