/** Bending energy of the shown motions: of each in its own coordinates, or of all by edge lengths and angles. */
import { METHOD } from '../../engine/api/methods.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { Method, Progress } from '../../engine/api/types.ts';
import { logFloor } from '../../plots/scale.ts';
import { checkbox } from '../../ui/controls.ts';
import { h, setAttribute } from '../../ui/dom.ts';
import type { Analysis, AnalysisInput } from '../analysis/analysis.ts';
import { shellBendings } from '../analysis/shell-bendings.ts';
import type { ChartData, ChartEvents, ChoiceEvents } from './chart-figure.ts';
import { createValuedChart, motionCurves } from './valued-chart.ts';
import { createWorkingLine } from './working-line.ts';

export interface BendingEvents extends ChartEvents, ChoiceEvents {}

export interface BendingFigure {
  element: HTMLElement;
  draw(analysis: Analysis): void;
  /** The motions have changed since the last drawing. */
  outdate(): void;
  /** The computed share of the next analysis; null if none is being computed. */
  setWorking(fraction: number | null): void;
  /** Also measures by edge lengths and angles, which then applies to tables, too. */
  setShell(on: boolean): void;
  setCursor(t: number): void;
}

const BENDING = 'squared acceleration, relative, 1/s⁴';
const SHELL = 'squared acceleration of edge lengths and angles, relative, 1/s⁴';
const BENDING_UNIT = 'Relative to the mean deformation energy between keys';
const CHOICE = 'By edge lengths and angles';
const CHOICE_HINT =
  'Measures all methods in the same way: by edge lengths and the angles between faces, as for a thin shell, on a coarse mesh';
const WORK = 'Measuring the motion';
const SHELL_WORK = 'Measuring edge lengths and angles';
/** Added to the names of a table's columns. */
const MEASURE = 'by edge lengths and angles';
const MIN_BENDING = 1;

export function createBendingFigure(input: () => AnalysisInput | null, events: BendingEvents): BendingFigure {
  const figure = createValuedChart('bending', 'Bending energy', BENDING, events);
  figure.element.title = BENDING_UNIT;
  const choose = (shellBending: boolean): void => events.onCharts({ shellBending });
  const toggle = checkbox(CHOICE, 'bending-shell', choose);
  toggle.element.id = 'bending-shell';
  toggle.element.title = CHOICE_HINT;
  const working = createWorkingLine('bending', 'Stop measuring', () => choose(false));
  working.element.classList.add('card', 'over-plot');
  figure.element.querySelector('details')!.before(working.element, h('div', { class: 'plane-tools' }, toggle.element));
  /** The current motions and their analysis; null if it is out of date. */
  let known: { analysis: Analysis; of: AnalysisInput } | null = null;
  let byShell = false;
  let abort: AbortController | null = null;
  let analysing = false;
  let cursor = 0;

  const showWork = (): void => {
    working.show(analysing || abort !== null, byShell);
    setAttribute(figure.element, 'data-stale', abort !== null);
  };
  const measuring = (now: AbortController | null): void => {
    abort?.abort();
    abort = now;
    showWork();
  };
  const report = (stage: string, fraction: number): void => working.update({ stage, fraction });
  const redraw = (data: ChartData): void => {
    figure.draw(data);
    figure.setCursor(cursor);
  };
  const show = async (): Promise<void> => {
    measuring(null);
    if (!known) return;
    const { analysis, of } = known;
    if (!byShell) return redraw(ownData(analysis));
    const own = new AbortController();
    report(SHELL_WORK, 0);
    measuring(own);
    try {
      const onProgress = ({ fraction }: Progress): void => report(SHELL_WORK, fraction);
      const call = { signal: own.signal, onProgress };
      const energies = await shellBendings(of, analysis.times, call);
      if (!own.signal.aborted) redraw(shellData(analysis, energies));
    } catch (error) {
      if (own.signal.aborted || isCancelled(error)) return;
      choose(false);
      events.onError(error);
    } finally {
      if (abort === own) measuring(null);
    }
  };
  return {
    element: figure.element,
    draw(analysis) {
      const of = input();
      known = of && { analysis, of };
      void show();
    },
    outdate() {
      measuring(null);
      known = null;
    },
    setWorking(fraction) {
      analysing = fraction !== null;
      if (fraction !== null) report(WORK, fraction);
      showWork();
    },
    setShell(on) {
      if (on === byShell) return;
      byShell = on;
      toggle.update(on);
      void show();
    },
    setCursor(t) {
      cursor = t;
      figure.setCursor(t);
    },
  };
}

function ownData(analysis: Analysis): ChartData {
  const energies = analysis.motions.map(({ bending }) => bending);
  const methods = analysis.motions.map(({ method }) => method);
  return bendingData(analysis, energies, (floor) => bendingUnit(methods, floor));
}

function shellData(analysis: Analysis, energies: readonly number[][]): ChartData {
  return { ...bendingData(analysis, energies, (floor) => withAxis([SHELL], floor)), measure: MEASURE };
}

function bendingData(
  analysis: Analysis,
  energies: readonly number[][],
  unit: (floor: number | null) => string,
): ChartData {
  const floor = logFloor(energies);
  return { ...motionCurves(analysis, energies), include: 0, minSpan: MIN_BENDING, floor, unit: unit(floor) };
}

/**
 * Bending energies are comparable within one space only. In its own space, a vertex blend has a lower energy, whether
 * it looks smoother or not.
 */
export function bendingUnit(methods: readonly Method[], floor: number | null): string {
  const spaces = new Set(methods.map((method) => METHOD[method].space));
  return withAxis([BENDING, ...(spaces.size > 1 ? ['each motion in its own coordinates'] : [])], floor);
}

function withAxis(words: readonly string[], floor: number | null): string {
  return [...words, ...(floor ? ['logarithmic'] : [])].join('; ');
}
