/** The Analysis panel: shape plane and measures of the shown motions over time, computed when idle. */
import type { End } from '../../model/speeds.ts';
import { createLineChart } from '../../plots/line-chart.ts';
import { make } from '../../plots/svg-parts.ts';
import type { LineChart } from '../../plots/line-chart.ts';
import { logFloor, tickLabel } from '../../plots/scale.ts';
import type { Colouring, Plot } from '../../model/state.ts';
import { h, setHidden, setText } from '../../ui/dom.ts';
import { lineStyle, motionWords } from '../../model/method-words.ts';
import { relativeToFirstKey } from '../analysis/analysis.ts';
import type { MotionMeasures, MotionName } from '../../study/motion-measures.ts';
import type { Analysis } from '../analysis/analysis.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { FacesFigure, FacesFigureEvents, FacesFigureProps } from './faces-figure.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';
import { chartNumbers } from './chart-numbers.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import { createShapePlaneFigure } from './shape-plane-figure.ts';
import type { Blend } from '../view/view-state.ts';
import type { ShapePlaneFigure } from './shape-plane-figure.ts';

export interface AnalysisPanelEvents extends FigureEvents {
  onSeek(t: number): void;
  onSpeed(end: End, speed: number): void;
  onBlend(blend: Blend | null): void;
  onColouring: FacesFigureEvents['onColouring'];
  onMark: FacesFigureEvents['onMark'];
  compared: FacesFigureEvents['compared'];
  onPickTruth: FacesFigureEvents['onPickTruth'];
  onLeaveTruth: FacesFigureEvents['onLeaveTruth'];
}

export interface AnalysisPanelProps {
  time: number;
  colouring: Colouring;
  blend: Parameters<ShapePlaneFigure['setBlend']>[0];
  keys: Parameters<ShapePlaneFigure['setBlend']>[1];
  speeds: Parameters<ShapePlaneFigure['setSpeeds']>[0];
  mostSpeeds: Parameters<ShapePlaneFigure['setSpeeds']>[1];
}

export interface AnalysisPanel {
  element: HTMLElement;
  update(props: AnalysisPanelProps): void;
  clicked: FacesFigure['clicked'];
}

/** While edits follow each other nothing is computed. */
const DELAY_MS = 200;
const RELATIVE = '% of the first key';
const BENDING = 'curvature of the motion, relative';
const BENDING_UNIT = 'Relative to the mean deformation energy between keys, per time⁴';
/** Below it there is nothing but rounding to be seen. */
const LEAST_SLIDING = 0.01;
const LEAST_BENDING = 1;
const SLIDING = 'distance of what rests between keys from its place, % of the diagonal';

