/** Builds the same sequence repeatedly: its stages, silences, and memory growth. */
import type { Engine, Keys, Sequence } from '../../web/engine/api/api.ts';
import type { Progress, SequenceStats } from '../../web/engine/api/types.ts';
import { quantile } from './quantile.ts';

const BUILDS = 5;
const REFITS = 10;
const STAGES = ['weldMs', 'joinMs', 'encodeMs', 'orderMs', 'factorMs', 'arrangeMs', 'finishMs'] as const;

/** The longest time without a progress report, and the stage reported next. */
export interface Silence {
  ms: number;
  stage: string;
}

/** Milliseconds: medians of five builds, also for the longest silence. */
export interface Builds {
  weldMs: number;
  joinMs: number;
  encodeMs: number;
  orderMs: number;
  factorMs: number;
  arrangeMs: number;
  finishMs: number;
  /** Time outside the stages: checking, the motion, messages between threads. */
  restMs: number;
  buildMs: number;
  silence: Silence;
  /** Bytes of the largest wasm heap after a build. */
  heapBytes: number;
  /** The second build's peak heap, without files, over the heap in use at its end. */
  peakOverKept: number;
  /**
   * The heap after the last build over that after the second, because the first build's worker had also read the file.
   */
  heapGrowth: number;
  /** Growth of the whole process from the second build to the last; NaN if unknown. */
  processGrowth: number;
}

/** Records the progress of one call. */
export class Listener {
  silence: Silence = { ms: 0, stage: '' };
  private last = performance.now();

  readonly onProgress = ({ stage, fraction }: Progress): void => this.hear(`${stage} ${fraction.toFixed(2)}`);

  hear(stage: string): void {
    const now = performance.now();
    if (now - this.last > this.silence.ms) this.silence = { ms: now - this.last, stage };
    this.last = now;
  }
}

interface Built {
  stats: SequenceStats;
  buildMs: number;
  silence: Silence;
  processBytes: number;
}

async function build(
  engine: Engine,
  keys: Keys,
  processBytes: () => number,
): Promise<{ sequence: Sequence; built: Built }> {
  const start = performance.now();
  const listener = new Listener();
  const sequence = await engine.createSequence(keys, {}, { onProgress: listener.onProgress });
  listener.hear('end');
  const buildMs = performance.now() - start;
  return {
    sequence,
    built: { stats: await sequence.stats(), buildMs, silence: listener.silence, processBytes: processBytes() },
  };
}

/** Calls `use` with each build. Returns the last one, still alive. */
export async function buildRepeatedly(
  engine: Engine,
  keys: Keys,
  processBytes: () => number,
  use: (sequence: Sequence, buildMs: number) => Promise<void>,
): Promise<{ sequence: Sequence; builds: Builds }> {
  let { sequence, built } = await build(engine, keys, processBytes);
  const all = [built];
  await use(sequence, built.buildMs);
  while (all.length < BUILDS) {
    sequence.dispose();
    ({ sequence, built } = await build(engine, keys, processBytes));
    all.push(built);
    await use(sequence, built.buildMs);
  }
  const stage = (of: (typeof STAGES)[number]): number => quantile(all.map(({ stats }) => stats[of]));
  const heaps = all.map(({ stats }) => stats.heapBytes);
  const silences = all.map(({ silence }) => silence).sort((a, b) => a.ms - b.ms);
  return {
    sequence,
    builds: {
      weldMs: stage('weldMs'),
      joinMs: stage('joinMs'),
      encodeMs: stage('encodeMs'),
      orderMs: stage('orderMs'),
      factorMs: stage('factorMs'),
      arrangeMs: stage('arrangeMs'),
      finishMs: stage('finishMs'),
      restMs: quantile(all.map(({ stats, buildMs }) => buildMs - STAGES.reduce((sum, of) => sum + stats[of], 0))),
      buildMs: quantile(all.map(({ buildMs }) => buildMs)),
      silence: silences[Math.floor(BUILDS / 2)]!,
      heapBytes: Math.max(...heaps),
      peakOverKept: all[1]!.stats.heapBytes / all[1]!.stats.usedBytes,
      heapGrowth: heaps.at(-1)! / heaps[1]!,
      processGrowth: built.processBytes - all[1]!.processBytes,
    },
  };
}

/** Heap after many refits, each with a frame, over the heap after the first refit. */
export async function refitGrowth(sequence: Sequence): Promise<number> {
  let first = 0;
  for (let k = 0; k <= REFITS; ++k) {
    await sequence.update({ boundary: k % 2 === 0 ? 'hermite' : 'natural' });
    (await sequence.evaluate(0.1 + 0.07 * k))?.release();
    if (k === 0) first = (await sequence.stats()).heapBytes;
  }
  return (await sequence.stats()).heapBytes / first;
}
