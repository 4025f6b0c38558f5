/** A chart of coordinates over time in its figure, with key dots and the natural spline's curves under its own. */
import type { Plot } from '../../model/state.ts';
import { createLineChart } from '../../plots/line-chart.ts';
import type { LineChart, LineChartData, Series } from '../../plots/line-chart.ts';
import { h, setText } from '../../ui/dom.ts';
import { chartNumbers } from './chart-numbers.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';

export interface CoordinateChartEvents extends FigureEvents {
  onSeek(t: number): void;
}

type Drawn = Omit<LineChartData, 'title' | 'unit'>;

export interface CoordinateChart extends Pick<LineChart, 'setCursor'> {
  element: HTMLElement;
  /** `title`: another one than before. */
  draw(data: Drawn, title?: string): void;
}

/** Marks a curve as the natural spline's. */
const UNSHAPED = 'unshaped';
/** Of curves that are drawn behind one, and named together. */
export const OTHERS = 'others';

export function createCoordinateChart(
  name: Plot,
  title: string,
  unit: string,
  events: CoordinateChartEvents,
): CoordinateChart {
  const plot = createLineChart(events.onSeek);
  const legend = h('span', { class: 'legend' });
  const heading = h('strong', {}, title);
  let drawn: Drawn | null = null;
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': `plot-${name}` },
    h('figcaption', {}, heading, h('span', { class: 'unit' }, unit), legend),
    plot.element,
  );
  const numbers = () => drawn && chartNumbers(drawn);
  const redrawn = addFigureTools(element, { ...events, plot: name, title, numbers });
  return {
    element,
    draw(data, now = title) {
      drawn = data;
      setText(heading, now);
      plot.draw({ ...data, title: now, unit });
      redrawn();
      const own = data.series.filter(({ style }) => !style.includes(UNSHAPED));
      const named = own.filter((one, i) => own.findIndex(({ style }) => style === one.style) === i);
      legend.replaceChildren(
        ...named.map(({ label, style }) =>
          h('span', {}, h('i', { class: `swatch ${style}` }), style === OTHERS ? 'others' : label),
        ),
        ...(own.length < data.series.length ? [h('span', {}, h('i', { class: `swatch ${UNSHAPED}` }), 'natural')] : []),
      );
    },
    setCursor: plot.setCursor,
  };
}

/** The curves with those of the natural spline under them; null: they are the natural spline's own. */
export function overNatural(own: readonly Series[], natural: readonly Series[] | null): Series[] {
  const under = natural ?? [];
  return [
    ...under.map(({ label, values, style }) => ({
      label: `${label} natural`,
      values,
      style: `${style} ${UNSHAPED}`,
    })),
    ...own,
  ];
}
