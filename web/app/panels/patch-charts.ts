/** A patch over time: its rotation against each neighbour, and its faces' stretches. */
import { plottedTimes } from '../../model/time-scale.ts';
import type { LineChartData, Series } from '../../plots/line-chart.ts';
import { select } from '../../ui/controls.ts';
import { h, setHidden } from '../../ui/dom.ts';
import { angleOf, patchCurves } from '../analysis/patch-curves.ts';
import type { PatchCurves, PatchNeighbour } from '../analysis/patch-curves.ts';
import type { ChartEvents } from './chart-figure.ts';
import { OTHERS, createCoordinateChart, overNatural } from './coordinate-chart.ts';
import { AXES, TIMES, isOther } from './face-charts.ts';
import type { PartCharts } from './face-charts.ts';

interface Loaded {
  own: PatchCurves;
  /** Curves of the natural spline if they differ. */
  natural: PatchCurves | null;
  common: Pick<LineChartData, 'times' | 'keyTimes' | 'range' | 'dots'>;
}

export interface PatchChartsEvents extends ChartEvents {
  /** The neighbour of the drawn rotation; null without neighbours. */
  onPair(patch: number | null): void;
  onNeighbour(patch: number): void;
}

export interface PatchCharts extends PartCharts {
  /** The chosen neighbour; null for the one with the largest rotation. */
  setNeighbour(patch: number | null): void;
}

export function createPatchCharts(events: PatchChartsEvents): PatchCharts {
  const turns = createTurnCharts(events);
  const average = 'area-weighted mean of the principal stretches';
  const stretch = createCoordinateChart('patch-stretch', 'Stretch of the patch', average, events);
  const element = h('div', { class: 'group', hidden: true }, turns.element, stretch.element);
  let asked = 0;
  return {
    element,
    async load(patch, input) {
      const [main] = input?.sequences ?? [];
      const mine = ++asked;
      if (patch === null || !input || !main) {
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
      setHidden(element, false);
      const lengths = ({ stretch: values }: PatchCurves): Series[] => [{ label: 'stretch', values, style: 'axis-0' }];
      const log = main.sequence.options.stretch === 'log';
      const series = overNatural(lengths(own), natural && lengths(natural));
      stretch.draw({ ...common, series, include: log ? 0 : 1, minSpan: 0.04 });
      turns.draw({ own, natural, common });
      const { length } = own.neighbours;
      return length === 1 ? '1 neighbour' : `${length} neighbours`;
    },
    setNeighbour: turns.setNeighbour,
    setCursor(t) {
      for (const one of [turns, stretch]) one.setCursor(t);
    },
  };
}

/** The patch's rotation angle against all neighbours, and its rotation axis against a chosen one. */
function createTurnCharts(events: PatchChartsEvents) {
  const angles = createCoordinateChart('patch-angles', 'Rotation relative to neighbours', 'angle, degrees', events);
  const turned = 'degrees, as a rotation vector in the axes of the reference pose';
  const rotation = createCoordinateChart('patch-rotation', 'Rotation relative to a neighbour', turned, events);
  const against = select<string>('Neighbour', 'patch-neighbour', [], (value) => events.onNeighbour(Number(value)));
  const element = h('div', { class: 'group' }, angles.element, against.element, rotation.element);
  let loaded: Loaded | null = null;
  let wanted: number | null = null;
  const draw = (): void => {
    if (!loaded) return;
    const { own, natural, common } = loaded;
    const of = own.neighbours.find(({ patch }) => patch === wanted) ?? own.neighbours[0];
    setHidden(element, !of);
    events.onPair(of?.patch ?? null);
    if (!of) return;
    against.update(
      String(of.patch),
      own.neighbours.map(({ patch }) => ({ value: String(patch), label: nameOf(patch) })),
    );
    const drawnLast = [...own.neighbours.filter((one) => one !== of), of];
    const series = drawnLast.map((one) => angle(one, one === of ? 'axis-0' : OTHERS));
    angles.draw({ ...common, series, include: 0, minSpan: 2 });
    const turning = natural?.neighbours.find(({ patch }) => patch === of.patch);
    rotation.draw({
      ...common,
      title: `Rotation relative to ${nameOf(of.patch)}`,
      series: overNatural(vector(of), turning ? vector(turning) : null),
      ...{ include: 0, minSpan: 2 },
    });
  };
  return {
    element,
    draw(next: Loaded): void {
      loaded = next;
      draw();
    },
    setNeighbour(patch: number | null): void {
      if (patch === wanted) return;
      wanted = patch;
      draw();
    },
    setCursor(t: number): void {
      for (const one of [angles, rotation]) one.setCursor(t);
    },
  };
}

function angle({ patch, turn }: PatchNeighbour, style: string): Series {
  return { label: nameOf(patch), values: turn.map(angleOf), style };
}

function nameOf(patch: number): string {
  return `patch ${patch + 1}`;
}

function vector({ turn }: PatchNeighbour): Series[] {
  return AXES.map((label, k) => ({ label, values: turn.map((at) => at[k]!), style: `axis-${k}` }));
}
