/** The playground's state in the page's address, and back. Whatever does not fit is left out. */
import type { Spacing } from '../model/key-spacing.ts';
import { SPACINGS } from '../model/key-spacing.ts';
import { TYPED_SPEED } from '../model/speeds.ts';
import type { Ends } from './splines/slopes.ts';
import { INITIAL, LAYERS, MAX_KEYS, MAX_SAMPLES, MIN_KEYS, MIN_SAMPLES } from './state.ts';
import type { Layer, PlayKey, PlayState } from './state.ts';

const ENDS: readonly Ends[] = ['natural', 'hermite', 'periodic'];
const SPACING_NAMES = ['hand', ...(Object.keys(SPACINGS) as Spacing[])] as const;
/** What is farther off is no value that somebody meant. */
const MOST = 1e6;

/** The fragment without its '#': only what differs from how the page opens. */
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

/** null where the fragment says nothing. */
export function readLink(hash: string): PlayState | null {
  const params = new URLSearchParams(hash.replace(/^#/, ''));
  if ([...params.keys()].length === 0) return null;
  const words = (name: string): string[] | undefined => params.get(name)?.split(' ');
  const keys = readKeys(words('keys')) ?? INITIAL.keys;
  const speeds = words('speeds')?.map(Number);
  const [name, unit] = params.get('of')?.split('|') ?? [];
  return {
    keys,
    layers: words('show') ? LAYERS.filter((layer: Layer) => words('show')!.includes(layer)) : INITIAL.layers,
    ends: oneOf(params.get('ends'), ENDS) ?? INITIAL.ends,
    speeds:
      speeds?.length === 2 && speeds.every((speed) => speed >= 0 && speed <= TYPED_SPEED)
        ? [speeds[0]!, speeds[1]!]
        : INITIAL.speeds,
    samples: whole(params.get('samples'), MIN_SAMPLES, MAX_SAMPLES) ?? INITIAL.samples,
    selected: (whole(params.get('key'), 1, keys.length) ?? Math.min(INITIAL.selected + 1, keys.length)) - 1,
    time: fitting(params.get('t')) ?? INITIAL.time,
    plane: params.get('plane') === '1',
    spacing: oneOf(params.get('spacing'), SPACING_NAMES) ?? INITIAL.spacing,
    taken: name && keys !== INITIAL.keys ? { from: '', shape: '', name, unit: unit ?? '', keys: keys.length } : null,
  };
}

function keyText({ time, value, across, tension, bias }: PlayKey): string {
  const numbers = [time, value, across, tension, bias].map(shortest);
  while (numbers.length > 3 && numbers.at(-1) === '0') numbers.pop();
  return numbers.join(',');
}

function readKeys(entries: string[] | undefined): PlayKey[] | undefined {
  const keys = entries?.map((entry): PlayKey => {
    const [time = NaN, value = NaN, across = 0, tension = 0, bias = 0] = entry.split(',').map(Number);
    return { time, value, across, tension, bias };
  });
  const good =
    keys &&
    keys.length >= MIN_KEYS &&
    keys.length <= MAX_KEYS &&
    keys.every(
      ({ time, value, across, tension, bias }, i) =>
        [time, value, across].every((number) => Math.abs(number) <= MOST) &&
        Math.abs(tension) <= 1 &&
        Math.abs(bias) <= 1 &&
        (i === 0 || time > keys[i - 1]!.time),
    );
  return good ? keys : undefined;
}

function fitting(text: string | null): number | undefined {
  const value = Number(text ?? NaN);
  return Math.abs(value) <= MOST ? value : undefined;
}

function whole(text: string | null, least: number, most: number): number | undefined {
  const value = Number(text ?? NaN);
  return Number.isInteger(value) && value >= least && value <= most ? value : undefined;
}

function oneOf<T extends string>(text: string | null, values: readonly T[]): T | undefined {
  return values.find((value) => value === text);
}

function shortest(value: number): string {
  return String(Number(value.toPrecision(5)));
}
