/**
 * The state of a built-in sample as a link's fragment, and back. Only what differs from the defaults is written. A link
 * comes from anywhere: whatever it holds that does not fit is left out.
 */
import type { AppState, CameraPose, Colouring, Doc, Encoding, LoopMode, Motion, Shaping, View } from '../../model/state.ts';
import { partTurnsOf, setPartTurns } from '../../model/edits.ts';
import { MAX_FPS } from '../../model/frames.ts';
import { BOUNDARIES, DEFAULT_ENCODING, DEFAULT_MOTION, DEFAULT_VIEW, MAX_TURNS, SHAPINGS, METHODS } from '../../model/state.ts';

export interface Permalink {
  sample: string;
  /** [pose, time] of each key; null = the sample's own. */
  keys: [number, number][] | null;
  tension: number[];
  bias: number[];
  turns: number[];
  /** [key, component, turns] each. */
  partTurns: [number, number, number][];
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
    if (value !== fallback && value !== null) params.set(name, typeof value === 'number' ? shortest(value) : String(value));
  };
  const keys = doc.keys.map((key) => `${key.pose}@${shortest(key.time)}`).join(',');
  put('keys', keys, initial.keys.map((key) => `${key.pose}@${shortest(key.time)}`).join(','));
  for (const name of SHAPINGS) if (doc[name].some((value) => value !== 0)) params.set(name, doc[name].map(shortest).join(','));
  const partTurns = partTurnsOf(doc).flatMap((list, key) => list.map(({ component, turns }) => `${key}:${component}:${turns}`));
  put('partTurns', partTurns.join(','), '');
  for (const name of Object.keys(DEFAULT_MOTION) as (keyof Motion)[]) put(name, doc.motion[name], initial.motion[name]);
  for (const name of Object.keys(DEFAULT_ENCODING) as (keyof Encoding)[]) put(name, doc.encoding[name], initial.encoding[name]);
  put('colour', view.colouring, DEFAULT_VIEW.colouring);
  put('shading', view.shading, DEFAULT_VIEW.shading);
  for (const name of FLAGS) put(name, Number(view[name]), Number(DEFAULT_VIEW[name]));
  put('compare', view.compare.join(','), '');
  if (view.camera) params.set('camera', [...view.camera.position, ...view.camera.target].map((x) => x.toPrecision(5)).join(','));
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
    tension: numbers(params.get('tension')) ?? [],
    bias: numbers(params.get('bias'))?.filter((value) => Math.abs(value) <= 1) ?? [],
    turns: numbers(params.get('turns'))?.filter((value) => Number.isInteger(value) && Math.abs(value) <= MAX_TURNS) ?? [],
    partTurns: readPartTurns(params.get('partTurns')),
    motion: defined({
      method: oneOf(params.get('method'), METHODS),
      boundary: oneOf(params.get('boundary'), BOUNDARIES),
      startSpeed: number(params.get('startSpeed')),
      endSpeed: number(params.get('endSpeed')),
      period: positive(params.get('period')),
    }),
    encoding: defined({
      stretch: oneOf(params.get('stretch'), ['linear', 'log'] as const),
      ghostFaces: ghostFaces(params.get('ghostFaces')),
      transfer: oneOf(params.get('transfer'), ['exact', 'paper'] as const),
      placement: oneOf(params.get('placement'), ['vertices', 'optimal'] as const),
      patches: index(params.get('patches')),
      referencePose: index(params.get('referencePose')),
      startTangentPose: index(params.get('startTangentPose')),
      endTangentPose: index(params.get('endTangentPose')),
    }),
    view: readView(params),
    time: number(params.get('t')) ?? null,
    speed: positive(params.get('speed')) ?? null,
    loop: oneOf(params.get('loop'), ['once', 'loop', 'bounce'] as const) ?? null,
    between: stretch(params.get('between')) ?? null,
    fps: fpsOf(params.get('fps')),
    playing: params.get('play') === '1',
  };
}

/** Applies a link to the document that its sample starts with; poses and components that the sample has not are left out. */
export function applyPermalink(doc: Doc, link: Permalink, components = Infinity): Doc {
  const poses = doc.keys.length;
  const known = (pose: number | null | undefined): boolean => pose === null || pose === undefined || pose < poses;
  const names = doc.keys.map((key) => key.name);
  const usable = link.keys !== null && link.keys.length >= 2 && link.keys.every(([pose]) => known(pose));
  const keys = usable ? link.keys!.map(([pose, time]) => ({ pose, time, name: names[pose]! })) : doc.keys;
  const encoding = { ...doc.encoding, ...link.encoding };
  for (const name of ['referencePose', 'startTangentPose', 'endTangentPose'] as const) if (!known(encoding[name])) encoding[name] = null;
  const shaping = (name: Shaping): number[] => (link[name].length === keys.length ? link[name] : doc[name]);
  const start: Doc = {
    keys, tension: shaping('tension'), bias: shaping('bias'), turns: shaping('turns'), partTurns: doc.partTurns, encoding,
    motion: { ...doc.motion, ...link.motion },
  };
  return link.partTurns.filter(([key, component]) => key < keys.length && component < components)
    .reduce((next, [key, component, turns]) => setPartTurns(next, key, component, turns), start);
}

function readView(params: URLSearchParams): Partial<View> {
  const compare = params.get('compare')?.split(',').flatMap((name) => oneOf(name, METHODS) ?? []);
  return defined({
    colouring: oneOf(params.get('colour'), ['phase', 'texture', 'patches'] as const satisfies readonly Colouring[]),
    shading: oneOf(params.get('shading'), ['smooth', 'flat'] as const),
    ...Object.fromEntries(FLAGS.map((name) => [name, flag(params.get(name))])) as Record<(typeof FLAGS)[number], boolean | undefined>,
    compare: compare && [...new Set(compare)],
    camera: readCamera(params.get('camera')),
    window: stretch(params.get('window')),
  });
}

function readCamera(text: string | null): CameraPose | undefined {
  const values = numbers(text);
  if (!values || values.length !== 6) return undefined;
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
  const good = keys.length <= MAX_KEYS && keys.every(([pose, time], i) =>
    Number.isInteger(pose) && pose >= 0 && Number.isFinite(time) && (i === 0 || time > keys[i - 1]![1]));
  return good ? keys : null;
}

/** Those of the entries that can be meant. */
function readPartTurns(text: string | null): [number, number, number][] {
  const entries = (text ?? '').split(',').slice(0, MAX_PART_TURNS).map((entry) => entry.split(':').map(Number));
  return entries.filter((entry): entry is [number, number, number] => {
    const [key, component, turns] = entry;
    return entry.length === 3 && entry.every(Number.isInteger) && key! >= 0 && component! >= 0 && Math.abs(turns!) <= MAX_TURNS;
  });
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

/** 0 = off, else at least a tetrahedron. */
function ghostFaces(text: string | null): number | undefined {
  const value = index(text);
  return value === 0 || (value !== undefined && value >= 4) ? value : undefined;
}

function flag(text: string | null): boolean | undefined {
  return text === '1' ? true : text === '0' ? false : undefined;
}

function oneOf<T extends string>(text: string | null, values: readonly T[]): T | undefined {
  return values.find((value) => value === text);
}

/** The object without its undefined entries. */
function defined<T extends object>(object: T): { [K in keyof T]?: Exclude<T[K], undefined> } {
  return Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined)) as { [K in keyof T]?: Exclude<T[K], undefined> };
}

function shortest(value: number): string {
  return String(Number(value.toPrecision(6)));
}
