/** A plot with axes, as wide as its column and redrawn when the width changes. */
import { make, text } from '../../plots/svg-parts.ts';
import { linearScale, tickLabel, ticks } from '../../plots/scale.ts';
import type { Scale } from '../../plots/scale.ts';
import { uniqueId } from '../../ui/dom.ts';
import type { Shown } from '../derived.ts';

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
  /** Axes of the plot as last drawn; null before that. */
  axes(): Axes | null;
  /** Clips the parts to the axes. */
  framed(parts: readonly SVGElement[]): SVGElement[];
  update(shown: Shown): void;
  redraw(): void;
}

/** An empty plot. `draw` is called with its size in CSS pixels whenever the size or the state changes. */
export function createPicture(
  style: string,
  heightOf: (width: number) => number,
  draw: (shown: Shown, box: Box) => Axes,
): Picture {
  const element = make('svg', { class: `plot ${style}` });
  const frame = make('rect', { x: LEFT, y: TOP - 6 });
  const clip = make('clipPath', { id: uniqueId('frame') });
  clip.append(frame);
  let box: Box = { width: 0, height: 0 };
  let axes: Axes | null = null;
  let shown: Shown | null = null;
  const redraw = (): void => {
    if (shown && box.width > 0) axes = draw(shown, box);
  };
  const resize = (width: number): void => {
    const rounded = Math.max(Math.round(width), 200);
    if (rounded === box.width) return;
    box = { width: rounded, height: Math.round(heightOf(rounded)) };
    element.setAttribute('viewBox', `0 0 ${box.width} ${box.height}`);
    frame.setAttribute('width', String(box.width - LEFT - RIGHT));
    frame.setAttribute('height', String(box.height - TOP - BOTTOM + 6));
    redraw();
  };
  new ResizeObserver(([entry]) => resize(entry!.contentRect.width)).observe(element);
  return {
    element,
    box: () => box,
    axes: () => axes,
    framed(parts) {
      const group = make('g', { 'clip-path': `url(#${clip.id})` });
      group.append(...parts);
      return [clip, group];
    },
    update(next) {
      shown = next;
      redraw();
    },
    redraw,
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
  /** The highlighted key. */
  selected: number;
  cursor: number | null;
}

/** Grid, keys and shaded extrapolation of a plot over time. */
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
      text(index === selected ? 'tick-x on-page lit' : 'tick-x on-page', x(t), height - 6, String(index + 1)),
    ]),
    ...ticks(x.domain, 6).map((t) => text('tick-x in-file', x(t), height - 6, tickLabel(t))),
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

/** Reports the time under the pointer while pressed. */
export function listenToTime({ element, box, axes }: Picture, onTime: (time: number) => void): void {
  const pick = ({ clientX }: PointerEvent): void => {
    const domain = axes()?.x.domain;
    if (!domain) return;
    const { left, width: drawn } = element.getBoundingClientRect();
    const { width } = box();
    const place = ((clientX - left) / drawn) * width;
    onTime(domain[0] + ((place - LEFT) / (width - LEFT - RIGHT)) * (domain[1] - domain[0]));
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
