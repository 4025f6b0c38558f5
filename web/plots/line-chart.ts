/** Curves over time, with key marks, shaded extrapolation, and a cursor at the current time. */
import { createReadOut } from './read-out.ts';
import { apart, decades, extent, linearScale, logScale, padded, tickLabel, ticks, written } from './scale.ts';
import type { Scale } from './scale.ts';
import { make, namedCurve, text } from './svg-parts.ts';

export interface Series {
  label: string;
  /** One value per time of the chart. */
  values: readonly number[];
  /** CSS class for its colour. */
  style: string;
}

export interface LineChartData {
  title: string;
  /** Quantity and unit of the vertical axis. */
  unit: string;
  times: readonly number[];
  series: readonly Series[];
  keyTimes: readonly number[];
  /** The range of the keys; outside it the curve is extrapolated. */
  range: readonly [number, number];
  /** Smallest span of the vertical axis, so noise does not fill the plot. */
  minSpan?: number;
  /** A value that is always visible. */
  include?: number;
  /** Lower end of a logarithmic vertical axis; lower values lie on the edge. null: linear. */
  floor?: number | null;
  /** Marks every series at the keys, whose times are among the chart's. */
  dots?: boolean;
}

const WIDTH = 272;
const HEIGHT = 112;
const LEFT = 36;
const RIGHT = 6;
const TOP = 8;
const BOTTOM = 16;
/** Smallest distance between key numbers. */
const KEY_NUMBERS = 13;
/**
 * Beyond the keys, curves extend the axis at most by their span between the keys, or by this share of the highest value
 * if larger.
 */
const FOLLOWED = 0.2;

export interface LineChart {
  element: SVGSVGElement;
  draw(data: LineChartData): void;
  /** Moves the cursor without redrawing the rest. */
  setCursor(t: number): void;
}

export function createLineChart(onPick: (t: number) => void): LineChart {
  const element = make('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    class: 'plot line-chart',
    role: 'img',
    tabindex: 0,
    'aria-label': 'Being computed',
  });
  const content = make('g', {});
  const cursor = make('line', { class: 'cursor', y1: TOP, y2: HEIGHT - BOTTOM });
  const readOut = createReadOut({ left: LEFT, right: WIDTH - RIGHT, top: TOP, bottom: HEIGHT - BOTTOM });
  element.append(content, cursor, readOut.element);
  let x: Scale | null = null;
  let drawn: { data: LineChartData; seen: (value?: number) => number } | null = null;
  let now = 0;
  /** Time under the mouse or finger. */
  let pointed: number | null = null;

  const read = (): void => {
    const t = pointed ?? (element.matches(':focus-visible') ? now : null);
    if (x && drawn) readOut.show(drawn.data, t, x, drawn.seen);
  };
  const timeAt = (event: PointerEvent): number => {
    const box = element.getBoundingClientRect();
    const place = ((event.clientX - box.left) / box.width) * WIDTH;
    const [low, high] = x!.domain;
    const t = low + ((place - LEFT) / (WIDTH - LEFT - RIGHT)) * (high - low);
    return Math.min(Math.max(t, low), high);
  };
  const point = (event: PointerEvent | null): void => {
    pointed = event && x ? timeAt(event) : null;
    read();
  };

  element.addEventListener('pointerdown', (event) => {
    if (!x) return;
    const pick = (at: PointerEvent): void => onPick(timeAt(at));
    event.preventDefault();
    element.setPointerCapture(event.pointerId);
    element.addEventListener('pointermove', pick);
    element.addEventListener('pointerup', () => element.removeEventListener('pointermove', pick), { once: true });
    pick(event);
    point(event);
  });
  element.addEventListener('pointermove', point);
  for (const end of ['pointerleave', 'pointercancel'] as const) element.addEventListener(end, () => point(null));
  for (const change of ['focus', 'blur'] as const) element.addEventListener(change, read);

  return {
    element,
    draw(data) {
      x = linearScale(extent(data.times), LEFT, WIDTH - RIGHT);
      const axis = vertical(data);
      const seen = within(axis.y, data);
      content.replaceChildren(...parts(data, x, axis, seen));
      element.setAttribute('aria-label', describe(data));
      drawn = { data, seen };
      read();
    },
    setCursor(t) {
      now = t;
      if (!x) return;
      const place = Math.min(Math.max(x(t), LEFT), WIDTH - RIGHT).toFixed(2);
      cursor.setAttribute('x1', place);
      cursor.setAttribute('x2', place);
      if (pointed === null) read();
    },
  };
}

