/** The sentence after each figure: the effect of the user's last action, with current numbers. */
import type { Derived } from './derived.ts';
import { largestJump } from './figures/rate-figure.ts';
import { LAYER_WORDS, number } from './figures/words.ts';
import { valueAt } from './splines/curve.ts';
import type { Curve } from './splines/curve.ts';
import { MOST_SAMPLES } from './splines/least-bending.ts';
import type { Layer, PlayState, Touched } from './state.ts';

export function curveNotice(state: PlayState, derived: Derived, touched: Touched): string {
  const { curves, samples, sampleCount, times } = derived;
  const { selected, layers } = state;
  switch (touched) {
    case 'linear':
      return 'Notice that straight lines are the shortest way from key to key, and turn sharply at every one.';
    case 'natural':
      return 'Notice that a thin ruler held at the keys would lie like this: it passes them all and bends as little as it can.';
    case 'catmull-rom':
      return `Notice that Catmull-Rom stays within ${number(apart(curves['catmull-rom'][0]!, curves.natural[0]!, times))} of the natural spline and looks as smooth. The second derivative below shows where it is not.`;
    case 'hermite':
    case 'speed':
      return `Notice that a speed given at an end is felt most there, and the whole bends ${number(derived.bending.hermite / derived.bending.natural)} times as much as with free ends.`;
    case 'periodic':
      return 'Notice that a loop knows no ends: beyond the last key the curve comes back to the first, as smoothly as anywhere.';
    case 'samples': {
      if (samples.length === 0) return tooManySamples(derived);
      const off = Math.max(
        ...samples[0]!.values.map((v, i) => Math.abs(v - valueAt(curves.natural[0]!, samples[0]!.times[i]!))),
      );
      return `Notice that ${sampleCount} samples come within ${number(off)} of the natural spline. They take ${sampleCount + times.length} equations; the spline needs ${times.length}.`;
    }
    case 'shaped':
    case 'shaping': {
      const { tension, bias } = state.keys[selected]!;
      if (tension === 0 && bias === 0)
        return `Notice that without tension and bias key ${selected + 1} is passed with the slope that the natural spline has there.`;
      return `Notice that tension ${number(tension)} and bias ${number(bias)} change the slope at key ${selected + 1} alone: only the two pieces beside it move. The second derivative now jumps there.`;
    }
    case 'plane':
      return 'Notice that each coordinate follows a curve of its own, computed in the same way. A shape has thousands of coordinates.';
    case 'spacing':
      return SPACING_NOTICE[state.spacing];
    default:
      return keyNotice(state, derived, layers);
  }
}

const SPACING_NOTICE: Record<PlayState['spacing'], string> = {
  hand: 'Notice that changing a key’s time changes the slope there: time is part of the curve.',
  even: 'Notice that with even times a short step takes as long as a long one: the curve overshoots or loops where keys lie close.',
  root: 'Notice that times by the square root of the distance (centripetal) keep the curve closest to its keys.',
  difference: 'Notice that times by distance (chord length) make the speed even, and wide steps swing out a little.',
};

function keyNotice({ selected }: PlayState, { curves, times, weights }: Derived, layers: readonly Layer[]): string {
  const key = `key ${selected + 1}`;
  if (layers.length > 0 && layers.every((layer) => layer === 'linear' || layer === 'catmull-rom'))
    return `Notice that ${key} moves only the pieces beside it: these curves depend only on nearby keys.`;
  if (times.length < 4 || !curves.natural[0]) return `Notice that ${key} moves the curve everywhere.`;
  return `Notice that moving ${key} changes the whole curve. Beyond the neighbouring keys the change is small: at most ${number(100 * reach(weights[selected]!, times, selected))} % of the key’s movement, in the opposite direction.`;
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
  if (shown.length === 0) return 'Switch a curve on to see it here.';
  const scale = Math.max(...derived.slopes.map(Math.abs), 1);
  const jumping = shown.filter(
    (layer) => (derivative === 2 && layer === 'linear') || largestJump(derived, layer, derivative) > 1e-6 * scale,
  );
  const names = (list: readonly Layer[]): string => list.map((layer) => LAYER_WORDS[layer].name).join(', ');
  const calm = shown.filter((layer) => !jumping.includes(layer));
  const says = derivative === 1 ? 'C1' : 'C2';
  if (jumping.length === 0)
    return derivative === 1
      ? 'Notice that no slope jumps at a key: no corner (C1).'
      : `Notice that no bend jumps either (C2)${shown.includes('natural') ? ', and that it is 0 at free ends: that is what natural means' : ''}.`;
  const what =
    derivative === 1 ? 'the slope jumps at the keys: a corner' : 'the bend jumps at a key: visible as a jerk';
  return `Notice where ${what} (${names(jumping)})${calm.length > 0 ? `; it goes on without a step (${says}) for ${names(calm)}` : ''}.`;
}

function tooManySamples({ sampleCount }: Derived): string {
  return `The brute force is left out: two keys are so close in time that it would take ${sampleCount} samples, and this page solves for ${MOST_SAMPLES} at most. Move those keys apart.`;
}

export function bendingNotice({ layers }: PlayState, derived: Derived): string {
  const { bending, samples } = derived;
  if (layers.includes('samples') && samples.length === 0) return tooManySamples(derived);
  const others = layers.filter((layer) => !['natural', 'samples', 'linear'].includes(layer));
  const least = `Notice that of all curves through these keys the natural one bends least: ${number(bending.natural)}.`;
  if (others.length === 0 || !(bending.natural > 1e-9)) return least;
  const times = others.map((layer) => `${LAYER_WORDS[layer].name} ${number(bending[layer] / bending.natural)} times`);
  return `${least} As much as that bend: ${times.join(', ')}.`;
}

export function systemNotice({ ends }: PlayState, { slopes }: Derived, lit: number): string {
  const n = slopes.length;
  if (lit >= 0) {
    const atEnd = ends !== 'periodic' && (lit === 0 || lit === n - 1);
    if (atEnd && ends === 'natural') return `Row ${lit + 1} says: no bend at key ${lit + 1}, the end is free.`;
    if (atEnd) return `Row ${lit + 1} says: the slope at key ${lit + 1} is the one that is given.`;
    return `Row ${lit + 1} says: the bend with which the curve arrives at key ${lit + 1} is the one with which it leaves.`;
  }
  return ends === 'periodic'
    ? `Notice the two entries in the corners: the first key and the last are neighbours in a loop.`
    : `Notice that each row knows only its neighbours: ${n} equations, solved in one pass down and one up, for all ${n} slopes.`;
}

export function weightsNotice({ time, keys }: PlayState, { weights }: Derived): string {
  const at = weights.map((weight) => valueAt(weight, time));
  const terms = at.map(
    (weight, k) =>
      `${k > 0 ? (weight < 0 ? ' − ' : ' + ') : weight < 0 ? '−' : ''}${number(Math.abs(weight))} × key ${k + 1}`,
  );
  const value = at.reduce((sum, weight, k) => sum + weight * keys[k]!.value, 0);
  return `At t = ${number(time)}: ${terms.join('')} = ${number(value)}. The weights add up to 1, and the same ones serve every coordinate of a shape.`;
}
