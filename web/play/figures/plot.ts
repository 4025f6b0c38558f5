/** A picture as wide as its column, drawn anew when that changes, with axes over the keys. */
import { make, text } from '../../plots/svg-parts.ts';
import { linearScale, tickLabel, ticks } from '../../plots/scale.ts';
import type { Scale } from '../../plots/scale.ts';
import { uniqueId } from '../../ui/dom.ts';

export interface Box {
  width: number;
  height: number;
}

export const LEFT = 44;
export const RIGHT = 12;
export const TOP = 10;
export const BOTTOM = 22;

export interface Picture {
  element: SVGSVGElement;
  box(): Box;
  /** The parts, cut off where the axes end. */
  framed(parts: readonly SVGElement[]): SVGElement[];
}

/** An empty picture whose `draw` is called with its size in CSS pixels, now and whenever that changes. */
export function createPicture(style: string, heightOf: (width: number) => number, draw: (box: Box) => void): Picture {
  const element = make('svg', { class: `plot ${style}` });
  const frame = make('rect', { x: LEFT, y: TOP - 6 });
  const clip = make('clipPath', { id: uniqueId('frame') });
  clip.append(frame);
  let box: Box = { width: 0, height: 0 };
  const resize = (width: number): void => {
    const rounded = Math.max(Math.round(width), 200);
    if (rounded === box.width) return;
    box = { width: rounded, height: Math.round(heightOf(rounded)) };
    element.setAttribute('viewBox', `0 0 ${box.width} ${box.height}`);
    frame.setAttribute('width', String(box.width - LEFT - RIGHT));
    frame.setAttribute('height', String(box.height - TOP - BOTTOM + 6));
    draw(box);
  };
  new ResizeObserver(([entry]) => resize(entry!.contentRect.width)).observe(element);
  return {
    element,
    box: () => box,
    framed(parts) {
      const group = make('g', { 'clip-path': `url(#${clip.id})` });
      group.append(...parts);
      return [clip, group];
    },
  };
}

export interface Axes {
  x: Scale;
  y: Scale;
}

export function axesOf(box: Box, xs: readonly [number, number], ys: readonly [number, number]): Axes {
  return { x: linearScale(xs, LEFT, box.width - RIGHT), y: linearScale(ys, box.height - BOTTOM, TOP) };
}

export interface Marks {
  keyTimes: readonly number[];
  range: readonly [number, number];
  /** Lit up. */
  selected: number;
  cursor: number | null;
}

/** Grid, keys and the shaded parts beyond them, for a plot over time. */
export function timeAxes(
  { width, height }: Box,
  { x, y }: Axes,
  { keyTimes, range, selected, cursor }: Marks,
): SVGElement[] {
  const shade = (from: number, to: number): SVGElement =>
    make('rect', { class: 'beyond', x: from, y: TOP, width: Math.max(to - from, 0), height: height - BOTTOM - TOP });
  return [
    shade(LEFT, x(range[0])),
    shade(x(range[1]), width - RIGHT),
    ...gridLines(width, y, 5),
    ...keyTimes.flatMap((t, index) => [
      make('line', {
        class: index === selected ? 'key-line lit' : 'key-line',
        ...{ x1: x(t), x2: x(t), y1: TOP, y2: height - BOTTOM },
      }),
      text(index === selected ? 'tick-x lit' : 'tick-x', x(t), height - 6, String(index + 1)),
    ]),
    ...(cursor === null
      ? []
      : [make('line', { class: 'cursor', x1: x(cursor), x2: x(cursor), y1: TOP, y2: height - BOTTOM })]),
  ];
}

export function gridLines(width: number, y: Scale, count: number): SVGElement[] {
  return ticks(y.domain, count).flatMap((value) => [
    make('line', {
      class: value === 0 ? 'grid zero' : 'grid',
      x1: LEFT,
      x2: width - RIGHT,
      y1: y(value),
      y2: y(value),
    }),
    text('tick-y', LEFT - 6, y(value) + 4, tickLabel(value)),
  ]);
}

/** The time under a pointer. */
function timeAt(element: SVGSVGElement, { width }: Box, x: Scale, clientX: number): number {
  const { left, width: drawn } = element.getBoundingClientRect();
  const place = ((clientX - left) / drawn) * width;
  const [low, high] = x.domain;
  return low + ((place - LEFT) / (width - LEFT - RIGHT)) * (high - low);
}

/** The time under the pointer, while it is pressed. */
export function listenToTime(
  element: SVGSVGElement,
  x: () => Scale | null,
  box: () => Box,
  onTime: (time: number) => void,
): void {
  const pick = (event: PointerEvent): void => {
    const scale = x();
    if (scale) onTime(timeAt(element, box(), scale, event.clientX));
  };
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    pick(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (element.hasPointerCapture(event.pointerId)) pick(event);
  });
}
