/**
 * The engine of a page and what its elements share: an import for the same sources, a sequence for the same motion.
 * What nobody holds any more is disposed of after a moment, because moving an element takes it away and back.
 */
import type { Engine, Keys, Sequence } from '../engine/api/api.ts';
import { createEngine } from '../engine/browser.ts';
import { encodingOf, motionOf } from '../engine/api/options.ts';
import { SEQUENCE_DEFAULTS } from '../engine/api/types.ts';
import type { ImportOptions, SequenceOptions } from '../engine/api/types.ts';
import { readSources, keyOf } from './sources.ts';
import type { Sources } from './sources.ts';
import { Shared } from './shared.ts';
import type { Lease, Stage } from './shared.ts';

const GRACE_MS = 1000;

let engine: Engine | null = null;

/** Starts with the first element that is seen. */
function pageEngine(): Engine {
  engine ??= createEngine();
  return engine;
}

/** An engine whose files did not load never works: the next one who asks gets another. */
async function withEngine<T>(work: (engine: Engine) => Promise<T>): Promise<T> {
  const used = pageEngine();
  try {
    return await work(used);
  } catch (error) {
    if ((error as { code?: unknown }).code === 'not-loaded' && engine === used && sequences.size === 0) engine = null;
    throw error;
  }
}

const imports = new Shared<Keys>((keys) => keys.dispose(), GRACE_MS);
const sequences = new Shared<Sequence>((sequence) => sequence.dispose(), GRACE_MS);

/** For tests and for pages that look after their memory: how many imports and sequences there are. */
export const held = (): { imports: number; sequences: number } => ({
  imports: imports.size,
  sequences: sequences.size,
});

export interface KeysLease extends Lease<Keys> {
  readonly key: string;
}

/** So many numbered files are all keys only where their times are given. */
const MOST_OWN_KEYS = 32;

/** When the keys are is no matter of the files, so that those of other times are the same import. */
export function takeKeys(
  { list, times }: Sources,
  base: string,
  options: ImportOptions,
  onProgress?: (part: Stage) => void,
): KeysLease {
  const all: ImportOptions = times && list.length > MOST_OWN_KEYS ? { ...options, keyTimes: times } : options;
  const key = JSON.stringify([list.map((source, index) => keyOf(source, index, base)), all]);
  const lease = imports.take(
    key,
    async (making) => {
      const files = await readSources(list, base, {
        ...making,
        report: ({ stage, fraction }) => making.report({ stage, fraction: fraction / 2 }),
      });
      const onProgress = ({ stage, fraction }: Stage): void => making.report({ stage, fraction: (1 + fraction) / 2 });
      return withEngine((one) => one.importKeyframes(files, all, { signal: making.signal, onProgress }));
    },
    onProgress,
  );
  return Object.assign(lease, { key });
}

export interface MotionLease extends Lease<Sequence> {
  /** Of its keys, and of what is encoded of them: motions of the same differ by what can be refitted. */
  readonly keys: string;
  readonly encoded: string;
}

/** A motion through keys, at these times or their own. */
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

const asMotion = (lease: Lease<Sequence>, wanted: Wanted): MotionLease =>
  Object.assign(lease, { keys: wanted.keys.key, encoded: encodedOf(wanted) });

/** Those of them that need refitting alone to become what is wanted. */
export function refittable(motions: readonly MotionLease[], wanted: Wanted): MotionLease[] {
  return motions.filter(({ encoded }) => encoded === encodedOf(wanted));
}

/**
 * One motion for each of the wanted: one that is there, one of `own` refitted that no other user stays with, or a new
 * one. `own` must be made already.
 */
export function takeMotions(
  wanted: readonly Wanted[],
  own: readonly MotionLease[],
  onProgress?: (part: Stage) => void,
): MotionLease[] {
  const there = wanted.map((one) => (sequences.has(keyOfMotion(one)) ? create(one, onProgress) : null));
  return wanted.map((one, i) => there[i] ?? refit(one, own) ?? create(one, onProgress));
}

function refit(wanted: Wanted, own: readonly MotionLease[]): MotionLease | null {
  const lease = sequences.change(refittable(own, wanted), keyOfMotion(wanted), async (sequence) => {
    const keyTimes = [...(await keysOf(wanted)).info.times];
    await sequence.update({ ...motionOf({ ...SEQUENCE_DEFAULTS, ...wanted.options }), keyTimes });
  });
  return lease && asMotion(lease, wanted);
}

function create(wanted: Wanted, onProgress?: (part: Stage) => void): MotionLease {
  const lease = sequences.take(
    keyOfMotion(wanted),
    async ({ signal, report }) => {
      return pageEngine().createSequence(await keysOf(wanted), wanted.options, { signal, onProgress: report });
    },
    onProgress,
  );
  return asMotion(lease, wanted);
}

/**
 * One of several users of a sequence. Its requests are not overtaken by those of the others: each asks for one moment
 * at a time. `onComputed` hears of every frame that was made for it.
 */
export function userOf(sequence: Sequence, onComputed: (ms: number) => void): Sequence {
  const evaluateAhead: Sequence['evaluateAhead'] = async (t, options) => {
    const frame = await sequence.evaluateAhead(t, options);
    onComputed(frame.ms);
    return frame;
  };
  const own: Partial<Sequence> = {
    evaluateAhead,
    evaluate: (t) => evaluateAhead(t),
  };
  return new Proxy(sequence, {
    get(target, name) {
      const value: unknown = own[name as keyof Sequence] ?? Reflect.get(target, name, target);
      return typeof value === 'function' ? value.bind(target) : value;
    },
  });
}
