/**
 * The state of a built-in sample as a link's fragment, and back. Only what differs from the defaults is written. A link
 * comes from anywhere: whatever it holds that does not fit is left out.
 */
import { ENCODING, MOTION, PER_KEY } from '../../engine/api/option-table.ts';
import type { Option } from '../../engine/api/option-table.ts';
import { wrongWith } from '../../engine/api/options.ts';
import type { AddedTurns } from '../../engine/api/types.ts';
import { setShaping, setTurns } from '../../model/edits.ts';
import { MAX_FPS } from '../../model/frames.ts';
import { forPage, isPose, pageOptions } from '../../model/page-options.ts';
import type { ShapingNumber } from '../../model/shaping.ts';
import { SHAPING_NUMBERS, turnsOf } from '../../model/shaping.ts';
import type { CameraPose } from '../../model/camera.ts';
import type { AppState, Colouring, Doc, Encoding, LoopMode, Motion, View } from '../../model/state.ts';
import { DEFAULT_VIEW, MAX_TURNS, METHODS } from '../../model/state.ts';

export interface Permalink {
  sample: string;
  /** [pose, time] of each key; null = the sample's own. */
  keys: [number, number][] | null;
  /** One value per key. */
  shaping: Record<ShapingNumber, number[]>;
  /** Of the whole shape, one value per key. */
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
}

const FLAGS = ['wireframe', 'floor', 'onion', 'film', 'ghostWire', 'ghostBeside', 'ghostDifference'] as const;
const MAX_KEYS = 256;
const MAX_PART_TURNS = 1024;

/** The fragment without its '#', or null where the user's own files are open: they stay on this machine. */
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
  putOptions(doc.motion, initial.motion);
  putOptions(doc.encoding, initial.encoding);
  put('colour', view.colouring, DEFAULT_VIEW.colouring);
  put('shading', view.shading, DEFAULT_VIEW.shading);
  for (const name of FLAGS) put(name, view[name], DEFAULT_VIEW[name]);
  put('compare', view.compare.join(','), '');
  if (view.camera)
    params.set('camera', [...view.camera.position, ...view.camera.target].map((x) => x.toPrecision(5)).join(','));
  params.set('t', shortest(state.time));
  put('speed', state.play.speed, null);
  put('loop', state.play.loop, 'bounce');
  put('between', state.play.between?.map(shortest).join(',') ?? null, null);
  put('fps', state.play.fps, null);
  put('window', view.window?.map(shortest).join(',') ?? null, null);
  return params.toString();
}

