/** The coordinates of one face over time. */
import type { FaceCurve } from '../../engine/api/types.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { LineChartData, Series } from '../../plots/line-chart.ts';
import { h, setHidden } from '../../ui/dom.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { ChartEvents } from './chart-figure.ts';
import { createCoordinateChart, overNatural } from './coordinate-chart.ts';

export interface PartCharts {
  element: HTMLElement;
  /** Draws the coordinates of a face or patch of the first motion and returns a description. null clears the charts. */
  load(index: number | null, input: AnalysisInput | null): Promise<string>;
  setCursor(t: number): void;
}

export const TIMES = 97;
export const AXES = ['x', 'y', 'z'];
const STRETCHES = ['along the first edge', 'shear', 'across'];

export function createFaceCharts(events: ChartEvents): PartCharts {
  const turned = 'degrees, as a rotation vector';
  const rotation = createCoordinateChart('face-rotation', 'Rotation within its patch', turned, events);
  const stretch = createCoordinateChart('face-stretch', 'Stretch', 'of the face, relative to the reference', events);
  const element = h('div', { class: 'group', hidden: true }, rotation.element, stretch.element);
  let asked = 0;
  return {
    element,
    async load(face, input) {
      const [main] = input?.sequences ?? [];
      const mine = ++asked;
      if (face === null || !input || !main) {
        setHidden(element, true);
        return '';
      }
      const times = plottedTimes(input.range, input.keyTimes, TIMES);
      const curve = await main.sequence.faceCurve(face, times);
      if (mine !== asked) return '';
      setHidden(element, curve.patch < 0);
      if (curve.patch < 0) return 'has no area';
      const common = { times, keyTimes: input.keyTimes, range: input.range, dots: true };
      const log = main.sequence.options.stretch === 'log';
      rotation.draw({ ...common, series: seriesOf(curve, 0, AXES, 180 / Math.PI), include: 0, minSpan: 2 });
      stretch.draw({ ...common, series: seriesOf(curve, 3, STRETCHES, 1), include: log ? 0 : 1, minSpan: 0.04 });
      return `of patch ${curve.patch + 1}`;
    },
    setCursor(t) {
      for (const one of [rotation, stretch]) one.setCursor(t);
    },
  };
}

/** Three of the six numbers over time. */
function seriesOf(
  { numbers, natural }: FaceCurve,
  first: number,
  names: readonly string[],
  factor: number,
): LineChartData['series'] {
  const of = (list: readonly number[]): Series[] =>
    names.map((label, k) => ({
      label,
      values: Array.from({ length: list.length / 6 }, (_, i) => factor * list[6 * i + first + k]!),
      style: `axis-${k}`,
    }));
  return overNatural(of(numbers), isOther(numbers, natural) ? of(natural) : null);
}

/** Draws the natural spline for comparison if ends or keys are shaped. */
export function isOther(numbers: readonly number[], natural: readonly number[]): boolean {
  return natural.some((value, index) => value !== numbers[index]);
}
