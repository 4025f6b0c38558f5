/** The sentence after each figure: the effect of the user's last action, with current numbers. */
import type { Derived } from './derived.ts';
import { largestJump } from './figures/rate-figure.ts';
import { LAYER_WORDS, number } from './figures/words.ts';
import { valueAt } from './splines/curve.ts';
import type { Curve } from './splines/curve.ts';
import { MAX_SOLVED_SAMPLES } from './splines/minimise-bending.ts';
import type { Layer, PlayState, LastAction } from './state.ts';

export function curveNotice(state: PlayState, derived: Derived, lastAction: LastAction): string {
  const { curves, samples, sampleCount, times } = derived;
  const { selected, layers } = state;
  const unit = state.taken?.unit ?? '';
  switch (lastAction) {
    case 'linear':
      return 'Straight lines are the shortest path from key to key, but turn sharply at every key.';
    case 'natural':
      return 'A thin ruler held at the keys takes this shape. It passes through all keys and bends as little as possible.';
    case 'catmull-rom':
      return `Catmull-Rom stays within ${number(apart(curves['catmull-rom'][0]!, curves.natural[0]!, times))}${unit} of the natural spline and looks as smooth. The second derivative below shows where it differs.`;
    case 'hermite':
    case 'speed':
      return `A given end speed changes the curve mostly near that end. The curve bends ${number(derived.bending.hermite / derived.bending.natural)} times as much as with free ends.`;
    case 'periodic':
      return 'A loop has no ends. After the last key, the curve returns to the first just as smoothly.';
    case 'samples': {
      if (samples.length === 0) return tooManySamples(derived);
      const off = Math.max(
        ...samples[0]!.values.map((v, i) => Math.abs(v - valueAt(curves.natural[0]!, samples[0]!.times[i]!))),
      );
      return `The ${sampleCount} samples come within ${number(off)}${unit} of the natural spline. They need ${sampleCount + times.length} equations, the spline only ${times.length}.`;
    }
    case 'shaped':
    case 'shaping': {
      const { tension, bias } = state.keys[selected]!;
      if (tension === 0 && bias === 0)
        return `Without tension and bias, the slope at key ${selected + 1} is that of the natural spline.`;
      return `Tension ${number(tension)} and bias ${number(bias)} change the slope at key ${selected + 1} only, so only the pieces next to it move. The second derivative now jumps where these pieces begin and end.`;
    }
    case 'plane':
      return 'Each coordinate follows its own curve, computed in the same way. A shape has thousands of coordinates.';
    case 'spacing':
      return SPACING_NOTICE[state.spacing];
    default:
      return keyNotice(state, derived, layers);
  }
}

const SPACING_NOTICE: Record<PlayState['spacing'], string> = {
  hand: 'Changing a key’s time changes its slope, because time is part of the curve.',
  even: 'With evenly spaced times, a short step takes as long as a long step. The curve overshoots or loops where keys are close.',
  root: 'Spacing the times by the square root of the distance (centripetal) keeps the curve closest to the straight lines between its keys.',
  difference:
    'Spacing the times by the distance (chord length) makes the speed even. The curve overshoots a little on long steps.',
};

function keyNotice({ selected }: PlayState, { curves, times, weights }: Derived, layers: readonly Layer[]): string {
  const key = `key ${selected + 1}`;
  if (layers.length > 0 && layers.every((layer) => layer === 'linear' || layer === 'catmull-rom'))
    return `Moving ${key} moves only the pieces near it, because these curves depend only on nearby keys.`;
  if (times.length < 4 || !curves.natural[0]) return `Moving ${key} changes the whole curve.`;
  return `Moving ${key} changes the whole curve. Beyond the neighbouring keys the change is small: at most ${number(100 * reach(weights[selected]!, times, selected))} % of the key’s movement, in the opposite direction.`;
}

const SAMPLED = 40;

/** The largest weight of a key outside the two intervals next to it. */
function reach(weight: Curve, times: readonly number[], key: number): number {
  let most = 0;
  times.slice(1).forEach((to, i) => {
    if (i + 1 >= key && i <= key) return;
    for (let step = 1; step < SAMPLED; step += 1)
      most = Math.max(most, Math.abs(valueAt(weight, times[i]! + ((to - times[i]!) * step) / SAMPLED)));
  });
  return most;
}

