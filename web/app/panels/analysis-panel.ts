/** "What it sees": the shape plane, bending energy, volume and area of the methods on the screen, worked out when idle. */
import type { Method } from '../../engine/api/types.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { End } from '../../model/speeds.ts';
import { isInLri } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { createLineChart, make } from '../../plots/line-chart.ts';
import type { LineChart } from '../../plots/line-chart.ts';
import { h, setHidden, setText } from '../../ui/dom.ts';
import { METHOD_WORDS } from '../../ui/motion-panel.ts';
import { isCancelled } from '../session/sequence-set.ts';
import type { RunningSequence } from '../session/sequence-set.ts';
import { createPlaneFigure } from './shape-plane-figure.ts';
import type { PlaneFigure, PlaneInput } from './shape-plane-figure.ts';

/** Everything that is plotted, and what the CSV holds. */
export interface Analysis {
  times: number[];
  keyTimes: readonly number[];
  range: Range;
  sequences: MotionAnalysis[];
}

export interface MotionAnalysis {
  method: Method;
  volume: number[];
  area: number[];
  /** LRI spline only. */
  bending: number[] | null;
  /** 2 numbers for each time; methods of LRI space only. */
  plane: number[] | null;
  planeKeys: number[] | null;
  explained: number;
}

export interface AnalysisInput extends PlaneInput {
  /** Milliseconds a frame takes: the slower, the fewer points are computed. */
  ms: number;
}

export interface AnalysisPanelEvents {
  onSeek(t: number): void;
  onSpeed(end: End, speed: number): void;
  onError(error: unknown): void;
}

export interface AnalysisPanel {
  element: HTMLElement;
  /** Something has changed: what is plotted is worked out anew as soon as the panel can be seen. */
  invalidate(): void;
  setCursor(t: number): void;
  setSpeeds: PlaneFigure['setSpeeds'];
  /** The numbers, worked out now if they are not there yet; null without a motion. */
  data(): Promise<Analysis | null>;
}

const DELAY_MS = 200;
const BUDGET_MS = 1200;

export function createAnalysisPanel(input: () => AnalysisInput | null, { onSeek, onSpeed, onError }: AnalysisPanelEvents): AnalysisPanel {
  const plane = createPlaneFigure(input, { onSpeed, onError });
  const volume = chart('Volume', '% of the first key', 'plot-volume', onSeek);
  const area = chart('Area', '% of the first key', 'plot-area', onSeek);
  const bending = chart('Bending energy', 'times the mean deformation energy between keys, per time⁴', 'plot-bending', onSeek);
  const legend = h('div', { class: 'legend' });
  const element = h('section', { class: 'panel', 'aria-labelledby': 'see-title', 'data-testid': 'panel-see' },
    h('header', {}, h('h2', { id: 'see-title' }, 'What it sees')), legend, plane.element, volume.element, area.element, bending.element);

  let shown: Analysis | null = null;
  let stale = true;
  let visible = false;
  let timer = 0;
  let running: Promise<Analysis | null> | null = null;
  let cursor = 0;

  const work = async (): Promise<Analysis | null> => {
    const asked = input();
    if (!asked || asked.sequences.length === 0) return null;
    stale = false;
    try {
      const result = await compute(asked);
      shown = result;
      if (!stale) draw(result);
      return result;
    } catch (error) {
      if (!isCancelled(error)) onError(error);
      return null;
    }
  };

  const refresh = (): Promise<Analysis | null> => {
    running ??= work().finally(() => {
      running = null;
      if (stale) schedule();
    });
    return running;
  };

  const schedule = (): void => {
    window.clearTimeout(timer);
    if (visible && stale) timer = window.setTimeout(() => void refresh(), DELAY_MS);
  };

  const draw = ({ times, keyTimes, range, sequences }: Analysis): void => {
    const series = (pick: (running: MotionAnalysis) => number[] | null): { label: string; values: number[]; style: string }[] =>
      sequences.flatMap((running) => { const values = pick(running); return values ? [{ label: METHOD_WORDS[running.method].label, values, style: running.method }] : []; });
    const common = { times, keyTimes, range };
    volume.draw({ ...common, series: series((running) => relative(running.volume, times, keyTimes)), include: 100, leastSpan: 4 });
    area.draw({ ...common, series: series((running) => relative(running.area, times, keyTimes)), include: 100, leastSpan: 4 });
    bending.draw({ ...common, series: series((running) => running.bending), include: 0 });
    drawLegend(legend, sequences.map((running) => running.method));
    setCursor(cursor);
  };

  const setCursor = (t: number): void => {
    cursor = t;
    plane.setCursor(t);
    for (const one of [volume, area, bending]) one.setCursor(t);
  };

  new IntersectionObserver(([entry]) => {
    visible = entry?.isIntersecting ?? false;
    if (visible && stale) plane.refresh();
    schedule();
  }).observe(element);

  return {
    element,
    invalidate() {
      stale = true;
      if (visible) plane.refresh();
      if (!running) schedule();
    },
    setCursor,
    setSpeeds: plane.setSpeeds,
    data: async () => {
      if (running) await running;
      return stale || !shown ? refresh() : shown;
    },
  };
}