/** Fills its place, `element`. */
export function createAnalysisPanel(
  element: HTMLElement,
  cache: AnalysisCache,
  events: AnalysisPanelEvents,
): AnalysisPanel {
  const { onSpeed, onBlend, onEnlarge, onError } = events;
  const plane = createShapePlaneFigure(cache.input, { onSpeed, onBlend, onEnlarge, onError });
  const faces = lazyComponent<FacesFigureProps, FacesFigure>(async () => {
    const { createFacesFigure } = await import('./faces-figure.ts');
    return createFacesFigure(cache.input, events);
  }, onError);
  void faces.need();
  let facesProps: FacesFigureProps = { cursor: 0, colouring: 'texture', version: 0 };
  const updateFaces = (change: Partial<FacesFigureProps>): void => {
    facesProps = { ...facesProps, ...change };
    faces.update(facesProps);
  };
  const volume = chart('Volume', RELATIVE, 'volume', events);
  const area = chart('Area', RELATIVE, 'area', events);
  const bending = chart('Bending energy', BENDING, 'bending', events);
  const sliding = chart('Sliding of what rests', SLIDING, 'sliding', events);
  bending.element.title = BENDING_UNIT;
  setHidden(sliding.element, true);
  const legend = h('div', { class: 'legend' });
  element.append(legend, plane.element, volume.element, area.element, bending.element, sliding.element, faces.element);
  let visible = false;
  let timer = 0;
  let cursor = 0;

  const setCursor = (t: number): void => {
    cursor = t;
    plane.setCursor(t);
    updateFaces({ cursor: t });
    for (const figure of [volume, area, bending, sliding]) figure.setCursor(t);
  };

  const draw = (analysis: Analysis): void => {
    const { times, keyTimes, range, motions } = analysis;
    const series = (pick: (motion: MotionMeasures) => number[]): Series[] =>
      motions.map((motion) => ({
        label: motionWords(motion).label,
        values: pick(motion),
        style: lineStyle(motion),
      }));
    const common = { times, keyTimes, range };
    const relative = { ...common, include: 100, leastSpan: 4 };
    volume.draw({ ...relative, series: series((motion) => relativeToFirstKey(motion.volume, analysis)) });
    area.draw({ ...relative, series: series((motion) => relativeToFirstKey(motion.area, analysis)) });
    const floor = logFloor(motions.map((motion) => motion.bending));
    bending.draw({
      ...common,
      series: series((motion) => motion.bending),
      include: 0,
      leastSpan: LEAST_BENDING,
      floor,
    });
    // Where nothing rests in any interval there is nothing to plot.
    setHidden(
      sliding.element,
      motions.every((motion) => motion.sliding.every(Number.isNaN)),
    );
    sliding.draw({ ...common, series: series((motion) => motion.sliding), include: 0, leastSpan: LEAST_SLIDING });
    drawLegend(legend, motions);
    setCursor(cursor);
  };

  const computeSoon = (): void => {
    window.clearTimeout(timer);
    if (visible && cache.stale) timer = window.setTimeout(() => void cache.refresh(), DELAY_MS);
  };

  cache.observe({
    onChange: () => {
      element.dataset['stale'] = '';
      updateFaces({ version: facesProps.version + 1 });
      if (visible) plane.refresh();
    },
    onStale: computeSoon,
    onFresh(analysis) {
      delete element.dataset['stale'];
      draw(analysis);
    },
  });

  new IntersectionObserver(([entry]) => {
    visible = entry?.isIntersecting ?? false;
    if (visible && cache.stale) plane.refresh();
    computeSoon();
  }).observe(element);

  return {
    element,
    update({ time, colouring, blend, keys, speeds, mostSpeeds }) {
      setCursor(time);
      updateFaces({ colouring });
      plane.setBlend(blend, keys);
      plane.setSpeeds(speeds, mostSpeeds);
    },
    clicked: (pick) => void faces.need().then((figure) => figure?.clicked(pick)),
  };
}

interface Series {
  label: string;
  values: number[];
  style: string;
}

interface Figure extends Pick<LineChart, 'setCursor'> {
  element: HTMLElement;
  draw(data: Omit<Parameters<LineChart['draw']>[0], 'title' | 'unit'>): void;
}

function chart(title: string, unit: string, name: Plot, events: AnalysisPanelEvents): Figure {
  const plot = createLineChart(events.onSeek);
  const testId = `plot-${name}`;
  const value = h('span', { class: 'value', 'data-testid': `${testId}-value` }, '');
  const counted = h('span', { class: 'unit' }, unit);
  let data: Parameters<Figure['draw']>[0] | null = null;
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': testId },
    h('figcaption', {}, h('strong', {}, title), value, counted),
    plot.element,
  );
  const redrawn = addFigureTools(element, { ...events, plot: name, title, numbers: () => data && chartNumbers(data) });
  return {
    element,
    draw(next) {
      data = next;
      const words = next.floor ? `${unit}; logarithmic` : unit;
      setText(counted, words);
      plot.draw({ ...next, title, unit: words });
      redrawn();
    },
    setCursor(t) {
      plot.setCursor(t);
      if (!data) return;
      const after = data.times.findIndex((time) => time >= t);
      const at = after < 0 ? data.times.length - 1 : after;
      const numbers = data.series.map(({ values }) => values[at] ?? NaN);
      const words = numbers.map((number) => (Number.isFinite(number) ? tickLabel(number) : '–'));
      setText(value, numbers.some(Number.isFinite) ? words.join(' / ') : '');
    },
  };
}

function drawLegend(legend: HTMLElement, motions: readonly MotionName[]): void {
  setHidden(legend, motions.length < 2);
  legend.replaceChildren(
    ...motions.map((motion) => {
      const sample = make('svg', { viewBox: '0 0 22 8', 'aria-hidden': 'true' });
      sample.append(make('line', { class: lineStyle(motion), x1: 0, x2: 22, y1: 4, y2: 4 }));
      return h('span', {}, sample, motionWords(motion).label);
    }),
  );
}
