/** Curves as lines, sampled within each interval so jumps at keys are visible. */
import { namedCurve } from '../../plots/svg-parts.ts';
import { inInterval, valueAt } from '../splines/curve.ts';
import type { Curve, Derivative } from '../splines/curve.ts';
import type { Layer } from '../state.ts';
import type { Curves } from '../derived.ts';
import { clipped } from './clip.ts';
import { LAYER_WORDS } from './words.ts';

type Place = (numbers: number[], t: number) => readonly [number, number];

const STEPS = 28;

/** The pieces of a curve between keys, up to the time `until`, each as [time, numbers] pairs. */
export function pieces(curves: Curves, derivative: Derivative, until: number): [number, number[]][][] {
  const { times } = curves[0]!;
  return times.slice(0, -1).flatMap((from, interval) => {
    const to = Math.min(times[interval + 1]!, until);
    if (from >= until) return [];
    return [
      Array.from({ length: STEPS + 1 }, (_, step): [number, number[]] => {
        const t = from + ((to - from) * step) / STEPS;
        return [t, curves.map((curve) => inInterval(curve, interval, t, derivative))];
      }),
    ];
  });
}

/** One path per piece; pieces are joined where the curve does not jump. */
export function curveLines(
  layer: Layer,
  curves: Curves,
  derivative: Derivative,
  [start, end]: readonly [number, number],
  place: Place,
): SVGElement[] {
  const points = pieces(curves, derivative, end).map((piece) => piece.map(([t, numbers]) => place(numbers, t)));
  const runs: (readonly [number, number])[][] = [];
  for (const piece of points) {
    const last = runs.at(-1)?.at(-1);
    if (last && Math.hypot(last[0] - piece[0]![0], last[1] - piece[0]![1]) < 0.75) runs.at(-1)!.push(...piece.slice(1));
    else runs.push([...piece]);
  }
  return [
    ...beyondLines(layer, curves, derivative, [start, end], place),
    ...runs.map((run) => namedCurve(LAYER_WORDS[layer].name, layer, clipped(run))),
  ];
}

/** Curves beyond the keys: the next period of a loop, otherwise a straight line. */
function beyondLines(
  layer: Layer,
  curves: Curves,
  derivative: Derivative,
  [start, end]: readonly [number, number],
  place: Place,
): SVGElement[] {
  if (derivative > 0) return [];
  const { times, closed } = curves[0]!;
  const [first, last] = [times[0]!, closed ? end : times.at(-1)!];
  const line = (from: number, to: number): SVGElement => {
    const at = (step: number): number => from + ((to - from) * step) / STEPS;
    const points = Array.from({ length: STEPS + 1 }, (_, step) => place(valuesAt(curves, at(step)), at(step)));
    return namedCurve(LAYER_WORDS[layer].name, `${layer} further`, clipped(points));
  };
  return [...(start < first ? [line(start, first)] : []), ...(end > last ? [line(last, end)] : [])];
}

function valuesAt(curves: readonly Curve[], t: number): number[] {
  return curves.map((curve) => valueAt(curve, t));
}
