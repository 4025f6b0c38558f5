/** A sequence with a ghost mesh: times of the paper's two stages, measured by the core. */
import type { Engine, Keys, Sequence } from '../../web/engine/api/api.ts';
import type { Frame, SequenceStats } from '../../web/engine/api/types.ts';
import { fromFramesMs, msOf, stagesMs } from './frames.ts';
import { quantile } from './quantile.ts';

const REPEATS = 5;

export interface WithGhost {
  sequence: Sequence;
  buildMs: number;
}

/** Milliseconds for all shapes, medians of five passes. */
export interface GhostFrames {
  ghostFaces: number;
  buildMs: number;
  /**
   * t_ir: interpolation and reconstruction of the ghost's own shape with its vertices, as in the paper. A frame needs
   * only the rotations of its faces.
   */
  irMs: number;
  /** t_ts: the stages of a frame after those rotations, until the shape. */
  tsMs: number;
}

/** Evenly spaced times over the range. */
export function evenTimes([first, last]: readonly [number, number], count: number): number[] {
  return Array.from({ length: count }, (_, k) => first + (k / Math.max(count - 1, 1)) * (last - first));
}

/** The median time of five passes over all times, in milliseconds. */
async function passes(times: readonly number[], ask: (t: number) => Promise<number>): Promise<number> {
  const totals: number[] = [];
  for (let pass = 0; pass < REPEATS; ++pass) {
    let total = 0;
    for (const t of times) total += await ask(t);
    totals.push(total);
  }
  return quantile(totals);
}

/** All stages of this many exact frames, in milliseconds: t_o without a ghost. */
export function stagesOf(sequence: Sequence, shapes: number): Promise<number> {
  return passes(evenTimes(sequence.range, shapes), async (t) =>
    stagesMs(await statsOf(sequence, sequence.evaluate(t))),
  );
}

/** The stages are known once a frame is ready. */
async function statsOf(sequence: Sequence, pending: Promise<Frame | null>): Promise<SequenceStats> {
  await msOf(pending);
  return sequence.stats();
}

/** The caller disposes of the result. */
export async function createWithGhost(engine: Engine, keys: Keys, ghostFaces: number): Promise<WithGhost> {
  const start = performance.now();
  const sequence = await engine.createSequence(keys, { ghostFaces });
  return { sequence, buildMs: performance.now() - start };
}

export async function ghostFrames({ sequence, buildMs }: WithGhost, shapes: number): Promise<GhostFrames> {
  const times = evenTimes(sequence.range, shapes);
  const tsMs = await passes(times, async (t) => fromFramesMs(await statsOf(sequence, sequence.evaluate(t))));
  const irMs = await passes(times, async (t) => {
    await sequence.ghostPositions(t);
    return (await sequence.stats()).ghostMs;
  });
  return { ghostFaces: (await sequence.stats()).ghostFaces, buildMs, irMs, tsMs };
}
