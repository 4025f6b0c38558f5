/**
 * The engine of a page and the objects that its elements share: one import per list of sources and import options, one
 * shape per encoding, one motion per set of options. Unused objects are disposed of after a delay, because moving an
 * element removes and inserts it.
 */
import type { Engine, Keys, Motion, Shape } from '../engine/api/api.ts';
import { createEngine } from '../engine/browser.ts';
import { encodingOf, motionOf } from '../engine/api/options.ts';
import { ENCODING_SHARE, partOf } from '../engine/api/progress.ts';
import { SEQUENCE_DEFAULTS } from '../engine/api/types.ts';
import type { ImportOptions, SequenceOptions } from '../engine/api/types.ts';
import { readSources, keyOf } from './sources.ts';
import type { Sources } from './sources.ts';
import { Shared } from './shared.ts';
import type { Lease, Stage } from './shared.ts';

const GRACE_MS = 1000;

let engine: Engine | null = null;

/** Created for the first visible element. */
function pageEngine(): Engine {
  if (!engine) {
    engine = createEngine();
    engine.warmFiles();
  }
  return engine;
}

/** An engine whose files failed to load never works, so the next request creates a new one. */
async function withEngine<T>(work: (engine: Engine) => Promise<T>): Promise<T> {
  const used = pageEngine();
  try {
    return await work(used);
  } catch (error) {
    if ((error as { code?: unknown }).code === 'not-loaded' && engine === used && shapes.size === 0) engine = null;
    throw error;
  }
}

const imports = new Shared<Keys>((keys) => keys.dispose(), GRACE_MS);
const shapes = new Shared<Shape>((shape) => shape.dispose(), GRACE_MS);
const motions = new Shared<{ motion: Motion; shape: Lease<Shape> }>(({ motion, shape }) => {
  motion.dispose();
  shape.release();
}, GRACE_MS);

/** Numbers of live objects, for tests and for pages that monitor memory. */
export const held = (): { imports: number; shapes: number; motions: number } => ({
  imports: imports.size,
  shapes: shapes.size,
  motions: motions.size,
});

export interface KeysLease extends Lease<Keys> {
  readonly key: string;
}

/** With more numbered files than this, all become keys only if times are given. */
const MAX_OWN_KEYS = 32;

/** Up to MAX_OWN_KEYS files, key times do not affect the import, so different times share one. */
export function takeKeys(
  { list, times }: Sources,
  base: string,
  options: ImportOptions,
  onProgress?: (part: Stage) => void,
): KeysLease {
  const all: ImportOptions = times && list.length > MAX_OWN_KEYS ? { ...options, keyTimes: times } : options;
  const key = JSON.stringify([list.map((source, index) => keyOf(source, index, base)), all]);
  const lease = imports.take(
    key,
    async (making) => {
      const files = await readSources(list, base, {
        ...making,
        report: partOf(making.report, 0, 0.5),
      });
      const onProgress = partOf(making.report, 0.5, 1);
      const read = (how: ImportOptions): Promise<Keys> =>
        withEngine((one) => one.importKeyframes(files, how, { signal: making.signal, onProgress }));
      const keys = await read(all);
      // As in the app, shapes that seem to lie down are stood up, unless the page sets the axis.
      if (all.up !== undefined || !keys.info.warnings.some(({ code }) => code === 'z-up')) return keys;
      keys.dispose();
      return read({ ...all, up: 'z' });
    },
    onProgress,
  );
  return Object.assign(lease, { key });
}

/** A requested motion: keys, options and times. */
export interface Wanted {
  keys: KeysLease;
  times: number[] | null;
  options: Partial<SequenceOptions>;
}

const encodedOf = ({ keys, options }: Wanted): string =>
  `${keys.key} ${JSON.stringify(encodingOf({ ...SEQUENCE_DEFAULTS, ...options }))}`;

const keyOfMotion = (wanted: Wanted): string =>
  `${encodedOf(wanted)} ${JSON.stringify([wanted.times, motionOf({ ...SEQUENCE_DEFAULTS, ...wanted.options })])}`;

async function keysOf({ keys, times }: Wanted): Promise<Keys> {
  const held = await keys.value;
  return times ? held.arrange([...held.info.times.keys()], times) : held;
}

function takeShape(wanted: Wanted, onProgress: (part: Stage) => void): Lease<Shape> {
  return shapes.take(
    encodedOf(wanted),
    async ({ signal, report }) => {
      const encoding = encodingOf({ ...SEQUENCE_DEFAULTS, ...wanted.options });
      return pageEngine().encode(await wanted.keys.value, encoding, { signal, onProgress: report });
    },
    onProgress,
  );
}

/** An existing motion, or a new one. */
export function takeMotion(wanted: Wanted, onProgress?: (part: Stage) => void): Lease<Motion> {
  const { value, release } = motions.take(
    keyOfMotion(wanted),
    async ({ signal, report }) => {
      const shape = takeShape(wanted, partOf(report, 0, ENCODING_SHARE));
      // No element is waiting, so the encoding can stop.
      signal.addEventListener('abort', shape.release);
      try {
        const keyTimes = [...(await keysOf(wanted)).info.times];
        const options = motionOf({ ...SEQUENCE_DEFAULTS, ...wanted.options });
        const onProgress = partOf(report, ENCODING_SHARE, 1);
        return { shape, motion: await (await shape.value).motion({ ...options, keyTimes }, { signal, onProgress }) };
      } catch (error) {
        shape.release();
        throw error;
      }
    },
    onProgress,
  );
  const motion = value.then((held) => held.motion);
  motion.catch(() => undefined); // the waiting element reports the failure
  return { value: motion, release };
}

/**
 * A motion for one of its several users. A newer request replaces only requests of the same user. `onComputed` receives
 * the worker time in milliseconds of each frame computed for this user.
 */
export function userOf(motion: Motion, onComputed: (ms: number) => void): Motion {
  const evaluateAhead: Motion['evaluateAhead'] = async (t, options) => {
    const frame = await motion.evaluateAhead(t, options);
    onComputed(frame.ms);
    return frame;
  };
  const own: Partial<Motion> = {
    evaluateAhead,
    evaluate: (t) => evaluateAhead(t),
  };
  return new Proxy(motion, {
    get(target, name) {
      const value: unknown = own[name as keyof Motion] ?? Reflect.get(target, name, target);
      return typeof value === 'function' ? value.bind(target) : value;
    },
  });
}
