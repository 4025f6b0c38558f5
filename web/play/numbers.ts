/** The numbers of each figure, for its table and its file. */
import type { Derived } from './derived.ts';
import { amount } from './derived.ts';
import { LAYER_WORDS } from './figures/words.ts';
import type { NumbersTable } from '../ui/values.ts';
import { shownSpan } from './figures/curve-figure.ts';
import { valueAt } from './splines/curve.ts';
import type { Derivative } from './splines/curve.ts';
import { LAYERS } from './state.ts';
import type { PlayState } from './state.ts';

const ROWS = 201;

/** The shown curves or their derivatives. */
export function curveNumbers(state: PlayState, derived: Derived, derivative: Derivative): NumbersTable {
  const layers = state.layers.filter((layer) => layer !== 'samples');
  const across = state.plane && derivative === 0;
  const rowAt = (t: number): number[] => [
    t,
    ...layers.flatMap((layer) => {
      const curves = derived.curves[layer];
      return across ? curves.map((curve) => valueAt(curve, t)) : [amount(curves, t, derivative)];
    }),
  ];
  const names = layers.flatMap((layer) => {
    const { name } = LAYER_WORDS[layer];
    return across ? [`${name} value`, `${name} across`] : [name];
  });
  return { names: ['time', ...names], ...rowsOf(derived, rowAt) };
}

export function weightNumbers(derived: Derived): NumbersTable {
  const rowAt = (t: number): number[] => [t, ...derived.weights.map((weight) => valueAt(weight, t))];
  return { names: ['time', ...derived.weights.map((_, k) => `w${k + 1}`)], ...rowsOf(derived, rowAt) };
}

export function systemNumbers({ system: { matrix, rhs }, slopes }: Derived): NumbersTable {
  const rows = matrix.map((row, i) => [i + 1, ...row, rhs[i]!, slopes[i]!]);
  return { names: ['key', ...slopes.map((_, j) => `m${j + 1}`), 'right side', 'slope'], rows, brief: rows };
}

export function bendingNumbers({ bending }: Derived): NumbersTable {
  const row = LAYERS.map((layer) => bending[layer]);
  return { names: LAYERS.map((layer) => LAYER_WORDS[layer].name), rows: [row], brief: [row] };
}

/** Rows evenly over the shown range; the short table has the keys and the times halfway between them. */
function rowsOf(derived: Derived, rowAt: (t: number) => number[]): { rows: number[][]; brief: number[][] } {
  const { times } = derived;
  const [start, end] = shownSpan(derived);
  const between = times.flatMap((t, i) => (i === 0 ? [t] : [(times[i - 1]! + t) / 2, t]));
  return {
    rows: Array.from({ length: ROWS }, (_, i) => rowAt(start + ((end - start) * i) / (ROWS - 1))),
    brief: between.map(rowAt),
  };
}
