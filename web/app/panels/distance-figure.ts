/** Distance over time from the shown motions to one of them or to the animation. */
import { METHOD_WORDS, lineStyle, motionWords } from '../../model/method-words.ts';
import { button } from '../../ui/controls.ts';
import { h, setHidden } from '../../ui/dom.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import { motionDistances } from '../analysis/motion-distance.ts';
import type { Compared, MotionDistances } from '../analysis/motion-distance.ts';
import { createChartFigure, legendEntry } from './chart-figure.ts';
import type { ChartData, ChartEvents } from './chart-figure.ts';

export interface DistanceFigureParts extends ChartEvents {
  input(): AnalysisInput | null;
  compared(): Compared | null;
  onPickReference(): void;
  onLeaveReference(): void;
}

export interface DistanceFigureProps {
  /** Colours show the distance. */
  shown: boolean;
  cursor: number;
  /** A number that increases when the motions change. */
  version: number;
}

export interface DistanceFigure {
  element: HTMLElement;
  update(props: DistanceFigureProps): void;
}

const ALONE =
  'Compare with another method under Motion, show the animation that the keys were taken from, or drop a different animation of this mesh here.';

export function createDistanceFigure(parts: DistanceFigureParts): DistanceFigure {
  const legend = h('span', { class: 'legend', 'data-testid': 'distance-kg' });
  const figure = createChartFigure('distance', { title: 'Distance', unit: '', legend }, parts);
  setHidden(figure.element, true);
  const alone = h('p', { class: 'plane-note', hidden: true }, ALONE);
  const pick = button({
    label: 'Compare with an animation of the same mesh, from a file or dropped here',
    testId: 'truth-pick',
    text: 'Choose an animation file…',
    onClick: parts.onPickReference,
  });
  const leave = button({
    label: 'Stop comparing',
    testId: 'truth-leave',
    text: 'Remove',
    onClick: parts.onLeaveReference,
  });
  const tools = h('div', { class: 'plane-tools' }, pick, leave);
  const element = h('div', { class: 'group', hidden: true, 'data-takes': 'truth' }, alone, figure.element, tools);
  let cursor = 0;
  let served = -1;
  let asked = 0;

  const load = async (): Promise<void> => {
    const mine = ++asked;
    const [input, compared] = [parts.input(), parts.compared()];
    const found = input && compared ? await motionDistances(input, compared) : null;
    if (mine !== asked) return;
    setHidden(alone, found !== null);
    setHidden(figure.element, found === null);
    setHidden(leave, !compared?.referenceName);
    if (!input || !found) return;
    figure.draw(chartOf(found, input, compared?.referenceName ?? null));
    figure.setCursor(cursor);
    legend.replaceChildren(...found.motions.map(kgEntry));
  };
  return {
    element,
    update({ shown, cursor: t, version }) {
      setHidden(element, !shown);
      cursor = t;
      figure.setCursor(t);
      if (!shown || served === version) return;
      served = version;
      load().catch((error: unknown) => {
        served = -1;
        parts.onError(error);
      });
    },
  };
}

function chartOf(
  { times, from, motions }: MotionDistances,
  { keyTimes, range }: AnalysisInput,
  referenceName: string | null,
): ChartData {
  const against = from === null ? (referenceName ? `“${referenceName}”` : 'the animation') : METHOD_WORDS[from].label;
  const series = motions.map(({ mean, ...name }) => ({
    label: motionWords(name).label,
    values: mean,
    style: lineStyle(name),
  }));
  const unit = `mean distance of the vertices from ${against}, % of the model’s size`;
  return { unit, times, keyTimes, range, include: 0, series };
}

function kgEntry({ kg, ...name }: MotionDistances['motions'][number]): HTMLElement {
  return legendEntry(lineStyle(name), `${motionWords(name).label}: KG error ${Number(kg.toPrecision(3))}\u00a0%`);
}
