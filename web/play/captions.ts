/** What is written beside each figure's title, and what is said of a change. */
import type { Derived } from './derived.ts';
import { LAYER_WORDS, number } from './figures/words.ts';
import type { Touched } from './notices.ts';
import type { PlayState } from './state.ts';

/** What each figure counts: of a coordinate that was taken by the second; the page's own numbers have no unit. */
export function unitsOf(
  { plane, taken }: PlayState,
  unit: string,
): Record<'curve' | 'slope' | 'bend' | 'bending', string> {
  if (taken)
    return {
      curve: `${taken.name}, in ${unit} over seconds`,
      slope: `first derivative, ${unit}/s`,
      bend: `second derivative, ${unit}/s²`,
      bending: `total bending in (${unit})²/s³`,
    };
  return {
    curve: plane ? 'value over across' : 'value over time t',
    slope: plane ? 'speed: the length of the first derivative' : 'first derivative',
    bend: plane ? 'length of the second derivative' : 'second derivative',
    bending: 'total bending: the integral of the squared bend',
  };
}

/** For who hears the page: what is so now. */
export function sentence(
  { keys, selected, plane, time }: PlayState,
  { times, bending }: Derived,
  touched: Touched,
): string {
  const key = keys[selected]!;
  const where = plane ? `${number(key.across)} across` : `time ${number(times[selected]!)}`;
  const what = touched in LAYER_WORDS ? `${LAYER_WORDS[touched as keyof typeof LAYER_WORDS].name}. ` : '';
  const at =
    touched === 'time'
      ? `Time ${number(time)}. `
      : `Key ${selected + 1} of ${keys.length}: value ${number(key.value)}, ${where}. `;
  return `${what}${at}The natural spline bends ${number(bending.natural)} in total.`;
}

export function subscript(count: number): string {
  return String(count).replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!);
}
