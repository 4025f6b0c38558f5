/** Handles for the keys: dragged, or moved with the arrow keys. */
import { drag } from '../../plots/drag.ts';
import { make, text } from '../../plots/svg-parts.ts';
import type { Shown } from '../derived.ts';
import type { Axes } from './plot.ts';
import { LEFT, RIGHT } from './plot.ts';
import { number } from './words.ts';

export interface KeyHandleEvents {
  onSelect(key: number): void;
  onMove(key: number, to: KeyPosition): void;
  onRemove(key: number): void;
  /** Reports the start and end of dragging a key. */
  onHold(holding: boolean): void;
}

/** `along`: the time, or the second coordinate in two dimensions. */
export interface KeyPosition {
  along: number;
  value: number;
}

interface Handle<Of> {
  element: SVGGElement;
  /** `at`: positions in the plot. */
  update(shown: Shown, at: Of, axes: Axes): void;
}

type Point = readonly [number, number];

/** Step of an arrow key, relative to the shown range in each direction. */
const STEP = 1 / 100;

export function createKeyHandles(picture: SVGSVGElement, events: KeyHandleEvents): Handle<readonly Point[]> {
  const element = make('g', {});
  const handles: Handle<Point>[] = [];
  return {
    element,
    update(shown, points, axes) {
      while (handles.length < points.length)
        element.append(handles[handles.push(createKeyHandle(handles.length, picture, events)) - 1]!.element);
      while (handles.length > points.length) handles.pop()!.element.remove();
      handles.forEach((handle, key) => handle.update(shown, points[key]!, axes));
    },
  };
}

function createKeyHandle(key: number, picture: SVGSVGElement, events: KeyHandleEvents): Handle<Point> {
  const element = make('g', { class: 'key-handle', role: 'slider', tabindex: 0, 'data-testid': `key-${key}` });
  element.append(
    make('circle', { class: 'key-reach', r: 20 }),
    make('circle', { class: 'key', r: 7 }),
    text('key-number', 0, -14, String(key + 1)),
  );
  let drawn: { axes: Axes; from: KeyPosition } | null = null;
  /** Result of earlier key presses that is not drawn yet; the next press continues from it. */
  let pressed: KeyPosition | null = null;

  element.addEventListener('focus', () => events.onSelect(key));
  element.addEventListener('keydown', (event) => {
    if (event.key === 'Delete' || event.key === 'Backspace') {
      event.preventDefault();
      events.onRemove(key);
    }
    const to = drawn && stepped(pressed ?? drawn.from, event, drawn.axes);
    if (!to) return;
    event.preventDefault();
    pressed = to;
    events.onMove(key, to);
  });
  element.addEventListener('pointerdown', (start) => {
    if (start.button !== 0 || !drawn) return;
    start.preventDefault();
    element.focus({ preventScroll: true });
    events.onSelect(key);
    events.onHold(true);
    const { from, axes } = drawn;
    const pixel = pixelOf(picture, axes);
    const move = (at: PointerEvent): void =>
      events.onMove(key, {
        along: from.along + (at.clientX - start.clientX) * pixel.along,
        value: from.value - (at.clientY - start.clientY) * pixel.value,
      });
    drag(element, start, move, () => events.onHold(false));
  });

  return {
    element,
    update({ state, derived, lit }, [x, y], axes) {
      const { value, across } = state.keys[key]!;
      const time = derived.times[key]!;
      pressed = null;
      drawn = { axes, from: { along: state.plane ? across : time, value } };
      const [low, high] = axes.y.domain;
      element.setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
      element.classList.toggle('selected', key === state.selected);
      element.classList.toggle('lit', key === lit);
      const along = state.plane ? `and ${number(across)} across` : `at time ${number(time)}`;
      for (const [name, said] of Object.entries({
        'aria-label': `Key ${key + 1}`,
        'aria-orientation': 'vertical',
        'aria-valuemin': Math.min(low, value).toPrecision(4),
        'aria-valuemax': Math.max(high, value).toPrecision(4),
        'aria-valuenow': value.toPrecision(4),
        'aria-valuetext': `value ${number(value)} ${along}`,
      }))
        element.setAttribute(name, said);
    },
  };
}

/** Position of a key after an arrow key; null for other keys. */
export function stepped(
  { along, value }: KeyPosition,
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  { x, y }: Axes,
): KeyPosition | null {
  const by = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] }[key];
  if (!by) return null;
  const scale = STEP * (shiftKey ? 10 : 1);
  return { along: along + by[0]! * scale * lengthOf(x.domain), value: value + by[1]! * scale * lengthOf(y.domain) };
}

/** Data units per pixel of the page, along either axis. */
function pixelOf(picture: SVGSVGElement, { x, y }: Axes): KeyPosition {
  const { width } = picture.viewBox.baseVal;
  const perPixel = width / picture.getBoundingClientRect().width;
  return {
    along: (lengthOf(x.domain) / (width - LEFT - RIGHT)) * perPixel,
    value: (lengthOf(y.domain) / (y(y.domain[0]) - y(y.domain[1]))) * perPixel,
  };
}

const lengthOf = ([low, high]: Point): number => high - low;
