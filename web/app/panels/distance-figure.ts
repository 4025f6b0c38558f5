/** The distance of the motions on the screen from one of them, or from the animation, over time. */
import { createLineChart } from '../../plots/line-chart.ts';
import type { LineChartData } from '../../plots/line-chart.ts';
import { button } from '../../ui/controls.ts';
import { h, setHidden, setText, svg } from '../../ui/dom.ts';
import { METHOD_WORDS, lineStyle, motionWords } from '../../model/method-words.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import { motionDistances } from '../analysis/motion-distance.ts';
import type { Compared, MotionDistances } from '../analysis/motion-distance.ts';
import { chartNumbers } from './chart-numbers.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';

export interface DistanceFigureParts extends FigureEvents {
  input(): AnalysisInput | null;
  compared(): Compared | null;
  onPickTruth(): void;
  onLeaveTruth(): void;
  onSeek(t: number): void;
}

export interface DistanceFigureProps {
  /** The surface is coloured by distance. */
  shown: boolean;
  cursor: number;
  /** Another number: the motions are others. */
  version: number;
}

export interface DistanceFigure {
  element: HTMLElement;
  update(props: DistanceFigureProps): void;
}

const TITLE = 'Distance';
const ALONE =
  'Compare with another method under Motion, show the animation that the keys were taken from, or drop another one of this mesh here.';

export function createDistanceFigure(parts: DistanceFigureParts): DistanceFigure {
  const plot = createLineChart(parts.onSeek);
  const unit = h('span', { class: 'unit' });
  const legend = h('span', { class: 'legend', 'data-testid': 'distance-kg' });
  const figure = h(
    'figure',
    { class: 'figure', 'data-testid': 'plot-distance', hidden: true },
    h('figcaption', {}, h('strong', {}, TITLE), unit, legend),
    plot.element,
  );
  const alone = h('p', { class: 'plane-note', hidden: true }, ALONE);
  const pick = button({
    label: 'Compare with an animation of the same mesh; it can be dropped here, too',
    testId: 'truth-pick',
    text: 'An animation from a file…',
    kind: 'plain',
    onClick: parts.onPickTruth,
  });
  const leave = button({
    label: 'Compare with this animation no more',
    testId: 'truth-leave',
    text: 'Without it',
    kind: 'plain',
    onClick: parts.onLeaveTruth,
  });
  const tools = h('div', { class: 'plane-tools' }, pick, leave);
  const element = h('div', { class: 'group', hidden: true, 'data-takes': 'truth' }, alone, figure, tools);
  let drawn: LineChartData | null = null;
  let cursor = 0;
  let served = -1;
  let asked = 0;
  const redrawn = addFigureTools(figure, {
    ...parts,
    plot: 'distance',
    title: TITLE,
    numbers: () => drawn && chartNumbers(drawn),
  });

  const draw = (found: MotionDistances, { keyTimes, range }: AnalysisInput, truth: string | null): void => {
    const { times, from, motions } = found;
    const against = from === null ? (truth ? `“${truth}”` : 'the animation') : METHOD_WORDS[from].label;
    const words = `mean over the vertices from ${against}, % of the diagonal`;
    drawn = {
      ...{ title: TITLE, unit: words, times, keyTimes, range, include: 0 },
      series: motions.map(({ mean, ...name }) => ({
        label: motionWords(name).label,
        values: mean,
        style: lineStyle(name),
      })),
    };
    plot.draw(drawn);
    plot.setCursor(cursor);
    setText(unit, words);
    legend.replaceChildren(
      ...motions.map(({ kg, ...name }) => {
        const line = svg('line', { class: lineStyle(name), x1: 0, x2: 22, y1: 4, y2: 4 });
        const sample = svg('svg', { viewBox: '0 0 22 8', 'aria-hidden': 'true' }, line);
        return h('span', {}, sample, `${motionWords(name).label}: KG error ${Number(kg.toPrecision(3))}\u00a0%`);
      }),
    );
    redrawn();
  };
  const load = async (): Promise<void> => {
    const mine = ++asked;
    const [input, compared] = [parts.input(), parts.compared()];
    const found = input && compared ? await motionDistances(input, compared) : null;
    if (mine !== asked) return;
    setHidden(alone, found !== null);
    setHidden(figure, found === null);
    setHidden(leave, !compared?.truth);
    if (input && found) draw(found, input, compared?.truth ?? null);
  };
  return {
    element,
    update({ shown, cursor: t, version }) {
      setHidden(element, !shown);
      cursor = t;
      plot.setCursor(t);
      if (!shown || served === version) return;
      served = version;
      load().catch((error: unknown) => {
        served = -1;
        parts.onError(error);
      });
    },
  };
}
