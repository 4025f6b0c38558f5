/** The keys with the curves through them: over time, or in two dimensions in their plane. */
import { createEndHandle } from '../../plots/end-handle.ts';
import type { End, EndHandle } from '../../plots/end-handle.ts';
import { make, namedCurve, text } from '../../plots/svg-parts.ts';
import { extent, padded, tickLabel, ticks } from '../../plots/scale.ts';
import type { Derived } from '../derived.ts';
import { valueAt } from '../splines/curve.ts';
import { MOST_SPEED, shownTimes } from '../state.ts';
import type { Layer, PlayState } from '../state.ts';
import { clipped } from './clip.ts';
import { createKeyHandles } from './key-handles.ts';
import type { KeyHandleEvents } from './key-handles.ts';
import { curveLines } from './lines.ts';
import { BOTTOM, TOP, axesOf, createPicture, gridLines, timeAxes } from './plot.ts';
import type { Axes, Box } from './plot.ts';
import { LAYER_WORDS } from './words.ts';

export interface CurveFigureEvents extends KeyHandleEvents {
  onSpeed(end: End, speed: number): void;
}

export interface CurveFigure {
  element: SVGSVGElement;
  /** lit: a key to point at, besides the selected one; -1 = none. */
  update(state: PlayState, derived: Derived, lit: number): void;
}

/** A handle of speed 1 ends halfway to the next key. */
const HANDLE = 1 / 2;

type Point = readonly [number, number];

export function createCurveFigure(events: CurveFigureEvents): CurveFigure {
  let shown: { state: PlayState; derived: Derived; lit: number } | null = null;
  let axes: Axes | null = null;
  /** Speeds by keys that came since the page was drawn: each goes on from what the one before has asked for. */
  let pressed: Partial<Record<End, number>> = {};
  let held: { x: readonly [number, number]; y: readonly [number, number] } | null = null;
  const redraw = (): void => {
    if (shown) draw(shown.state, shown.derived, shown.lit);
  };
  const picture = createPicture('curve-figure', (width) => Math.min(Math.max(width * 0.52, 240), 440), redraw);
  const { element } = picture;
  element.setAttribute('role', 'group');
  const curves = make('g', {});
  const keys = createKeyHandles(element, {
    ...events,
    // Axes that followed a dragged key would run away from it.
    onHold(holding) {
      held = holding && axes ? { x: axes.x.domain, y: axes.y.domain } : null;
      events.onHold(holding);
      if (!holding) redraw();
    },
  });
  const handleOf = (end: End): EndHandle =>
    createEndHandle(end, element, {
      label: (at) => (at === 'start' ? 'Speed at the first key' : 'Speed at the last key'),
      words: (speed) => speed.toFixed(2),
      onSpeed: (at, speed) => events.onSpeed(at, Math.min(Math.max(speed, 0), MOST_SPEED)),
      onKey(at, event) {
        const step = { ArrowUp: 0.1, ArrowRight: 0.1, ArrowDown: -0.1, ArrowLeft: -0.1 }[event.key];
        if (step === undefined || !shown) return;
        event.preventDefault();
        const from = pressed[at] ?? shown.state.speeds[at === 'start' ? 0 : 1];
        const speed = Math.min(Math.max(from + step * (event.shiftKey ? 10 : 1), 0), MOST_SPEED);
        pressed = { ...pressed, [at]: speed };
        events.onSpeed(at, speed);
      },
      onReset: (at) => events.onSpeed(at, 1),
    });
  const handles = { start: handleOf('start'), end: handleOf('end') };
  element.append(curves, handles.start.element, handles.end.element, keys.element);

  function draw(state: PlayState, derived: Derived, lit: number): void {
    const box = picture.box();
    if (box.width === 0) return;
    axes = state.plane ? planeAxes(box, state, held) : spanAxes(box, state, derived, held);
    const { x, y } = axes;
    const place = (numbers: readonly number[], t: number): Point =>
      state.plane ? [x(numbers[1]!), y(numbers[0]!)] : [x(t), y(numbers[0]!)];
    const values = state.keys.map((key) => [key.value, key.across]);
    const points = values.map((numbers, i) => place(numbers, derived.times[i]!));
    curves.replaceChildren(
      ...(state.plane
        ? planeGrid(box, axes)
        : timeAxes(box, axes, { ...marksOf(state, derived), selected: lit < 0 ? state.selected : lit })),
      ...picture.framed(state.layers.flatMap((layer) => layerParts(layer, derived, axes!, state.plane, place))),
      ...cursorParts(state, derived, place),
    );
    keys.update(state, derived.times, points, axes, lit);
    placeHandles(state, derived, place, box);
    element.setAttribute('aria-label', describe(state));
  }

  function placeHandles(
    state: PlayState,
    { times }: Derived,
    place: (n: readonly number[], t: number) => Point,
    box: Box,
  ): void {
    const on = state.layers.includes('hermite') || (state.ends === 'hermite' && state.layers.includes('shaped'));
    const at = (i: number): Point => place([state.keys[i]!.value, state.keys[i]!.across], times[i]!);
    const last = state.keys.length - 1;
    const put = (handle: EndHandle, from: Point, towards: Point, speed: number): void => {
      const unit: Point = [(towards[0] - from[0]) * HANDLE, (towards[1] - from[1]) * HANDLE];
      handle.place(on ? { from, unit, width: box.width, height: box.height } : null);
      handle.setSpeed(on ? speed : null, MOST_SPEED);
    };
    put(handles.start, at(0), at(1), state.speeds[0]);
    put(handles.end, at(last), at(last - 1), state.speeds[1]);
  }

  return {
    element,
    update(state, derived, lit) {
      pressed = {};
      shown = { state, derived, lit };
      redraw();
    },
  };
}

