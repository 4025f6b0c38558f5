/** A chart over time with the tools of all figures. */
import type { Plot } from '../../model/state.ts';
import { createLineChart } from '../../plots/line-chart.ts';
import type { LineChart, LineChartData } from '../../plots/line-chart.ts';
import { h, setText, svg } from '../../ui/dom.ts';
import type { ChartChoices } from '../view/view-state.ts';
import { chartNumbers } from './chart-numbers.ts';
import type { ChartCurves } from './chart-numbers.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';

export interface ChartEvents extends FigureEvents {
  onSeek(t: number): void;
}

/** Reports choices inside charts. */
export interface ChoiceEvents {
  onCharts(choices: Partial<ChartChoices>): void;
}

export interface ChartCaption {
  title: string;
  unit: string;
  /** Element before the unit. */
  value?: HTMLElement;
  legend?: HTMLElement;
}

/** Title and unit only if they changed. */
export type ChartData = ChartCurves & Partial<Pick<LineChartData, 'title' | 'unit'>>;

export interface ChartFigure extends Pick<LineChart, 'setCursor'> {
  element: HTMLElement;
  draw(data: ChartData): void;
}

export function createChartFigure(
  name: Plot,
  { title, unit, value, legend }: ChartCaption,
  events: ChartEvents,
): ChartFigure {
  const plot = createLineChart(events.onSeek);
  const heading = h('strong', {}, title);
  const counted = h('span', { class: 'unit' }, unit);
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': `plot-${name}` },
    h('figcaption', {}, heading, value, counted, legend),
    plot.element,
  );
  let drawn: (LineChartData & ChartData) | null = null;
  const numbers = () => drawn && chartNumbers(drawn);
  const redrawn = addFigureTools(element, { ...events, plot: name, title, numbers });
  return {
    element,
    draw(data) {
      drawn = { title, unit, ...data };
      setText(heading, drawn.title);
      setText(counted, drawn.unit);
      plot.draw(drawn);
      redrawn();
    },
    setCursor: plot.setCursor,
  };
}

/** Label for a line of this style. */
export function legendEntry(style: string, label: string): HTMLElement {
  const line = svg('line', { class: style, x1: 0, x2: 22, y1: 4, y2: 4 });
  return h('span', {}, svg('svg', { viewBox: '0 0 22 8', 'aria-hidden': 'true' }, line), label);
}