async function compute({ sequences, keyTimes, range, ms }: AnalysisInput): Promise<Analysis> {
  const count = Math.round(Math.min(Math.max(BUDGET_MS / Math.max(ms * sequences.length, 0.1), 13), 97));
  const times = plottedTimes(range, keyTimes, count);
  const results = await Promise.all(sequences.map((running) => analyse(running, times)));
  return { times, keyTimes, range, sequences: results };
}

async function analyse({ method, sequence }: RunningSequence, times: number[]): Promise<MotionAnalysis> {
  const { volume, area } = await sequence.measures(times);
  const plane = isInLri(method) ? await sequence.shapePlane(times) : null;
  const bending = method === 'lri' ? await sequence.bendingEnergy(times) : null;
  return { method, volume, area, bending, plane: plane?.curve ?? null, planeKeys: plane?.keys ?? null, explained: plane?.explained ?? 0 };
}

/** In percent of the value at the first key. A surface without volume has no percentage of it. */
function relative(values: readonly number[], times: readonly number[], keyTimes: readonly number[]): number[] {
  const base = values[times.indexOf(keyTimes[0] ?? 0)] ?? NaN;
  return values.map((value) => (base === 0 ? NaN : (100 * value) / base));
}

interface Figure extends Pick<LineChart, 'setCursor'> {
  element: HTMLElement;
  draw(data: Omit<Parameters<LineChart['draw']>[0], 'title' | 'unit'>): void;
}

function chart(title: string, unit: string, testId: string, onSeek: (t: number) => void): Figure {
  const plot = createLineChart(onSeek);
  const value = h('span', { class: 'value', 'data-testid': `${testId}-value` }, '');
  let data: Parameters<Figure['draw']>[0] | null = null;
  return {
    element: h('figure', { class: 'figure', 'data-testid': testId },
      h('figcaption', {}, h('strong', {}, title), value, h('span', { class: 'unit' }, unit)), plot.element),
    draw(next) {
      data = next;
      plot.draw({ ...next, title, unit });
    },
    setCursor(t) {
      plot.setCursor(t);
      if (!data) return;
      const after = data.times.findIndex((time) => time >= t);
      const at = data.series[0]?.values[after < 0 ? data.times.length - 1 : after];
      setText(value, at === undefined || !Number.isFinite(at) ? '' : String(Number(at.toPrecision(4))));
    },
  };
}

function drawLegend(legend: HTMLElement, methods: readonly Method[]): void {
  setHidden(legend, methods.length < 2);
  legend.replaceChildren(...methods.map((method) => {
    const sample = make('svg', { viewBox: '0 0 22 8', 'aria-hidden': 'true' });
    sample.append(make('line', { class: method, x1: 0, x2: 22, y1: 4, y2: 4 }));
    return h('span', {}, sample, METHOD_WORDS[method].label);
  }));
}
