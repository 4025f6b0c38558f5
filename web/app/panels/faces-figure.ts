/** Faces: heat maps on the surface, and the coordinates of one face over time. */
import type { FaceCurve } from '../../engine/api/types.ts';
import { isFaceAmount } from '../../model/state.ts';
import type { Colouring, FaceAmount, Plot } from '../../model/state.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import { createLineChart } from '../../plots/line-chart.ts';
import type { LineChart, LineChartData } from '../../plots/line-chart.ts';
import { numberField, segments } from '../../ui/controls.ts';
import { h, setField, setHidden, setText } from '../../ui/dom.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { Compared } from '../analysis/motion-distance.ts';
import { chartNumbers } from './chart-numbers.ts';
import type { DistanceFigure, DistanceFigureProps } from './distance-figure.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';
import { later } from '../../ui/later.ts';

export interface FacesFigureEvents extends FigureEvents {
  onColouring(colouring: Colouring): void;
  onSeek(t: number): void;
  /** What distances are from; null where nothing is open. */
  compared(): Compared | null;
  /** Marks what moves with a face; null: nothing. */
  onMark(face: number | null): void;
}

export interface FacesFigure {
  element: HTMLElement;
  /** The picture was clicked: where the figure's panel is open, the face there is shown; -1 for none. */
  clicked(pick: () => number): void;
  /** The motions may be others. */
  refresh(): void;
  setCursor(t: number): void;
  setColouring(colouring: Colouring): void;
}

type Heat = FaceAmount | 'distance' | 'none';

const TIMES = 97;
const HINT = 'Click a face in the picture: its coordinates over time, as the spline has them.';
const AXES = ['x', 'y', 'z'];
const STRETCHES = ['along the first edge', 'shear', 'across'];

export function createFacesFigure(input: () => AnalysisInput | null, events: FacesFigureEvents): FacesFigure {
  const { onColouring, onMark, onError } = events;
  let cursor = 0;
  const heat = segments<Heat>(
    'Colour the surface',
    'heat',
    [
      { value: 'none', label: 'Off' },
      { value: 'rotation', label: 'Rotation', hint: 'The angle by which each face is turned against the reference' },
      { value: 'stretch', label: 'Stretch', hint: 'How much longer or shorter each face is than in the reference' },
      {
        value: 'distance',
        label: 'Distance',
        hint: 'How far what is compared is from the first motion or the animation',
      },
    ],
    (value) => onColouring(value === 'none' ? 'texture' : value),
  );
  const distance = later<DistanceFigureProps, DistanceFigure>(async () => {
    const { createDistanceFigure } = await import('./distance-figure.ts');
    return createDistanceFigure({ ...events, input });
  }, onError);
  let byDistance = false;
  let version = 0;
  const followDistance = (): void => {
    distance.update({ shown: byDistance, cursor, version });
    if (byDistance) void distance.need();
  };
  const hint = h('p', { class: 'plane-note' }, HINT);
  const number = numberField({
    label: 'Face, counted from 0 as in the file',
    testId: 'face-number',
    min: 0,
    step: 1,
    onInput: (value) => show(Math.round(value)),
  });
  const said = h('span', { class: 'muted', 'data-testid': 'face-patch' });
  const rotation = chart('Rotation against its patch', 'degrees, as a rotation vector', 'face-rotation', events);
  const stretch = chart('Stretch', 'of the face, 1 as in the reference', 'face-stretch', events);
  const charts = h('div', { class: 'group', hidden: true }, rotation.element, stretch.element);
  const element = h(
    'section',
    { class: 'group', 'aria-label': 'Faces', 'data-testid': 'faces' },
    heat.element,
    distance.element,
    hint,
    h('div', { class: 'plane-tools' }, h('span', {}, 'Face'), number, said),
    charts,
  );
  let face: number | null = null;
  let asked = 0;

  const load = async (): Promise<void> => {
    const of = input();
    const [main] = of?.sequences ?? [];
    const mine = ++asked;
    if (face === null || !of || !main) return setHidden(charts, true);
    const times = plottedTimes(of.range, of.keyTimes, TIMES);
    const curve = await main.sequence.faceCurve(face, times);
    if (mine !== asked) return;
    setHidden(charts, curve.patch < 0);
    setText(said, curve.patch < 0 ? 'has no area' : `of patch ${curve.patch + 1}`);
    if (curve.patch < 0) return;
    const common = { times, keyTimes: of.keyTimes, range: of.range, dots: true };
    const degrees = (value: number): number => (180 / Math.PI) * value;
    // Where ends or keys are shaped, the natural spline says what that does.
    const free = curve.natural.some((value, index) => value !== curve.numbers[index]) ? curve.natural : null;
    rotation.draw({ ...common, series: seriesOf(curve, free, 0, AXES, degrees), include: 0, leastSpan: 2 });
    const log = main.sequence.options.stretch === 'log';
    stretch.draw({ ...common, series: seriesOf(curve, free, 3, STRETCHES), include: log ? 0 : 1, leastSpan: 0.04 });
    for (const one of [rotation, stretch]) one.setCursor(cursor);
  };
  const show = (next: number | null): void => {
    face = next;
    setField(number, next === null ? '' : String(next));
    if (next === null) setText(said, '');
    onMark(next);
    load().catch((error: unknown) => {
      face = null;
      setText(said, '');
      setHidden(charts, true);
      onError(error);
    });
  };
  return {
    element,
    clicked(pick) {
      if (!element.checkVisibility()) return;
      const picked = pick();
      if (picked < 0 && face === null) return;
      show(picked >= 0 ? picked : null);
      if (picked >= 0) element.scrollIntoView({ block: 'nearest' });
    },
    refresh() {
      version += 1;
      followDistance();
      if (face !== null) load().catch(onError);
    },
    setCursor(t) {
      cursor = t;
      for (const one of [rotation, stretch]) one.setCursor(t);
      if (byDistance) followDistance();
    },
    setColouring(colouring) {
      byDistance = colouring === 'distance';
      heat.update(isFaceAmount(colouring) || colouring === 'distance' ? colouring : 'none');
      followDistance();
    },
  };
}