/** The largest distance between two curves in the range of the keys. */
function apart(a: Curve, b: Curve, times: readonly number[]): number {
  const [start, end] = [times[0]!, times.at(-1)!];
  const at = (i: number): number => start + ((end - start) * i) / 200;
  return Math.max(...Array.from({ length: 201 }, (_, i) => Math.abs(valueAt(a, at(i)) - valueAt(b, at(i)))));
}

export function rateNotice({ layers }: PlayState, derived: Derived, derivative: 1 | 2): string {
  const shown = layers.filter((layer) => layer !== 'samples');
  if (shown.length === 0) return 'Switch on a curve to see it here.';
  const scale = Math.max(...derived.slopes.map(Math.abs), 1);
  const jumping = shown.filter(
    (layer) => (derivative === 2 && layer === 'linear') || largestJump(derived, layer, derivative) > 1e-6 * scale,
  );
  const names = (list: readonly Layer[]): string => list.map((layer) => LAYER_WORDS[layer].name).join(', ');
  const calm = shown.filter((layer) => !jumping.includes(layer));
  const says = derivative === 1 ? 'C1' : 'C2';
  if (jumping.length === 0)
    return derivative === 1
      ? 'No slope jumps at a key, so there is no corner (C1).'
      : `No second derivative jumps at a key (C2)${shown.includes('natural') ? '. At free ends it is 0: this is what “natural” means' : ''}.`;
  const what =
    derivative === 1
      ? 'These curves have corners, because their slope jumps at the keys'
      : 'These curves have a visible jerk, because their second derivative jumps at a key';
  return `${what}: ${names(jumping)}.${calm.length > 0 ? ` Continuous (${says}): ${names(calm)}.` : ''}`;
}

function tooManySamples({ sampleCount }: Derived): string {
  return `Brute force is not shown. Two keys are so close in time that it would need ${sampleCount} samples, but this page solves for at most ${MAX_SOLVED_SAMPLES}. Move these keys apart.`;
}

export function bendingNotice({ layers }: PlayState, derived: Derived): string {
  const { bending, samples } = derived;
  if (layers.includes('samples') && samples.length === 0) return tooManySamples(derived);
  const others = layers.filter((layer) => !['natural', 'samples', 'linear'].includes(layer));
  const least = `Of all curves through these keys, the natural spline bends least: ${number(bending.natural)}.`;
  if (others.length === 0 || !(bending.natural > 1e-9)) return least;
  const times = others.map((layer) => `${LAYER_WORDS[layer].name} ${number(bending[layer] / bending.natural)} times`);
  return `${least} Relative to the natural spline: ${times.join(', ')}.`;
}

export function systemNotice({ ends }: PlayState, { slopes }: Derived, lit: number): string {
  const n = slopes.length;
  if (lit >= 0) {
    const atEnd = ends !== 'periodic' && (lit === 0 || lit === n - 1);
    if (atEnd && ends === 'natural')
      return `Row ${lit + 1}: the second derivative at key ${lit + 1} is 0, because the end is free.`;
    if (atEnd) return `Row ${lit + 1}: the slope at key ${lit + 1} has the given value.`;
    return `Row ${lit + 1}: the second derivative is the same on both sides of key ${lit + 1}.`;
  }
  return ends === 'periodic'
    ? 'The two entries in the corners connect the first and the last key, which are neighbours in a loop.'
    : `Each row involves only neighbouring keys. One pass down and one pass up solve the ${n} equations for all ${n} slopes.`;
}

export function weightsNotice({ time, keys }: PlayState, { weights }: Derived): string {
  const at = weights.map((weight) => valueAt(weight, time));
  const terms = at.map(
    (weight, k) =>
      `${k > 0 ? (weight < 0 ? ' − ' : ' + ') : weight < 0 ? '−' : ''}${number(Math.abs(weight))} × key ${k + 1}`,
  );
  const value = at.reduce((sum, weight, k) => sum + weight * keys[k]!.value, 0);
  return `At t = ${number(time)}: ${terms.join('')} = ${number(value)}. The weights add up to 1. Every coordinate of a shape has the same weights.`;
}
