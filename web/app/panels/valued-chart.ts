/** A chart over time that shows the values at the cursor beside its title. */
import type { Plot } from '../../model/state.ts';
import { lineStyle, motionWords } from '../../model/method-words.ts';
import { tickLabel } from '../../plots/scale.ts';
import { h, setText } from '../../ui/dom.ts';
import type { Analysis } from '../analysis/analysis.ts';
import { createChartFigure } from './chart-figure.ts';
import type { ChartData, ChartEvents, ChartFigure } from './chart-figure.ts';

export function createValuedChart(name: Plot, title: string, unit: string, events: ChartEvents): ChartFigure {
  const value = h('span', { class: 'value', 'data-testid': `plot-${name}-value` }, '');
  const { element, draw, setCursor } = createChartFigure(name, { title, unit, value }, events);
  let drawn: ChartData | null = null;
  return {
    element,
    draw(data) {
      drawn = data;
      draw(data);
    },
    setCursor(t) {
      setCursor(t);
      if (drawn) setText(value, valuesAt(drawn, t));
    },
  };
}

/** One curve per motion of the analysis, with these values. */
export function motionCurves(
  { times, keyTimes, range, motions }: Analysis,
  values: readonly (readonly number[])[],
): ChartData {
  const series = motions.map((motion, index) => ({
    label: motionWords(motion).label,
    values: values[index]!,
    style: lineStyle(motion),
  }));
  return { times, keyTimes, range, series };
}

/** The values of all curves; empty if no curve has one. */
function valuesAt({ times, series }: ChartData, t: number): string {
  const after = times.findIndex((time) => time >= t);
  const at = after < 0 ? times.length - 1 : after;
  const numbers = series.map(({ values }) => values[at] ?? NaN);
  const words = numbers.map((number) => (Number.isFinite(number) ? tickLabel(number) : '–'));
  return numbers.some(Number.isFinite) ? words.join(' / ') : '';
}
