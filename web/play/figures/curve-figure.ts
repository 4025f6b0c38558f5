/** The keys with the curves through them: over time, or in the plane of two dimensions. */
import { clamp } from '../../model/time-scale.ts';
import type { End } from '../../plots/end-handle.ts';
import { make, text } from '../../plots/svg-parts.ts';
import { extent, padded, tickLabel, ticks } from '../../plots/scale.ts';
import type { Derived, Shown } from '../derived.ts';
import { valueAt } from '../splines/curve.ts';
import { shownTimes } from '../state.ts';
import type { Layer, PlayState } from '../state.ts';
import { createEndHandles } from './end-handles.ts';
import type { Part } from './figure.ts';
import { createKeyHandles } from './key-handles.ts';
import type { KeyHandleEvents } from './key-handles.ts';
import { curveLines } from './lines.ts';
import { BOTTOM, TOP, axesOf, createPicture, gridLines, timeAxes } from './plot.ts';
import type { Axes, Box, Marks } from './plot.ts';
import { LAYER_WORDS } from './words.ts';

export interface CurveFigureEvents extends Omit<KeyHandleEvents, 'onHold'> {
  onSpeed(end: End, speed: number): void;
}

type Point = readonly [number, number];
/** Position of a curve's values at a time in the plot. */
type Place = (numbers: readonly number[], t: number) => Point;

export function createCurveFigure({ onSpeed, ...events }: CurveFigureEvents): Part<SVGSVGElement> {
  let held: Axes | null = null;
  const picture = createPicture('curve-figure', (width) => clamp(width * 0.52, 240, 440), draw);
  const { element, update } = picture;
  element.setAttribute('role', 'group');
  const curves = make('g', {});
  const keys = createKeyHandles(element, {
    ...events,
    // Axes that adapt to a dragged key would move it away from the pointer.
    onHold(holding) {
      held = holding ? picture.axes() : null;
      if (!holding) picture.redraw();
    },
  });
  const ends = createEndHandles(element, onSpeed);
  element.append(curves, ...ends.elements, keys.element);

  function draw(shown: Shown, box: Box): Axes {
    const { state, derived, lit } = shown;
    const axes = state.plane ? planeAxes(box, state, held) : spanAxes(box, shown, held);
    const { x, y } = axes;
    const place: Place = (numbers, t) => [x(state.plane ? numbers[1]! : t), y(numbers[0]!)];
    const points = state.keys.map(({ value, across }, i) => place([value, across], derived.times[i]!));
    curves.replaceChildren(
      ...(state.plane
        ? planeGrid(box, axes)
        : timeAxes(box, axes, { ...marksOf(shown), selected: lit < 0 ? state.selected : lit })),
      ...picture.framed(state.layers.flatMap((layer) => layerParts(layer, derived, axes, state.plane, place))),
      ...cursorParts(shown, place),
    );
    keys.update(shown, points, axes);
    ends.update(state, points, box);
    element.setAttribute('aria-label', describe(state));
    return axes;
  }

  return { element, update };
}

export function marksOf({ state, derived }: Shown): Marks {
  return { keyTimes: derived.times, range: derived.range, selected: state.selected, cursor: state.time };
}

/** First and last time of plots over time. */
export function shownSpan({ range }: Derived): [number, number] {
  return shownTimes(range);
}

function spanAxes(box: Box, { state, derived }: Shown, held: Axes | null): Axes {
  const spread = padded(extent(state.keys.map(({ value }) => value)), 0.38, 0.05);
  return axesOf(box, shownSpan(derived), held?.y.domain ?? spread);
}

/** Both axes have the same scale, so distances are the same in every direction. */
function planeAxes(box: Box, { keys }: PlayState, held: Axes | null): Axes {
  if (held) return axesOf(box, held.x.domain, held.y.domain);
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

function layerParts(layer: Layer, derived: Derived, { x, y }: Axes, plane: boolean, place: Place): SVGElement[] {
  if (layer !== 'samples') return curveLines(layer, derived.curves[layer], 0, shownSpan(derived), place);
  const [value, across] = derived.samples;
  if (!value) return [];
  const points = value.times.map((t, i): Point => [x(plane ? across!.values[i]! : t), y(value.values[i]!)]);
  return [
    ...curveLines('samples', derived.sampled, 0, derived.range, place),
    ...points.map(([cx, cy]) => make('circle', { class: 'sample', cx, cy, r: points.length > 30 ? 2 : 3 })),
  ];
}

/** Each curve's point at the cursor's time. */
function cursorParts({ state: { time, layers }, derived: { curves } }: Shown, place: Place): SVGElement[] {
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
  return `${what}: ${keys.length} draggable keys. Curves through them: ${shown}. The table below has the numbers.`;
}
