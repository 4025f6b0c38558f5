/** Single frames of one sequence: total time and stages. */
import type { Sequence } from '../../web/engine/api/api.ts';
import type { Frame, SequenceStats } from '../../web/engine/api/types.ts';
import type { ReadBandwidth } from './bandwidth.ts';
import type { NativeRound, RunNative } from './native-round.ts';
import { quantile, spread, type Spread } from './quantile.ts';

/** Frame steps of each kind per build. */
const FRAMES = 12;
/** Bandwidth passes before a round's frames, and again after them. */
const BANDWIDTH_PASSES = 3;

/**
 * Single frames of one build, with native solvers and the bandwidth (bytes per second) measured at the same time,
 * because the load of a shared machine changes.
 */
export interface Round {
  buildMs: number;
  firstMs: number;
  ms: number[];
  stats: SequenceStats[];
  native: NativeRound;
  bandwidth: number;
}

/** Frame times in milliseconds. */
export interface ExactFrames {
  /** Time of the first build's first frame, with cold caches. */
  firstMs: number;
  frames: Spread;
  faces: Spread;
  solve: Spread;
  place: Spread;
  normals: Spread;
  /** All stages, without the copy out of the wasm heap. */
  stages: Spread;
  frame: Spread;
  rounds: RoundMedians[];
}

/** Medians in milliseconds and bytes per second. The factorisation is that of the round's build. */
export interface RoundMedians {
  /** Time from the keys to the first frame. */
  untilFrameMs: number;
  factorMs: number;
  solveMs: number;
  frameMs: number;
  native: NativeRound;
  bandwidth: number;
}

/** Time of the last exact frame from its local frames to the drawn vertices. */
export const fromFramesMs = ({ facesMs, solveMs, positionsMs, normalsMs }: SequenceStats): number =>
  facesMs + solveMs + positionsMs + normalsMs;

/** Total time of all stages. */
export const stagesMs = (stats: SequenceStats): number => stats.localFramesMs + fromFramesMs(stats);

/** Step k of `count`, from well before the first key to well after the last. */
export const timeOf = (k: number, count: number): number => -0.2 + (1.4 * k) / count;

/** One frame whose request is never replaced. */
export async function frameOf(pending: Promise<Frame | null>): Promise<Frame> {
  const frame = await pending;
  if (!frame) throw new Error('a frame was overtaken although none else was asked for');
  return frame;
}

export async function msOf(pending: Promise<Frame | null>): Promise<number> {
  const frame = await frameOf(pending);
  frame.release();
  return frame.ms;
}

/** Native solvers run after the build, which ends with the factorisation, and before the frames, which solve. */
export async function roundOf(
  sequence: Sequence,
  buildMs: number,
  readBandwidth: ReadBandwidth,
  runNative: RunNative,
): Promise<Round> {
  const firstMs = await msOf(sequence.evaluate(0));
  const native = await runNative();
  const ms: number[] = [],
    stats: SequenceStats[] = [],
    bandwidths: number[] = [];
  const read = (): void => {
    for (let pass = 0; pass < BANDWIDTH_PASSES; ++pass) bandwidths.push(readBandwidth());
  };
  read();
  for (let k = 0; k <= FRAMES; ++k) {
    ms.push(await msOf(sequence.evaluate(timeOf(k, FRAMES))));
    stats.push(await sequence.stats());
  }
  read();
  return { buildMs, firstMs, ms, stats, native, bandwidth: quantile(bandwidths) };
}

export function exactFrames(rounds: readonly Round[]): ExactFrames {
  const stats = rounds.flatMap((round) => round.stats);
  const part = (of: 'localFramesMs' | 'facesMs' | 'solveMs' | 'positionsMs' | 'normalsMs'): Spread =>
    spread(stats.map((one) => one[of]));
  return {
    firstMs: rounds[0]!.firstMs,
    frames: part('localFramesMs'),
    faces: part('facesMs'),
    solve: part('solveMs'),
    place: part('positionsMs'),
    normals: part('normalsMs'),
    stages: spread(stats.map(stagesMs)),
    frame: spread(rounds.flatMap(({ ms }) => ms)),
    rounds: rounds.map((round) => ({
      untilFrameMs: round.buildMs + round.firstMs,
      factorMs: round.stats[0]!.factorMs,
      solveMs: quantile(round.stats.map(({ solveMs }) => solveMs)),
      frameMs: quantile(round.ms),
      native: round.native,
      bandwidth: round.bandwidth,
    })),
  };
}
