/** A patch over time: how it turns against each of its neighbours, and how its faces stretch. */
import { plottedTimes } from '../../model/time-scale.ts';
import type { LineChartData, Series } from '../../plots/line-chart.ts';
import { select } from '../../ui/controls.ts';
import { h, setHidden } from '../../ui/dom.ts';
import { angleOf, patchCurves } from '../analysis/patch-curves.ts';
import type { PatchCurves, PatchNeighbour } from '../analysis/patch-curves.ts';
import { OTHERS, createCoordinateChart, overNatural } from './coordinate-chart.ts';
import type { CoordinateChartEvents } from './coordinate-chart.ts';
import { AXES, TIMES, isOther } from './face-charts.ts';
import type { PartCharts } from './face-charts.ts';

interface Loaded {
  own: PatchCurves;
  /** Of the natural spline, where that is another one. */
  natural: PatchCurves | null;
  common: Pick<LineChartData, 'times' | 'keyTimes' | 'range' | 'dots'>;
}

/** `onPair`: the neighbour whose turn is drawn; null without any. */
export function createPatchCharts(events: CoordinateChartEvents, onPair: (patch: number | null) => void): PartCharts {
  const angles = createCoordinateChart('patch-angles', 'Turn against its neighbours', 'angle, degrees', events);
  const turned = 'degrees, as a rotation vector in the axes of the reference pose';
  const rotation = createCoordinateChart('patch-rotation', 'Turn against a neighbour', turned, events);
  const average = 'mean over its area and both directions';
  const stretch = createCoordinateChart('patch-stretch', 'Stretch of the patch', average, events);
  const against = select<string>('Neighbour', 'patch-neighbour', [], (value) => draw(Number(value)));
  const pair = h('div', { class: 'group' }, angles.element, against.element, rotation.element);
  const element = h('div', { class: 'group', hidden: true }, pair, stretch.element);
  let loaded: Loaded | null = null;
  let asked = 0;
  let wanted = -1;

  /** The chosen neighbour, where this patch has it; else the one that turns furthest. */
  const draw = (neighbour: number): void => {
    if (!loaded) return;
    const { own, natural, common } = loaded;
    const of = own.neighbours.find(({ patch }) => patch === neighbour) ?? own.neighbours[0];
    setHidden(pair, !of);
    onPair(of?.patch ?? null);
    if (!of) return;
    wanted = of.patch;
    against.update(
      String(of.patch),
      own.neighbours.map(({ patch }) => ({ value: String(patch), label: nameOf(patch) })),
    );
    const drawnLast = [...own.neighbours.filter((one) => one !== of), of];
    const angle = (one: PatchNeighbour, style: string): Series => ({
      label: nameOf(one.patch),
      values: one.turn.map(angleOf),
      style,
    });
    const turning = natural?.neighbours.find(({ patch }) => patch === of.patch);
    angles.draw({
      ...common,
      series: drawnLast.map((one) => angle(one, one === of ? 'axis-0' : OTHERS)),
      include: 0,
      leastSpan: 2,
    });
    rotation.draw(
      { ...common, series: overNatural(vector(of), turning ? vector(turning) : null), include: 0, leastSpan: 2 },
      `Turn against ${nameOf(of.patch)}`,
    );
  };

  return {
    element,
    async load(patch, input) {
      const [main] = input?.sequences ?? [];
      const mine = ++asked;
      if (patch === null || !input || !main) {
        loaded = null;
        setHidden(element, true);
        return '';
      }
      const times = plottedTimes(input.range, input.keyTimes, TIMES);
      const curve = await main.sequence.patchCurve(patch, times);
      if (mine !== asked) return '';
      const rest = times.indexOf(input.keyTimes[input.reference]!);
      const own = patchCurves(curve, curve.numbers, rest);
      const natural = isOther(curve.numbers, curve.natural) ? patchCurves(curve, curve.natural, rest) : null;
      const common = { times, keyTimes: input.keyTimes, range: input.range, dots: true };
      loaded = { own, natural, common };
      setHidden(element, false);
      const lengths = ({ stretch: values }: PatchCurves): Series[] => [{ label: 'stretch', values, style: 'axis-0' }];
      const log = main.sequence.options.stretch === 'log';
      const series = overNatural(lengths(own), natural && lengths(natural));
      stretch.draw({ ...common, series, include: log ? 0 : 1, leastSpan: 0.04 });
      draw(wanted);
      const { length } = own.neighbours;
      return length === 1 ? '1 neighbour' : `${length} neighbours`;
    },
    setCursor(t) {
      for (const one of [angles, rotation, stretch]) one.setCursor(t);
    },
  };
}

function nameOf(patch: number): string {
  return `patch ${patch + 1}`;
}

function vector({ turn }: PatchNeighbour): Series[] {
  return AXES.map((label, k) => ({ label, values: turn.map((at) => at[k]!), style: `axis-${k}` }));
}
