/** Pins on the shape: dragged with the pointer or moved with the arrow keys, removed with Delete. */
import { h, setAttribute, setHidden, setStyle, svg } from './dom.ts';
import { drag, focusPressed, isPress } from './pointer.ts';

/** A position in CSS pixels from the top left corner of the viewport. */
export interface Place {
  x: number;
  y: number;
}

export interface PinHandleEvents {
  /** Later moves of the pin are relative to its current position. */
  onStart(index: number): void;
  /** Moves the pin to a position in the viewport. */
  onMove(index: number, to: Place): void;
  onRemove(index: number): void;
}

/** Step of an arrow key, in pixels; ten times that with Shift. */
const STEP = 2;
const ARROWS: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export interface PinHandles {
  element: HTMLElement;
  /** Updates the pins' positions; null for positions outside the viewport. `paths`: x and y along each pin's path. */
  update(places: readonly (Place | null)[], paths: readonly Float32Array[]): void;
  /** Marks the vertex that would be pinned; null removes the mark. */
  mark(place: Place | null): void;
}

export function createPinHandles(events: PinHandleEvents): PinHandles {
  const mark = h('div', { class: 'pin-mark', hidden: true, 'data-testid': 'pin-mark' });
  const element = h('div', { class: 'pin-handles', 'data-testid': 'pin-handles' }, mark);
  const lines = svg('svg', { class: 'pin-paths', 'aria-hidden': 'true' });
  element.append(lines);
  const handles: HTMLButtonElement[] = [];
  let shown: readonly (Place | null)[] = [];

  const press = (index: number, event: PointerEvent): void => {
    const from = shown[index];
    if (!isPress(event) || !from) return;
    event.preventDefault();
    event.stopPropagation();
    const handle = handles[index]!;
    focusPressed(handle);
    const grip = { x: event.clientX - from.x, y: event.clientY - from.y };
    events.onStart(index);
    drag(handle, event, {
      onMove: ({ clientX, clientY }) => events.onMove(index, { x: clientX - grip.x, y: clientY - grip.y }),
    });
  };
  const key = (index: number, event: KeyboardEvent): void => {
    const from = shown[index];
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey || !from) return;
    if (!arrow && event.key !== 'Delete' && event.key !== 'Backspace') return;
    event.preventDefault();
    event.stopPropagation();
    if (!arrow) return events.onRemove(index);
    const step = event.shiftKey ? 10 * STEP : STEP;
    events.onStart(index);
    events.onMove(index, { x: from.x + step * arrow[0], y: from.y + step * arrow[1] });
  };
  const create = (index: number): HTMLButtonElement =>
    h(
      'button',
      {
        type: 'button',
        class: 'pin-handle',
        'data-testid': `pin-handle-${index}`,
        title: `Pin ${index + 1}: drag it to set its position at this time; Delete removes it`,
        'aria-label': `Pin ${index + 1} on the shape. Arrow keys move it at this time, Delete removes it.`,
        onpointerdown: (event: PointerEvent) => press(index, event),
        onkeydown: (event: KeyboardEvent) => key(index, event),
      },
      String(index + 1),
    );

  return {
    element,
    update(places, paths) {
      shown = places;
      drawPaths(lines, paths);
      while (handles.length > places.length) handles.pop()!.remove();
      while (handles.length < places.length) {
        handles.push(create(handles.length));
        element.append(handles.at(-1)!);
      }
      places.forEach((place, index) => {
        put(handles[index]!, place);
      });
    },
    mark: (place) => put(mark, place),
  };
}

function put(element: HTMLElement, place: Place | null): void {
  setHidden(element, place === null);
  if (place) setStyle(element, 'transform', `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px)`);
}

function drawPaths(lines: SVGSVGElement, paths: readonly Float32Array[]): void {
  while (lines.childElementCount > paths.length) lines.lastElementChild!.remove();
  while (lines.childElementCount < paths.length) lines.append(svg('polyline'));
  paths.forEach((path, index) => {
    const points = Array.from(
      { length: path.length / 2 },
      (_, i) => `${round(path[2 * i]!)},${round(path[2 * i + 1]!)}`,
    );
    setAttribute(lines.children[index]!, 'points', points.join(' '));
  });
}

const round = (pixels: number): string => pixels.toFixed(1);
