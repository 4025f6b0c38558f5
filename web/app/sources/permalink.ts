/**
 * Converts the state of a built-in sample to a link's fragment and back. Only differences from the defaults are
 * written. Links are untrusted, so invalid values are left out.
 */
import { goneIn } from '../../engine/api/gone-options.ts';
import { METHODS } from '../../engine/api/methods.ts';
import { ENCODING, MAX_TIME, MAX_TURNS, MOTION, PER_KEY } from '../../engine/api/option-table.ts';
import type { Option } from '../../engine/api/option-table.ts';
import { choiceNow, validationError } from '../../engine/api/options.ts';
import type { AddedTurns, Method } from '../../engine/api/types.ts';
import { setShaping, setTurns } from '../../model/edits.ts';
import { MAX_FPS, MIN_FPS } from '../../model/frames.ts';
import { ignoredValuesSentence } from '../../model/ignored-link-values.ts';
import { forPage, isPose, pageOptions } from '../../model/page-options.ts';
import { pinsFromText, pinsText } from '../../model/pins.ts';
import type { ShapingNumber } from '../../model/shaping.ts';
import { SHAPING_NUMBERS, turnsOf } from '../../model/shaping.ts';
import { MIN_SHARE } from '../../ui/divider.ts';
import type { CameraPose } from '../../model/camera.ts';
import type { AppState, Colouring, Doc, Encoding, LoopMode, Motion, View } from '../../model/state.ts';
import { DEFAULT_VIEW, MIN_FILM_SHAPES, MIN_ONION_SPACING, MAX_FILM_SHAPES } from '../../model/state.ts';
import { MAX_COMPARED, MAX_ONION_SKINS, PRESENTED, SPEEDS } from '../../model/state.ts';

export interface Permalink {
  sample: string;
  /** Pose and time of each key; null for the sample's own keys. */
  keys: [number, number][] | null;
  /** Each list has one value per key. */
  shaping: Record<ShapingNumber, number[]>;
  /** Added turns of the whole shape, one value per key. */
  turns: number[];
  partTurns: Required<AddedTurns>[];
  motion: Partial<Motion>;
  encoding: Partial<Encoding>;
  view: Partial<View>;
  time: number | null;
  speed: number | null;
  loop: LoopMode | null;
  between: [number, number] | null;
  fps: number | null;
  playing: boolean;
  /** Names of values that are invalid. */
  unfit: string[];
}

const FLAGS = [
  'wireframe',
  'floor',
  'onion',
  'film',
  'ghostWire',
  'ghostBeside',
  'ghostDifference',
  'ghostSizes',
] as const;
const MAX_KEYS = 256;
const MAX_PART_TURNS = 1024;
/** Largest camera distance; beyond it the shape is invisible. */
const MAX_DISTANCE = 1e9;

