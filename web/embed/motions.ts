/**
 * The engine of a page and what its elements share: an import for the same sources, a sequence for the same motion.
 * What nobody holds any more is disposed of after a moment, because moving an element takes it away and back.
 */
import type { Engine, Keys, Sequence } from '../engine/api/api.ts';
import { createEngine } from '../engine/browser.ts';
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

export function takeKeys(
  { list, times }: Sources,
  base: string,
  options: ImportOptions,
  onProgress?: (part: Stage) => void,
): KeysLease {
  const all: ImportOptions = times && !options.keyTimes ? { ...options, keyTimes: times } : options;
  const key = JSON.stringify([list.map((source) => keyOf(source, base)), all]);
  const lease = imports.take(
    key,
    async (making) => {
      const files = await readSources(list, base, {
        ...making,
        report: ({ stage, fraction }) => making.report({ stage, fraction: fraction / 2 }),
      });
      return pageEngine().importKeyframes(files, all, {
        signal: making.signal,
        onProgress: ({ stage, fraction }) => making.report({ stage, fraction: (1 + fraction) / 2 }),
      });
    },
    onProgress,
  );
  return Object.assign(lease, { key });
}

export type MotionLease = Lease<Sequence>;

export const motionKey = (keys: KeysLease, options: Partial<SequenceOptions>): string =>
  `${keys.key} ${JSON.stringify(options)}`;

export function takeMotion(
  keys: KeysLease,
  options: Partial<SequenceOptions>,
  onProgress?: (part: Stage) => void,
): MotionLease {
  return sequences.take(
    motionKey(keys, options),
    async ({ signal, report }) =>
      pageEngine().createSequence(await keys.value, options, { signal, onProgress: report }),
    onProgress,
  );
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
    preview: (t) => evaluateAhead(t, { preview: true }),
  };
  return new Proxy(sequence, {
    get(target, name) {
      const value: unknown = own[name as keyof Sequence] ?? Reflect.get(target, name, target);
      return typeof value === 'function' ? value.bind(target) : value;
    },
  });
}
