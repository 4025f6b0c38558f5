/** Error or time over ghost mesh sizes (the paper's Fig. 8): one line per transfer or per shape. */
import { make, named, namedCurve, text } from './svg-parts.ts';
import { extent, linearScale, padded, tickLabel, ticks } from './scale.ts';

export interface GhostSeries {
  label: string;
  /** One value per size; may cover only the first sizes. */
  values: readonly number[];
  /** CSS class for its colour. */
  style: string;
}

export interface GhostChartData {
  title: string;
  unit: string;
  /** Labels of the sizes along the axis, evenly spaced. */
  sizes: readonly string[];
  series: readonly GhostSeries[];
  /** A horizontal reference line. */
  level: { label: string; value: number } | null;
}

const WIDTH = 272;
const HEIGHT = 118;
const LEFT = 36;
const RIGHT = 14;
const TOP = 10;
const BOTTOM = 18;

export function drawGhostChart(data: GhostChartData): SVGSVGElement {
  const { sizes, series, level } = data;
  const values = [0, ...series.flatMap((one) => [...one.values]), ...(level ? [level.value] : [])];
  const [low, high] = padded(extent(values), 0.1);
  const y = linearScale([Math.max(low, 0), high], HEIGHT - BOTTOM, TOP);
  const x = linearScale([0, Math.max(sizes.length - 1, 1)], LEFT + 12, WIDTH - RIGHT - 8);
  const element = make('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    class: 'plot ghost-chart',
    role: 'img',
    'aria-label': describe(data),
  });
  for (const value of ticks(y.domain, 3)) {
    element.append(
      make('line', { class: 'grid', x1: LEFT, x2: WIDTH - RIGHT, y1: y(value), y2: y(value) }),
      text('tick-y', LEFT - 5, y(value) + 3.5, tickLabel(value)),
    );
  }
  element.append(...sizes.map((size, index) => text('tick-x', x(index), HEIGHT - 4, size)));
  if (level)
    element.append(
      named(
        level.label,
        make('line', { class: 'level', x1: LEFT, x2: WIDTH - RIGHT, y1: y(level.value), y2: y(level.value) }),
      ),
    );
  for (const { label, values: own, style } of series) {
    const points = own.map((value, index) => [x(index), y(value)] as const);
    element.append(
      namedCurve(label, style, points),
      ...points.map(([cx, cy]) => make('circle', { class: `mark ${style}`, cx, cy, r: 2.6 })),
    );
  }
  return element;
}

function describe({ title, unit, sizes, series, level }: GhostChartData): string {
  const lines = series.map(
    ({ label, values }) =>
      `${label}: ${values.map((value, i) => `${tickLabel(Number(value.toPrecision(3)))} at ${sizes[i]}`).join(', ')}`,
  );
  return `${title} (${unit}) by faces of the ghost mesh. ${[...lines, ...(level ? [`${level.label}: ${tickLabel(Number(level.value.toPrecision(3)))}`] : [])].join('; ')}`;
}