/** Three of the six numbers over time; those of the natural spline are drawn below them. */
function seriesOf(
  { numbers }: FaceCurve,
  natural: readonly number[] | null,
  first: number,
  names: readonly string[],
  as: (value: number) => number = (value) => value,
): LineChartData['series'] {
  const of = (list: readonly number[], k: number): number[] =>
    Array.from({ length: list.length / 6 }, (_, i) => as(list[6 * i + first + k]!));
  const under = natural
    ? names.map((label, k) => ({ label: `${label} natural`, values: of(natural, k), style: `axis-${k} unshaped` }))
    : [];
  return [...under, ...names.map((label, k) => ({ label, values: of(numbers, k), style: `axis-${k}` }))];
}

function chart(
  title: string,
  unit: string,
  name: Plot,
  events: FacesFigureEvents,
): {
  element: HTMLElement;
  draw(data: Omit<LineChartData, 'title' | 'unit'>): void;
  setCursor: LineChart['setCursor'];
} {
  const plot = createLineChart(events.onSeek);
  const legend = h('span', { class: 'legend' });
  let drawn: Omit<LineChartData, 'title' | 'unit'> | null = null;
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': `plot-${name}` },
    h('figcaption', {}, h('strong', {}, title), h('span', { class: 'unit' }, unit), legend),
    plot.element,
  );
  const redrawn = addFigureTools(element, {
    ...events,
    plot: name,
    title,
    numbers: () => drawn && chartNumbers(drawn),
  });
  return {
    element,
    draw(data) {
      drawn = data;
      plot.draw({ ...data, title, unit });
      redrawn();
      const own = data.series.filter(({ style }) => !style.includes('unshaped'));
      legend.replaceChildren(
        ...own.map(({ label, style }) => h('span', {}, h('i', { class: `swatch ${style}` }), label)),
        ...(own.length < data.series.length ? [h('span', {}, h('i', { class: 'swatch unshaped' }), 'natural')] : []),
      );
    },
    setCursor: plot.setCursor,
  };
}
