/** Stores the playground's state in the page's URL and reads it. Leaves out everything invalid. */
import type { Spacing } from '../model/key-spacing.ts';
import { SPACINGS } from '../model/key-spacing.ts';
import { ignoredValuesSentence } from '../model/ignored-link-values.ts';
import { TYPED_SPEED } from '../model/speeds.ts';
import { clamp } from '../model/time-scale.ts';
import type { Ends } from './splines/slopes.ts';
import {
  INITIAL,
  LAYERS,
  MAX_KEYS,
  MAX_SAMPLES,
  MIN_SAMPLES,
  MAX_VALUE,
  shownTimes,
  keysValidationError,
} from './state.ts';
import type { Layer, PlayKey, PlayState } from './state.ts';

const ENDS: readonly Ends[] = ['natural', 'hermite', 'periodic'];
const SPACING_NAMES = ['hand', ...(Object.keys(SPACINGS) as Spacing[])] as const;
/** Longest name or unit, in characters. */
const LONGEST = 60;

export interface Linked {
  state: PlayState;
  /** A sentence about left-out parts of the link, or null. */
  ignoredValues: string | null;
}

/** The fragment without '#': the differences from the initial state. */
export function writeLink(state: PlayState): string {
  const params = new URLSearchParams();
  const put = (name: string, value: string, fallback: string): void => {
    if (value !== fallback) params.set(name, value);
  };
  const keysOf = ({ keys }: PlayState): string => keys.map(keyText).join(' ');
  put('keys', keysOf(state), keysOf(INITIAL));
  put('show', state.layers.join(' '), INITIAL.layers.join(' '));
  put('ends', state.ends, INITIAL.ends);
  put('speeds', state.speeds.map(shortest).join(' '), INITIAL.speeds.map(shortest).join(' '));
  put('samples', String(state.samples), String(INITIAL.samples));
  put('key', String(state.selected + 1), String(INITIAL.selected + 1));
  put('t', shortest(state.time), shortest(INITIAL.time));
  put('spacing', state.spacing, INITIAL.spacing);
  if (state.plane) params.set('plane', '1');
  if (state.taken) params.set('of', [state.taken.name, state.taken.unit].join('|'));
  return params.toString();
}

/** Reads a link; null if the fragment is empty. */
export function readLink(hash: string): Linked | null {
  const params = new URLSearchParams(hash.replace(/^#/, ''));
  if ([...params.keys()].length === 0) return null;
  const unfit: string[] = [];
  const take = <T>(name: string, read: (text: string) => T | undefined): T | undefined => {
    const text = params.get(name);
    const value = text === null ? undefined : read(text);
    if (text !== null && value === undefined) unfit.push(name);
    return value;
  };
  const linkedKeys = take('keys', readKeys);
  const wrong = linkedKeys ? keysValidationError(linkedKeys) : null;
  if (wrong) unfit.push(`keys (${wrong})`);
  const keys = linkedKeys && !wrong ? linkedKeys : INITIAL.keys;
  const selected = take('key', (text) => whole(text, 1, keys.length)) ?? Math.min(INITIAL.selected + 1, keys.length);
  const [earliest, latest] = shownTimes([keys[0]!.time, keys.at(-1)!.time]);
  const state: PlayState = {
    keys,
    layers: take('show', readLayers) ?? INITIAL.layers,
    ends: take('ends', (text) => oneOf(text, ENDS)) ?? INITIAL.ends,
    speeds: take('speeds', readSpeeds) ?? INITIAL.speeds,
    samples: take('samples', (text) => whole(text, MIN_SAMPLES, MAX_SAMPLES)) ?? INITIAL.samples,
    selected: selected - 1,
    time: clamp(take('t', fitting) ?? INITIAL.time, earliest, latest),
    plane: take('plane', (text) => oneOf(text, ['0', '1'])) === '1',
    spacing: take('spacing', (text) => oneOf(text, SPACING_NAMES)) ?? INITIAL.spacing,
    taken: null,
  };
  const [name, unit = ''] = (params.get('of') ?? '').slice(0, 2 * LONGEST).split('|');
  if (name && keys !== INITIAL.keys) state.taken = { from: '', shape: '', name, unit, keys: keys.length };
  return { state, ignoredValues: ignoredValuesSentence(unfit) };
}

function keyText({ time, value, across, tension, bias }: PlayKey): string {
  const numbers = [exact(time), ...[value, across, tension, bias].map(shortest)];
  while (numbers.length > 3 && numbers.at(-1) === '0') numbers.pop();
  return numbers.join(',');
}

function readKeys(text: string): PlayKey[] | undefined {
  // One entry above the limit is enough to report too many.
  const entries = text.split(' ', MAX_KEYS + 1);
  const keys = entries.map((entry): PlayKey => {
    const [time = NaN, value = NaN, across = 0, tension = 0, bias = 0] = entry.split(',', 5).map(Number);
    return { time, value, across, tension, bias };
  });
  return keys.every((key) => Object.values(key).every(Number.isFinite)) ? keys : undefined;
}

/** Reads the layers; undefined if one of them is unknown. */
function readLayers(text: string): Layer[] | undefined {
  const words = text.split(' ', LAYERS.length + 1).filter((word) => word !== '');
  return words.every((word) => oneOf(word, LAYERS)) ? LAYERS.filter((layer) => words.includes(layer)) : undefined;
}

function readSpeeds(text: string): [number, number] | undefined {
  const [start = NaN, end = NaN, ...more] = text.split(' ', 3).map(Number);
  const good = more.length === 0 && [start, end].every((speed) => speed >= 0 && speed <= TYPED_SPEED);
  return good ? [start, end] : undefined;
}

function fitting(text: string): number | undefined {
  const value = Number(text);
  return Math.abs(value) <= MAX_VALUE ? value : undefined;
}

function whole(text: string, min: number, max: number): number | undefined {
  const value = Number(text);
  return Number.isInteger(value) && value >= min && value <= max ? value : undefined;
}

function oneOf<T extends string>(text: string, values: readonly T[]): T | undefined {
  return values.find((value) => value === text);
}

function shortest(value: number): string {
  return String(Number(value.toPrecision(5)));
}

/** Full precision keeps the order of very close times. */
function exact(value: number): string {
  return String(Number(value.toPrecision(10)));
}