/** The fragment without '#', or null for the user's own files, which stay on this machine. */
export function writePermalink(state: AppState, initial: Doc): string | null {
  if (state.source.kind !== 'sample') return null;
  const { doc, view } = state;
  const params = new URLSearchParams({ sample: state.source.id });
  const put = (name: string, value: unknown, fallback: unknown): void => {
    if (value === fallback || value === null) return;
    params.set(name, typeof value === 'string' ? value : shortest(Number(value)));
  };
  const putList = (name: string, values: number[], fallback: number): void => {
    if (values.some((value) => value !== fallback)) params.set(name, values.map(shortest).join(','));
  };
  const keys = doc.keys.map((key) => `${key.pose}@${shortest(key.time)}`).join(',');
  put('keys', keys, initial.keys.map((key) => `${key.pose}@${shortest(key.time)}`).join(','));
  const shapings = doc.keys.map((key) => key.shaping);
  for (const name of SHAPING_NUMBERS)
    putList(
      name,
      shapings.map((shaping) => shaping[name]),
      PER_KEY[name].default,
    );
  putList(
    'turns',
    shapings.map((shaping) => turnsOf(shaping)),
    0,
  );
  const partTurns = shapings.flatMap(({ turns }, key) =>
    turns.flatMap((one) => (one.component === undefined ? [] : [`${key}:${one.component}:${one.turns}`])),
  );
  put('partTurns', partTurns.join(','), '');
  const putOptions = (options: object, fallbacks: object): void =>
    Object.entries(fallbacks).forEach(([name, fallback]) => put(name, options[name as never], fallback));
  putOptions(linked(doc.motion), linked(initial.motion));
  putOptions(doc.encoding, initial.encoding);
  // A link has no regions.
  if (view.colouring !== 'regions') put('colour', view.colouring, DEFAULT_VIEW.colouring);
  put('shading', view.shading, DEFAULT_VIEW.shading);
  for (const name of FLAGS) put(name, view[name], DEFAULT_VIEW[name]);
  put('compare', view.compare.join(','), '');
  put('split', view.split, null);
  put('onionSkins', view.onionSkins, DEFAULT_VIEW.onionSkins);
  put('onionSpacing', view.onionSpacing, null);
  put('filmShapes', view.filmShapes, null);
  if (view.camera)
    params.set('camera', [...view.camera.position, ...view.camera.target].map((x) => x.toPrecision(5)).join(','));
  params.set('t', shortest(state.time));
  put('speed', state.play.speed, null);
  put('loop', state.play.loop, 'bounce');
  put('between', state.play.between?.map(shortest).join(',') ?? null, null);
  put('fps', state.play.fps, null);
  put('present', PRESENTED.find((one) => one === view.present) ?? null, null);
  put('window', view.window?.map(shortest).join(',') ?? null, null);
  return params.toString();
}

/** The part of a motion that links store. Regions are too long for them. */
function linked({ pins, regions: _, ...motion }: Motion): object {
  return { ...motion, pins: pinsText(pins, shortest) };
}