export function readPermalink(fragment: string): Permalink | null {
  const params = new URLSearchParams(fragment.replace(/^#/, ''));
  const sample = params.get('sample');
  if (!sample) return null;
  return {
    sample,
    keys: readKeys(params.get('keys')),
    shaping: readShaping(params),
    turns:
      numbers(params.get('turns'))?.filter((value) => Number.isInteger(value) && Math.abs(value) <= MAX_TURNS) ?? [],
    partTurns: readPartTurns(params.get('partTurns')),
    motion: defined(forPage(MOTION, ({ page, option }) => optionValue(option, params.get(page)))),
    encoding: defined(forPage(ENCODING, ({ page, option }) => optionValue(option, params.get(page)))),
    view: readView(params),
    time: number(params.get('t')) ?? null,
    speed: positive(params.get('speed')) ?? null,
    loop: oneOf(params.get('loop'), ['once', 'loop', 'bounce'] as const) ?? null,
    between: stretch(params.get('between')) ?? null,
    fps: fpsOf(params.get('fps')),
    playing: params.get('play') === '1',
  };
}

/**
 * Applies a link to the document that its sample starts with; poses and components that the sample has not are left
 * out.
 */
export function applyPermalink(doc: Doc, link: Permalink, components = Infinity): Doc {
  const poses = doc.keys.length;
  const known = (pose: number | null | undefined): boolean => pose === null || pose === undefined || pose < poses;
  const usable = link.keys !== null && link.keys.length >= 2 && link.keys.every(([pose]) => known(pose));
  const keys = usable ? link.keys!.map(([pose, time]) => ({ ...doc.keys[pose]!, time })) : doc.keys;
  const encoding = { ...doc.encoding, ...link.encoding };
  for (const name of POSES) if (!known(encoding[name])) encoding[name] = null;
  let next: Doc = { keys, encoding, motion: { ...doc.motion, ...link.motion } };
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

/** The value of an option, where it is one that the option can have. */
function optionValue(option: Option, text: string | null): unknown {
  if (isPose(option)) return index(text);
  const value = option.kind === 'choice' ? text : option.kind === 'flag' ? flag(text) : number(text);
  return value !== undefined && value !== null && wrongWith(option, value) === null ? value : undefined;
}

function readShaping(params: URLSearchParams): Permalink['shaping'] {
  const good = (name: ShapingNumber): number[] =>
    numbers(params.get(name))?.filter((value) => wrongWith(PER_KEY[name], value) === null) ?? [];
  return Object.fromEntries(SHAPING_NUMBERS.map((name) => [name, good(name)])) as Permalink['shaping'];
}

function readView(params: URLSearchParams): Partial<View> {
  const compare = params
    .get('compare')
    ?.split(',')
    .flatMap((name) => oneOf(name, METHODS) ?? []);
  return defined({
    colouring: oneOf(params.get('colour'), ['phase', 'texture', 'patches'] as const satisfies readonly Colouring[]),
    shading: oneOf(params.get('shading'), ['smooth', 'flat'] as const),
    ...(Object.fromEntries(FLAGS.map((name) => [name, flag(params.get(name))])) as Record<
      (typeof FLAGS)[number],
      boolean | undefined
    >),
    compare: compare && [...new Set(compare)],
    camera: readCamera(params.get('camera')),
    window: stretch(params.get('window')),
  });
}

function readCamera(text: string | null): CameraPose | undefined {
  const values = numbers(text);
  if (values?.length !== 6) return undefined;
  const [px, py, pz, tx, ty, tz] = values as [number, number, number, number, number, number];
  return { position: [px, py, pz], target: [tx, ty, tz] };
}

function stretch(text: string | null): [number, number] | undefined {
  const values = numbers(text);
  return values?.length === 2 && values[0]! < values[1]! ? [values[0]!, values[1]!] : undefined;
}

function fpsOf(text: string | null): number | null {
  const value = positive(text);
  return value !== undefined && value <= MAX_FPS ? value : null;
}

/** Strictly increasing times, or the whole list is left out. */
function readKeys(text: string | null): [number, number][] | null {
  if (!text) return null;
  const keys = text.split(',').map((entry) => entry.split('@').map(Number) as [number, number]);
  const good =
    keys.length <= MAX_KEYS &&
    keys.every(
      ([pose, time], i) =>
        Number.isInteger(pose) && pose >= 0 && Number.isFinite(time) && (i === 0 || time > keys[i - 1]![1]),
    );
  return good ? keys : null;
}

/** Those of the entries that can be meant. */
function readPartTurns(text: string | null): Required<AddedTurns>[] {
  const entries = (text ?? '')
    .split(',')
    .slice(0, MAX_PART_TURNS)
    .map((entry) => entry.split(':').map(Number));
  return entries
    .filter((entry) => {
      const [key, component, turns] = entry;
      const whole = entry.length === 3 && entry.every(Number.isInteger);
      return whole && key! >= 0 && component! >= 0 && Math.abs(turns!) <= MAX_TURNS;
    })
    .map(([key, component, turns]) => ({ key: key!, component: component!, turns: turns! }));
}

function numbers(text: string | null): number[] | undefined {
  if (!text) return undefined;
  const values = text.split(',').map(Number);
  return values.length <= MAX_KEYS && values.every(Number.isFinite) ? values : undefined;
}

function number(text: string | null): number | undefined {
  if (text === null || text === '') return undefined;
  const value = Number(text);
  return Number.isFinite(value) ? value : undefined;
}

function positive(text: string | null): number | undefined {
  const value = number(text);
  return value !== undefined && value > 0 ? value : undefined;
}

function index(text: string | null): number | undefined {
  const value = number(text);
  return value !== undefined && Number.isInteger(value) && value >= 0 ? value : undefined;
}

function flag(text: string | null): boolean | undefined {
  return text === '1' ? true : text === '0' ? false : undefined;
}

function oneOf<T extends string>(text: string | null, values: readonly T[]): T | undefined {
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
