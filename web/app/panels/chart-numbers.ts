/** The values of a chart over time. */
import type { LineChartData } from '../../plots/line-chart.ts';
import type { FigureNumbers } from './figure-files.ts';

export function chartNumbers({ times, series, keyTimes }: Omit<LineChartData, 'title' | 'unit'>): FigureNumbers {
  return {
    names: ['Time', ...series.map(({ label }) => label)],
    rows: times.map((t, index) => [t, ...series.map(({ values }) => values[index] ?? NaN)]),
    keep: keyTimes,
  };
}