export function readPermalink(fragment: string): Permalink | null {
  const params = new URLSearchParams(fragment.replace(/^#/, ''));
  const sample = params.get('sample');
  if (!sample) return null;
  const unfit: string[] = [];
  const take: Take = (name, read) => {
    const text = params.get(name);
    const value = text ? read(text) : undefined;
    if (text && value === undefined) unfit.push(name);
    return value;
  };
  unfit.push(...goneIn(Object.fromEntries(params)));
  return {
    sample,
    keys: take('keys', readKeys) ?? null,
    shaping: Object.fromEntries(
      SHAPING_NUMBERS.map((name) => [name, take(name, (text) => shapingNumbers(name, text)) ?? []]),
    ) as Permalink['shaping'],
    turns: take('turns', (text) => allGood(numbers(text), isTurns)) ?? [],
    partTurns: take('partTurns', readPartTurns) ?? [],
    motion: defined(forPage(MOTION, ({ page, option }) => take(page, (text) => optionValue(option, text)))),
    encoding: defined(forPage(ENCODING, ({ page, option }) => take(page, (text) => optionValue(option, text)))),
    view: readView(take),
    time: take('t', time) ?? null,
    speed: take('speed', (text) => oneOfNumbers(text, SPEEDS)) ?? null,
    loop: take('loop', (text) => oneOf(text, ['once', 'loop', 'bounce'] as const)) ?? null,
    between: take('between', stretch) ?? null,
    fps: take('fps', (text) => numberFrom(text, MIN_FPS, MAX_FPS)) ?? null,
    playing: params.get('play') === '1',
    unfit,
  };
}

/** A sentence about parts of the link that are missing from the resulting document, or null. */
export function ignoredValues({ unfit, motion, keys }: Permalink, doc: Doc): string | null {
  const names = [...unfit];
  if ((motion.period ?? null) !== doc.motion.period) names.push('period');
  if (keys && (keys.length !== doc.keys.length || keys.some(([, time], i) => time !== doc.keys[i]!.time)))
    names.push('keys');
  return ignoredValuesSentence(names);
}

/** Applies a link to its sample's initial document. Leaves out poses and components that the sample lacks. */
export function applyPermalink(doc: Doc, link: Permalink, components = Infinity): Doc {
  const poses = doc.keys.length;
  const known = (pose: number | null | undefined): boolean => pose === null || pose === undefined || pose < poses;
  const usable = link.keys !== null && link.keys.length >= 2 && link.keys.every(([pose]) => known(pose));
  const keys = usable ? link.keys!.map(([pose, time]) => ({ ...doc.keys[pose]!, time })) : doc.keys;
  const encoding = { ...doc.encoding, ...link.encoding };
  for (const name of POSES) if (!known(encoding[name])) encoding[name] = null;
  const motion = { ...doc.motion, ...link.motion };
  // A loop takes longer than its keys, because the way back to the first also takes time.
  if (motion.period !== null && motion.period <= keys.at(-1)!.time - keys[0]!.time) motion.period = null;
  let next: Doc = { keys, encoding, motion };
  const each = (values: number[], set: (key: number, value: number) => void): void => {
    if (values.length === keys.length) values.forEach((value, key) => set(key, value));
  };
  for (const name of SHAPING_NUMBERS) {
    each(link.shaping[name], (key, value) => {
      next = setShaping(next, name, key, value);
    });
  }
  each(link.turns, (key, turns) => {
    next = setTurns(next, key, { turns });
  });
  for (const { key, ...added } of link.partTurns) if (added.component < components) next = setTurns(next, key, added);
  return next;
}

const POSES = pageOptions(ENCODING).flatMap(({ page, option }) =>
  isPose(option) ? [page as 'referencePose' | 'startTangentPose' | 'endTangentPose'] : [],
);

/** Reads a value of the link; undefined if it is missing or invalid. */
type Take = <T>(name: string, read: (text: string) => T | undefined) => T | undefined;

/** The value of an option, if valid. */
function optionValue(option: Option, text: string): unknown {
  if (isPose(option)) return index(text);
  if (option.kind === 'regions') return undefined;
  if (option.kind === 'pins') return pinsFromText(text);
  const value = option.kind === 'choice' ? choiceNow(option, text) : option.kind === 'flag' ? flag(text) : number(text);
  return value !== undefined && validationError(option, value) === null ? value : undefined;
}

const isTurns = (value: number): boolean => Number.isInteger(value) && Math.abs(value) <= MAX_TURNS;

function shapingNumbers(name: ShapingNumber, text: string): number[] | undefined {
  return allGood(numbers(text), (value) => validationError(PER_KEY[name], value) === null);
}

function readView(take: Take): Partial<View> {
  const window = take('window', stretch);
  return defined({
    colouring: take('colour', (text) =>
      oneOf(text, [
        'phase',
        'texture',
        'patches',
        'rotation',
        'stretch',
        'distance',
      ] as const satisfies readonly Colouring[]),
    ),
    shading: take('shading', (text) => oneOf(text, ['smooth', 'flat'] as const)),
    ...(Object.fromEntries(FLAGS.map((name) => [name, take(name, flag)])) as Record<
      (typeof FLAGS)[number],
      boolean | undefined
    >),
    compare: take('compare', methods),
    split: take('split', (text) => numberFrom(text, MIN_SHARE, 1 - MIN_SHARE)),
    onionSkins: take('onionSkins', (text) => wholeFrom(text, 1, MAX_ONION_SKINS)),
    onionSpacing: take('onionSpacing', (text) => numberFrom(text, MIN_ONION_SPACING, MAX_TIME)),
    filmShapes: take('filmShapes', (text) => wholeFrom(text, MIN_FILM_SHAPES, MAX_FILM_SHAPES)),
    camera: take('camera', readCamera),
    window,
    present: take('present', (text) => oneOf(text, PRESENTED)),
  });
}

/** The known methods; undefined if none is known. */
function methods(text: string): Method[] | undefined {
  const known = text.split(',').flatMap((name) => oneOf(name, METHODS) ?? []);
  return known.length > 0 ? [...new Set(known)].slice(0, MAX_COMPARED) : undefined;
}

function wholeFrom(text: string, min: number, max: number): number | undefined {
  const count = numberFrom(text, min, max);
  return Number.isInteger(count) ? count : undefined;
}

function readCamera(text: string): CameraPose | undefined {
  const values = allGood(numbers(text), (value) => Math.abs(value) <= MAX_DISTANCE);
  if (values?.length !== 6) return undefined;
  const [px, py, pz, tx, ty, tz] = values as [number, number, number, number, number, number];
  if (px === tx && py === ty && pz === tz) return undefined;
  return { position: [px, py, pz], target: [tx, ty, tz] };
}

function stretch(text: string): [number, number] | undefined {
  const values = allGood(numbers(text), isTime);
  return values?.length === 2 && values[0]! < values[1]! ? [values[0]!, values[1]!] : undefined;
}

/** Times must increase strictly, otherwise the whole list is left out. */
function readKeys(text: string): [number, number][] | undefined {
  const keys = text.split(',').map((entry) => entry.split('@').map(Number) as [number, number]);
  const good =
    keys.length <= MAX_KEYS &&
    keys.every(
      ([pose, time], i) => Number.isInteger(pose) && pose >= 0 && isTime(time) && (i === 0 || time > keys[i - 1]![1]),
    );
  return good ? keys : undefined;
}

/** The valid entries; undefined if there are none. */
function readPartTurns(text: string): Required<AddedTurns>[] | undefined {
  const entries = text
    .split(',')
    .slice(0, MAX_PART_TURNS)
    .map((entry) => entry.split(':').map(Number));
  const good = entries.filter((entry) => {
    const [key, component, turns] = entry;
    return entry.length === 3 && entry.every(Number.isInteger) && key! >= 0 && component! >= 0 && isTurns(turns!);
  });
  if (good.length === 0) return undefined;
  return good.map(([key, component, turns]) => ({ key: key!, component: component!, turns: turns! }));
}

function numbers(text: string): number[] | undefined {
  const values = text.split(',').map(Number);
  return values.length <= MAX_KEYS && values.every(Number.isFinite) ? values : undefined;
}

/** One invalid value invalidates the whole list, because the other values would move to other keys. */
function allGood(values: number[] | undefined, good: (value: number) => boolean): number[] | undefined {
  return values?.every(good) ? values : undefined;
}

const isTime = (value: number): boolean => Math.abs(value) <= MAX_TIME;

function number(text: string): number | undefined {
  const value = Number(text);
  return Number.isFinite(value) ? value : undefined;
}

function numberFrom(text: string, min: number, max: number): number | undefined {
  const value = number(text);
  return value !== undefined && value >= min && value <= max ? value : undefined;
}

const time = (text: string): number | undefined => numberFrom(text, -MAX_TIME, MAX_TIME);

function oneOfNumbers(text: string, values: readonly number[]): number | undefined {
  return values.find((value) => value === number(text));
}

function index(text: string): number | undefined {
  const value = number(text);
  return value !== undefined && Number.isSafeInteger(value) && value >= 0 ? value : undefined;
}

function flag(text: string): boolean | undefined {
  return text === '1' ? true : text === '0' ? false : undefined;
}

function oneOf<T extends string>(text: string, values: readonly T[]): T | undefined {
  return values.find((value) => value === text);
}

/** The object without its undefined entries. */
function defined<T extends object>(object: T): { [K in keyof T]?: Exclude<T[K], undefined> } {
  return Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined)) as {
    [K in keyof T]?: Exclude<T[K], undefined>;
  };
}

function shortest(value: number): string {
  return String(Number(value.toPrecision(6)));
}
