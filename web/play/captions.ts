/** Subtitles of the figures, and announcements of changes. */
import type { Axes } from '../plots/plot-files.ts';
import type { Shown } from './derived.ts';
import { LAYER_WORDS, number } from './figures/words.ts';
import type { PlayState } from './state.ts';

export type FigureId = 'curve' | 'slope' | 'bend' | 'weights' | 'bending' | 'system';

/** Subtitle of each figure. It states the unit of a coordinate of a shape; the page's own numbers have no unit. */
export function unitsOf({ plane, taken, keys }: PlayState): Record<FigureId, string> {
  const common = {
    weights: `w₁ to w${subscript(keys.length)} over time`,
    system: `${keys.length} × ${keys.length}, for the slopes m`,
  };
  if (taken) {
    const { name, unit } = taken;
    return {
      ...common,
      curve: `${name} in ${unit}, over time in seconds`,
      slope: `first derivative, ${unit}/s`,
      bend: `second derivative, ${unit}/s²`,
      bending: `total bending in (${unit})²/s³`,
    };
  }
  return {
    ...common,
    curve: plane ? 'value against x' : 'value over time t',
    slope: plane ? 'speed: the length of the first derivative' : 'first derivative',
    bend: plane ? 'length of the second derivative' : 'second derivative',
    bending: 'total bending: the integral of the squared second derivative',
  };
}

/** Axis titles for a figure's file. */
export function axesOf({ plane, taken }: PlayState, id: FigureId): Axes {
  const unit = taken?.unit ?? '';
  const of = (name: string, power = ''): string => (taken ? `${name} (${unit}${power})` : name);
  const y = { curve: of(taken?.name ?? 'Value'), slope: of('Slope', '/s'), bend: of('Bend', '/s²'), weights: 'Weight' };
  const x = plane && id === 'curve' ? 'Across' : taken ? 'Time (s)' : 'Time t';
  return { x, y: id in y ? y[id as keyof typeof y] : '' };
}

/** Announces the current state to screen readers. */
export function sentence({ state, derived: { times, bending }, lastAction }: Shown): string {
  const { keys, selected, plane, time } = state;
  const key = keys[selected]!;
  const where = plane ? `${number(key.across)} across` : `time ${number(times[selected]!)}`;
  const what = lastAction in LAYER_WORDS ? `${LAYER_WORDS[lastAction as keyof typeof LAYER_WORDS].name}. ` : '';
  const at =
    lastAction === 'time'
      ? `Time ${number(time)}. `
      : `Key ${selected + 1} of ${keys.length}: value ${number(key.value)}, ${where}. `;
  return `${what}${at}Total bending of the natural spline: ${number(bending.natural)}.`;
}

function subscript(count: number): string {
  return String(count).replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!);
}