/** Position of a value; NaN outside the plot. */
function within(y: Scale, { floor }: LineChartData): (value?: number) => number {
  return (value = NaN) => (value > y.domain[1] || (value < y.domain[0] && !floor) ? NaN : y(value));
}

function parts(data: LineChartData, x: Scale, { y, levels }: Axis, seen: (value?: number) => number): SVGElement[] {
  const [start, end] = data.range;
  const shade = (from: number, to: number): SVGElement =>
    make('rect', {
      class: 'beyond',
      x: from,
      y: TOP,
      width: Math.max(to - from, 0),
      height: HEIGHT - BOTTOM - TOP,
    });
  return [
    shade(LEFT, x(start)),
    shade(x(end), WIDTH - RIGHT),
    ...levels.flatMap(({ value, label }) => [
      make('line', { class: 'grid', x1: LEFT, x2: WIDTH - RIGHT, y1: y(value), y2: y(value) }),
      text('tick-y', LEFT - 5, y(value) + 3.5, label),
    ]),
    ...data.keyTimes.map((time) =>
      make('line', { class: 'key-line', x1: x(time), x2: x(time), y1: TOP, y2: HEIGHT - BOTTOM }),
    ),
    ...apart(data.keyTimes.map(x), KEY_NUMBERS).map((index) =>
      text('tick-x on-page', x(data.keyTimes[index]!), HEIGHT - 4, String(index + 1)),
    ),
    ...ticks(x.domain, 5).map((time) => text('tick-x in-file', x(time), HEIGHT - 4, tickLabel(time))),
    ...data.series.map((series) =>
      namedCurve(
        series.label,
        series.style,
        data.times.map((t, index) => [x(t), seen(series.values[index])]),
      ),
    ),
    ...(data.dots ? keyDots(data, x, y) : []),
  ];
}

/** The vertical axis and its labels. */
interface Axis {
  y: Scale;
  levels: { value: number; label: string }[];
}

function vertical(data: LineChartData): Axis {
  const { floor, minSpan = 0 } = data;
  const span = followed(data);
  if (floor) {
    const y = logScale([floor, span[1] * (span[1] / floor) ** 0.08], HEIGHT - BOTTOM, TOP);
    const label = (value: number): string => `${value === floor ? '≤ ' : ''}${written(value.toExponential(0))}`;
    return { y, levels: decades(y.domain, 3).map((value) => ({ value, label: label(value) })) };
  }
  const around = padded(span, 0.08, Math.max(0, (minSpan - (span[1] - span[0])) / 2));
  const y = linearScale(around, HEIGHT - BOTTOM, TOP);
  return { y, levels: ticks(y.domain, 3).map((value) => ({ value, label: tickLabel(value) })) };
}

/** Lowest and highest visible value; values far off beyond the keys are cut off. */
function followed({ times, series, range: [start, end], include, minSpan = 0 }: LineChartData): [number, number] {
  const spanOf = (isIn: (t: number) => boolean): [number, number] =>
    extent([
      ...series.flatMap(({ values }) => values.filter((_, index) => isIn(times[index]!))),
      ...(include === undefined ? [] : [include]),
    ]);
  const [low, high] = spanOf((t) => t >= start && t <= end);
  const [least, most] = spanOf(() => true);
  const room = Math.max(high - low, minSpan, FOLLOWED * Math.max(high, -low));
  return [Math.max(least, low - room), Math.min(most, high + room)];
}

function keyDots({ times, keyTimes, series }: LineChartData, x: Scale, y: Scale): SVGElement[] {
  return keyTimes.flatMap((time) => {
    const index = times.indexOf(time);
    return series.map(({ values }) =>
      make('circle', { class: 'dot', cx: x(time), cy: y(values[index] ?? NaN), r: 2.6 }),
    );
  });
}

function describe({ title, unit, series, times }: LineChartData): string {
  const spans = series.map(({ label, values }) => {
    const [low, high] = extent(values);
    return `${label} from ${tickLabel(low)} to ${tickLabel(high)}`;
  });
  return `${title} (${unit}) at ${times.length} times: ${spans.join('; ')}`;
}
