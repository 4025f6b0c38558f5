/** Values derived from the state: times, curves, weights, the system, and total bending. */
import { SPACINGS, spacedTimes } from '../model/key-spacing.ts';
import { totalBending, valueAt } from './splines/curve.ts';
import type { Curve, Derivative } from './splines/curve.ts';
import { fitCurve, weightCurves } from './splines/fit.ts';
import type { CurveKind, FitOptions } from './splines/fit.ts';
import { MAX_SOLVED_SAMPLES, curveThrough, minimiseBending, minSamples } from './splines/minimise-bending.ts';
import { slopeSystem } from './splines/slopes.ts';
import type { Data } from './splines/slopes.ts';
import type { System } from './splines/solve.ts';
import { solveDense } from './splines/solve.ts';
import { LAYERS } from './state.ts';
import type { Layer, PlayState, LastAction } from './state.ts';

/** One curve per coordinate: value, and in two dimensions also across. */
export type Curves = readonly Curve[];

export interface Derived {
  times: number[];
  /** Times of the first and last key. */
  range: readonly [number, number];
  /** Curves of all layers except the samples, shown or not. */
  curves: Record<CurveKind, Curves>;
  /** The direct minimiser, one per coordinate; empty if it needs more than MAX_SOLVED_SAMPLES. */
  samples: Data[];
  /** The smoothest curve through these samples and the keys, one per coordinate. */
  sampled: Curves;
  /** Number of samples in use, or required. */
  sampleCount: number;
  /** Total bending of each layer between the first and last key; NaN for samples that were not solved. */
  bending: Record<Layer, number>;
  /** The system of the value curve with the chosen ends. */
  system: System;
  slopes: number[];
  weights: Curve[];
}

/** The input of the figures. */
export interface Shown {
  state: PlayState;
  derived: Derived;
  lastAction: LastAction;
  /** A key to highlight in addition to the selected one; -1: none. */
  lit: number;
}

export function derive(state: PlayState): Derived {
  const times = timesOf(state);
  const options: FitOptions = { speeds: state.speeds, ends: state.ends, shaping: state.keys };
  const coordinates = [state.keys.map(({ value }) => value)];
  if (state.plane) coordinates.push(state.keys.map(({ across }) => across));
  const curvesOf = (kind: CurveKind): Curves => coordinates.map((values) => fitCurve(kind, { times, values }, options));
  const kinds = LAYERS.filter((layer) => layer !== 'samples');
  const curves = Object.fromEntries(kinds.map((kind) => [kind, curvesOf(kind)])) as unknown as Record<
    CurveKind,
    Curves
  >;
  const sampleCount = Math.max(state.samples, minSamples(times));
  const solved = sampleCount <= MAX_SOLVED_SAMPLES ? coordinates : [];
  const samples = solved.map((values) => minimiseBending({ times, values }, sampleCount));
  const sampled = samples.map((one, i) => curveThrough(one, { times, values: coordinates[i]! }));
  const sum = (numbers: number[]): number => numbers.reduce((total, number) => total + number, 0);
  const intervals = times.length - 1;
  const bendingOf = (layer: Layer): number => {
    if (layer === 'samples') return sampled.length > 0 ? sum(sampled.map((curve) => totalBending(curve))) : NaN;
    return sum(curves[layer].map((curve) => totalBending(curve, intervals)));
  };
  const system = slopeSystem({ times, values: coordinates[0]! }, state.ends, state.speeds);
  return {
    times,
    range: [times[0]!, times.at(-1)!],
    curves,
    samples,
    sampled,
    sampleCount,
    bending: Object.fromEntries(LAYERS.map((layer) => [layer, bendingOf(layer)])) as Record<Layer, number>,
    system,
    slopes: solveDense(system),
    weights: weightCurves(state.ends, times, options),
  };
}

/** Times set by the user, or from the distances between keys. */
export function timesOf({ keys, spacing, plane }: PlayState): number[] {
  if (spacing === 'hand') return keys.map(({ time }) => time);
  const distance = keys
    .slice(1)
    .map((key, i) => Math.hypot(key.value - keys[i]!.value, plane ? key.across - keys[i]!.across : 0));
  return spacedTimes(keys[0]!.time, keys.at(-1)!.time, distance, SPACINGS[spacing]);
}

/** The curve's value at t; in two dimensions, the length of the derivative. */
export function amount(curves: Curves, t: number, derivative: Derivative): number {
  const numbers = curves.map((curve) => valueAt(curve, t, derivative));
  return numbers.length > 1 && derivative > 0 ? Math.hypot(...numbers) : numbers[0]!;
}
