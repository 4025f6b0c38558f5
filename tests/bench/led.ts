/** A sequence led by a ghost mesh, in the paper's two parts: the ghost's own shapes, and what carries them over to the mesh. */
import type { Engine, Keys, Sequence } from '../../web/engine/api.ts';
import { frameOf } from './frames.ts';
import { quantile } from './quantile.ts';

const REPEATS = 5;

/** Milliseconds for all shapes, medians of five. */
export interface LedRun {
  ghostFaces: number;
  buildMs: number;
  /** Interpolation and reconstruction on the ghost alone: the answer to the caller, less what a question takes that needs no work. */
  ghostMs: number;
  /** Whole frames, from the spline to the mesh. */
  wholeMs: number;
}

/** Evenly over the range. */
export function evenTimes([first, last]: readonly [number, number], count: number): number[] {
  return Array.from({ length: count }, (_, k) => first + (k / Math.max(count - 1, 1)) * (last - first));
}

/** Milliseconds for all times: the median of five passes. */
export async function passes(times: readonly number[], ask: (t: number) => Promise<number>): Promise<number> {
  const totals: number[] = [];
  for (let pass = 0; pass < REPEATS; ++pass) {
    let total = 0;
    for (const t of times) total += await ask(t);
    totals.push(total);
  }
  return quantile(totals);
}

export async function frameMs(sequence: Sequence, t: number): Promise<number> {
  const frame = await frameOf(sequence.evaluate(t));
  frame.release();
  return frame.ms;
}

async function waited(question: () => Promise<unknown>): Promise<number> {
  const asked = performance.now();
  await question();
  return performance.now() - asked;
}

export async function ledRun(engine: Engine, keys: Keys, ghostFaces: number, shapes: number): Promise<LedRun> {
  const start = performance.now();
  const sequence = await engine.createSequence(keys, { ghostFaces });
  const buildMs = performance.now() - start;
  try {
    const times = evenTimes(sequence.range, shapes);
    const wholeMs = await passes(times, (t) => frameMs(sequence, t));
    const answerMs = await passes(times, (t) => waited(() => sequence.ghostPositions(t)));
    const messagesMs = await passes(times, () => waited(() => sequence.stats()));
    return { ghostFaces: (await sequence.stats()).ghostFaces, buildMs, ghostMs: Math.max(answerMs - messagesMs, 0), wholeMs };
  } finally {
    sequence.dispose();
  }
}
