/** Measures of the shown motions over time: volume, area, bending energy, and sliding of resting vertices. */
import type { Plot } from '../../model/state.ts';
import { lineStyle, motionWords } from '../../model/method-words.ts';
import type { Series } from '../../plots/line-chart.ts';
import { logFloor, tickLabel } from '../../plots/scale.ts';
import type { MotionMeasures } from '../../study/motion-measures.ts';
import { METHOD } from '../../engine/api/methods.ts';
import type { Method } from '../../engine/api/types.ts';
import { h, setHidden, setText } from '../../ui/dom.ts';
import { relativeToFirstKey } from '../analysis/analysis.ts';
import type { Analysis } from '../analysis/analysis.ts';
import { createChartFigure, legendEntry } from './chart-figure.ts';
import type { ChartData, ChartEvents, ChartFigure } from './chart-figure.ts';

export interface MeasureCharts {
  elements: HTMLElement[];
  /** Legend of the motions. */
  legend: HTMLElement;
  draw(analysis: Analysis): void;
  setCursor(t: number): void;
}

const RELATIVE = '% of the first key';
const BENDING = 'squared acceleration, relative, 1/s⁴';
const BENDING_UNIT = 'Relative to the mean deformation energy between keys';
const SLIDING = 'displacement of resting vertices, % of the model’s size';
/** Smaller values are rounding errors. */
const LEAST_SLIDING = 0.01;
const LEAST_BENDING = 1;

export function createMeasureCharts(events: ChartEvents): MeasureCharts {
  const volume = chart('volume', 'Volume', RELATIVE, events);
  const area = chart('area', 'Area', RELATIVE, events);
  const bending = chart('bending', 'Bending energy', BENDING, events);
  const sliding = chart('sliding', 'Foot sliding', SLIDING, events);
  bending.element.title = BENDING_UNIT;
  setHidden(sliding.element, true);
  const legend = h('div', { class: 'legend' });
  const charts = [volume, area, bending, sliding];
  return {
    elements: charts.map(({ element }) => element),
    legend,
    draw(analysis) {
      const { times, keyTimes, range, motions } = analysis;
      const dataOf = (pick: (motion: MotionMeasures) => number[]): ChartData => ({
        ...{ times, keyTimes, range },
        series: motions.map(
          (motion): Series => ({
            label: motionWords(motion).label,
            values: pick(motion),
            style: lineStyle(motion),
          }),
        ),
      });
      const relative = { include: 100, leastSpan: 4 };
      volume.draw({ ...dataOf((motion) => relativeToFirstKey(motion.volume, analysis)), ...relative });
      area.draw({ ...dataOf((motion) => relativeToFirstKey(motion.area, analysis)), ...relative });
      const floor = logFloor(motions.map((motion) => motion.bending));
      bending.draw({
        ...dataOf((motion) => motion.bending),
        ...{ include: 0, leastSpan: LEAST_BENDING, floor },
        unit: bendingUnit(
          motions.map(({ method }) => method),
          floor,
        ),
      });
      // Hides the chart if no vertex rests in any interval.
      setHidden(
        sliding.element,
        motions.every((motion) => motion.sliding.every(Number.isNaN)),
      );
      sliding.draw({ ...dataOf((motion) => motion.sliding), include: 0, leastSpan: LEAST_SLIDING });
      setHidden(legend, motions.length < 2);
      legend.replaceChildren(...motions.map((motion) => legendEntry(lineStyle(motion), motionWords(motion).label)));
    },
    setCursor(t) {
      for (const one of charts) one.setCursor(t);
    },
  };
}

/**
 * Bending energies are comparable within one space only. In its own space, a vertex blend has a lower energy, whether
 * it looks smoother or not.
 */
export function bendingUnit(methods: readonly Method[], floor: number | null): string {
  const spaces = new Set(methods.map((method) => METHOD[method].space));
  return [BENDING, ...(spaces.size > 1 ? ['each in its own coordinates'] : []), ...(floor ? ['logarithmic'] : [])].join(
    '; ',
  );
}

/** The value at the cursor is shown beside the title. */
function chart(name: Plot, title: string, unit: string, events: ChartEvents): ChartFigure {
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

/** The values of all curves; empty if no curve has one. */
function valuesAt({ times, series }: ChartData, t: number): string {
  const after = times.findIndex((time) => time >= t);
  const at = after < 0 ? times.length - 1 : after;
  const numbers = series.map(({ values }) => values[at] ?? NaN);
  const words = numbers.map((number) => (Number.isFinite(number) ? tickLabel(number) : '–'));
  return numbers.some(Number.isFinite) ? words.join(' / ') : '';
}
