/** Frame cost with few and with many keys of the same mesh, measured alternately under the same load. */
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import type { SequenceStats } from '../../web/engine/api/types.ts';
import { msOf, timeOf } from './frames.ts';
import { quantile, spread, type Spread } from './quantile.ts';

/** The reference number of keys, and the compared ones. */
export const FEW_KEYS = 3;
export const MANY_KEYS = [8, 25, 100] as const;

const ROUNDS = 5;
/** Frame steps per round. */
const FRAMES = 12;

/** Costs in milliseconds and bytes. */
export interface KeysCost {
  keys: number;
  buildMs: number;
  frame: Spread;
  /** The stages that depend on keys: patch rotations; splined faces and their right-hand side. */
  frames: Spread;
  faces: Spread;
  heapBytes: number;
}

export interface KeysRun {
  faces: number;
  few: KeysCost;
  many: KeysCost;
  /** Ratio of a frame with many keys to one with few: the median over the rounds. */
  ratio: number;
}

interface Measured {
  dispose(): void;
  sequence: Sequence;
  keys: number;
  faces: number;
  buildMs: number;
  /** Frame times by round, in milliseconds. */
  ms: number[][];
  stats: SequenceStats[];
}

/** A mesh with this many keys; by default an import samples fewer. */
async function build(engine: Engine, mesh: Uint8Array, wanted: number): Promise<Measured> {
  const keys = await engine.importKeyframes([{ name: 'bench.glb', bytes: mesh }], { sample: wanted });
  const count = keys.info.times.length;
  if (count !== wanted) throw new Error(`${wanted} keys were written, but ${count} read`);
  const start = performance.now();
  const sequence = await engine.createSequence(keys);
  const buildMs = performance.now() - start;
  const dispose = (): void => {
    sequence.dispose();
    keys.dispose();
  };
  return { dispose, sequence, keys: count, faces: keys.info.report.faces, buildMs, ms: [], stats: [] };
}

/** Evaluates one uncounted frame first, because the other sequence has just run. */
async function round({ sequence, ms, stats }: Measured): Promise<void> {
  await msOf(sequence.evaluate(0.5));
  const own: number[] = [];
  for (let k = 0; k <= FRAMES; ++k) {
    own.push(await msOf(sequence.evaluate(timeOf(k, FRAMES))));
    stats.push(await sequence.stats());
  }
  ms.push(own);
}

function costOf({ keys, buildMs, ms, stats }: Measured): KeysCost {
  const part = (of: 'localFramesMs' | 'facesMs'): Spread => spread(stats.map((one) => one[of]));
  return {
    keys,
    buildMs,
    frame: spread(ms.flat()),
    frames: part('localFramesMs'),
    faces: part('facesMs'),
    heapBytes: stats.at(-1)!.heapBytes,
  };
}

/** Median over the rounds of the ratio of frame times; every round has both. */
export function ratioOf(few: readonly number[][], many: readonly number[][]): number {
  return quantile(few.map((ms, k) => quantile(many[k]!) / quantile(ms)));
}

/** Meshes with FEW_KEYS and with `count` keys. */
export async function compareKeys(
  engine: Engine,
  fewKeys: Uint8Array,
  manyKeys: Uint8Array,
  count: number,
): Promise<KeysRun> {
  const few = await build(engine, fewKeys, FEW_KEYS),
    many = await build(engine, manyKeys, count);
  for (let k = 0; k < ROUNDS; ++k) {
    await round(few);
    await round(many);
  }
  for (const { dispose } of [few, many]) dispose();
  return { faces: few.faces, few: costOf(few), many: costOf(many), ratio: ratioOf(few.ms, many.ms) };
}
