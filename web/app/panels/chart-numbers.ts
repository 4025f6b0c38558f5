/** The values of a chart over time. */
import type { LineChartData } from '../../plots/line-chart.ts';
import type { FigureNumbers } from './figure-files.ts';

/** A chart without its title and unit. */
export interface ChartCurves extends Omit<LineChartData, 'title' | 'unit'> {
  /** What is measured, for the names in a table, where a chart has a choice. */
  measure?: string;
}

export function chartNumbers({ times, series, keyTimes, measure }: ChartCurves): FigureNumbers {
  return {
    names: ['Time', ...series.map(({ label }) => (measure ? `${label}, ${measure}` : label))],
    rows: times.map((t, index) => [t, ...series.map(({ values }) => values[index] ?? NaN)]),
    keep: keyTimes,
  };
}
