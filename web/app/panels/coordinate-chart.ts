/** A chart of coordinates over time with key dots. The natural spline's curves are drawn in the background. */
import type { Plot } from '../../model/state.ts';
import type { Series } from '../../plots/line-chart.ts';
import { h } from '../../ui/dom.ts';
import { createChartFigure } from './chart-figure.ts';
import type { ChartEvents, ChartFigure } from './chart-figure.ts';

/** Marks a curve of the natural spline. */
const UNSHAPED = 'unshaped';
/** Group name of the background curves. */
export const OTHERS = 'others';

export function createCoordinateChart(name: Plot, title: string, unit: string, events: ChartEvents): ChartFigure {
  const legend = h('span', { class: 'legend' });
  const { element, draw, setCursor } = createChartFigure(name, { title, unit, legend }, events);
  return {
    element,
    draw(data) {
      draw(data);
      const own = data.series.filter(({ style }) => !style.includes(UNSHAPED));
      const named = own.filter((one, i) => own.findIndex(({ style }) => style === one.style) === i);
      legend.replaceChildren(
        ...named.map(({ label, style }) =>
          h('span', {}, h('i', { class: `swatch ${style}` }), style === OTHERS ? 'others' : label),
        ),
        ...(own.length < data.series.length ? [h('span', {}, h('i', { class: `swatch ${UNSHAPED}` }), 'natural')] : []),
      );
    },
    setCursor,
  };
}

/** The curves above those of the natural spline; null if the motion is the natural spline. */
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
