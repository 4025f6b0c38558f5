/** Measures of the shown motions over time: volume, area, bending energy, and sliding of resting vertices. */
import { lineStyle, motionWords } from '../../model/method-words.ts';
import type { MotionMeasures } from '../../study/motion-measures.ts';
import { h, setHidden } from '../../ui/dom.ts';
import { relativeToFirstKey } from '../analysis/analysis.ts';
import type { Analysis, AnalysisInput } from '../analysis/analysis.ts';
import type { ChartChoices } from '../view/view-state.ts';
import { createBendingFigure } from './bending-figure.ts';
import type { BendingEvents } from './bending-figure.ts';
import { legendEntry } from './chart-figure.ts';
import type { ChartData } from './chart-figure.ts';
import { createValuedChart, motionCurves } from './valued-chart.ts';

export interface MeasureCharts {
  elements: HTMLElement[];
  /** Legend of the motions. */
  legend: HTMLElement;
  draw(analysis: Analysis): void;
  /** The motions have changed since the last drawing. */
  outdate(): void;
  /** The computed share of the next analysis; null if none is being computed. */
  setWorking(fraction: number | null): void;
  choose(choices: ChartChoices): void;
  setCursor(t: number): void;
}

const RELATIVE = '% of the first key';
const SLIDING = 'displacement of resting vertices, % of the model’s size';
/** Smaller values are rounding errors. */
const MIN_SLIDING = 0.01;

export function createMeasureCharts(input: () => AnalysisInput | null, events: BendingEvents): MeasureCharts {
  const volume = createValuedChart('volume', 'Volume', RELATIVE, events);
  const area = createValuedChart('area', 'Area', RELATIVE, events);
  const bending = createBendingFigure(input, events);
  const sliding = createValuedChart('sliding', 'Foot sliding', SLIDING, events);
  setHidden(sliding.element, true);
  const legend = h('div', { class: 'legend' });
  const charts = [volume, area, bending, sliding];
  return {
    elements: charts.map(({ element }) => element),
    legend,
    draw(analysis) {
      const { motions } = analysis;
      const dataOf = (pick: (motion: MotionMeasures) => number[]): ChartData =>
        motionCurves(analysis, motions.map(pick));
      const relative = { include: 100, minSpan: 4 };
      volume.draw({ ...dataOf((motion) => relativeToFirstKey(motion.volume, analysis)), ...relative });
      area.draw({ ...dataOf((motion) => relativeToFirstKey(motion.area, analysis)), ...relative });
      bending.draw(analysis);
      // Hides the chart if no vertex rests in any interval.
      setHidden(
        sliding.element,
        motions.every((motion) => motion.sliding.every(Number.isNaN)),
      );
      sliding.draw({ ...dataOf((motion) => motion.sliding), include: 0, minSpan: MIN_SLIDING });
      setHidden(legend, motions.length < 2);
      legend.replaceChildren(...motions.map((motion) => legendEntry(lineStyle(motion), motionWords(motion).label)));
    },
    outdate: bending.outdate,
    setWorking: bending.setWorking,
    choose: ({ shellBending }) => bending.setShell(shellBending),
    setCursor(t) {
      for (const one of charts) one.setCursor(t);
    },
  };
}