export function marksOf(
  state: PlayState,
  { times, range }: Derived,
): { keyTimes: number[]; range: readonly [number, number]; selected: number; cursor: number } {
  return { keyTimes: times, range, selected: state.selected, cursor: state.time };
}

/** First and last time that plots over time show. */
export function shownSpan({ range }: Derived): [number, number] {
  return shownTimes(range);
}

type Held = { x: readonly [number, number]; y: readonly [number, number] } | null;

function spanAxes(box: Box, { keys }: PlayState, derived: Derived, held: Held): Axes {
  const spread = padded(extent(keys.map(({ value }) => value)), 0.38, 0.05);
  return axesOf(box, shownSpan(derived), held?.y ?? spread);
}

/** One scale for both axes: a step is as long in every direction. */
function planeAxes(box: Box, { keys }: PlayState, held: Held): Axes {
  if (held) return axesOf(box, held.x, held.y);
  const xs = padded(extent(keys.map(({ across }) => across)), 0.2, 0.05);
  const ys = padded(extent(keys.map(({ value }) => value)), 0.3, 0.05);
  const plain = axesOf(box, [0, 1], [0, 1]);
  const [width, height] = [plain.x(1) - plain.x(0), plain.y(0) - plain.y(1)];
  const unit = Math.max((xs[1] - xs[0]) / width, (ys[1] - ys[0]) / height);
  const around = ([low, high]: [number, number], size: number): [number, number] => [
    (low + high - size * unit) / 2,
    (low + high + size * unit) / 2,
  ];
  return axesOf(box, around(xs, width), around(ys, height));
}

function planeGrid({ width, height }: Box, { x, y }: Axes): SVGElement[] {
  return [
    ...gridLines(width, y, 4),
    ...ticks(x.domain, 6).flatMap((value) => [
      make('line', { class: 'grid', x1: x(value), x2: x(value), y1: TOP, y2: height - BOTTOM }),
      text('tick-x', x(value), height - 6, tickLabel(value)),
    ]),
  ];
}

function layerParts(
  layer: Layer,
  derived: Derived,
  { x, y }: Axes,
  plane: boolean,
  place: (n: number[], t: number) => Point,
): SVGElement[] {
  if (layer !== 'samples') return curveLines(layer, derived.curves[layer], 0, shownSpan(derived), place);
  const [value, across] = derived.samples;
  if (!value) return [];
  const points = value.times.map((t, i): Point => [x(plane ? across!.values[i]! : t), y(value.values[i]!)]);
  return [
    namedCurve(LAYER_WORDS.samples.name, 'samples', clipped(points)),
    ...points.map(([cx, cy]) => make('circle', { class: 'sample', cx, cy, r: points.length > 30 ? 2 : 3 })),
  ];
}

/** Where each curve is at the time of the cursor. */
function cursorParts(
  { time, layers }: PlayState,
  { curves }: Derived,
  place: (n: number[], t: number) => Point,
): SVGElement[] {
  return layers.flatMap((layer) => {
    if (layer === 'samples') return [];
    const [cx, cy] = place(
      curves[layer].map((curve) => valueAt(curve, time)),
      time,
    );
    return [make('circle', { class: `now-mark ${layer}`, cx, cy, r: 4.5 })];
  });
}

function describe({ keys, layers, plane, taken }: PlayState): string {
  const shown = layers.map((layer) => LAYER_WORDS[layer].name).join(', ') || 'no curve';
  const what = taken ? `${taken.name} (${taken.unit})` : plane ? 'Points in a plane' : 'Values over time';
  return `${what}: ${keys.length} keys that can be dragged, and through them: ${shown}. The table below has the numbers.`;
}
