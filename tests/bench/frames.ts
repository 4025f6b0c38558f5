/** Single frames of one sequence: exact ones with their stages, the cheap ones for while a slider moves, and how well they agree. */
import type { Sequence } from '../../web/engine/api.ts';
import type { Frame, SequenceStats } from '../../web/engine/types.ts';
import type { ReadBandwidth } from './bandwidth.ts';
import { distanceOf, NO_DISTANCE, worse, type Distance } from './distance.ts';
import { quantile, spread, type Spread } from './quantile.ts';

const FRAMES = 60;
/** Exact frames come in rounds, each beside the bandwidth of its moment: a machine that others use is not the same for long. */
const ROUNDS = 5, FRAMES_A_ROUND = 12;
/** Frames at which exact and cheap shapes are compared. */
const COMPARED = 14;

/** Milliseconds. */
export interface ExactFrames {
  firstMs: number;
  spline: Spread;
  solve: Spread;
  place: Spread;
  normals: Spread;
  frame: Spread;
  rounds: Round[];
}

/** Medians of its frames in milliseconds; bytes a second. */
export interface Round {
  solveMs: number;
  frameMs: number;
  bandwidth: number;
}

export interface CheapFrames {
  /** The first one makes what all need. */
  firstMs: number;
  preview: Spread;
  /** The largest mean and the largest distance over the compared frames. */
  agreement: Distance;
}

/** From well before the first key to well after the last. */
const timeOf = (k: number, count: number): number => -0.2 + (1.4 * k) / count;

/** One answer, which nobody overtakes. */
export async function frameOf(answer: Promise<Frame | null>): Promise<Frame> {
  const frame = await answer;
  if (!frame) throw new Error('a frame was overtaken although none else was asked for');
  return frame;
}

async function msOf(answer: Promise<Frame | null>): Promise<number> {
  const frame = await frameOf(answer);
  frame.release();
  return frame.ms;
}

export async function exactFrames(sequence: Sequence, readBandwidth: ReadBandwidth): Promise<ExactFrames> {
  const firstMs = await msOf(sequence.evaluate(0));
  const ms: number[] = [], stats: SequenceStats[] = [], rounds: Round[] = [];
  for (let round = 0; round < ROUNDS; ++round) {
    const bandwidth = readBandwidth();
    for (let k = 0; k <= FRAMES_A_ROUND; ++k) {
      ms.push(await msOf(sequence.evaluate(timeOf(k, FRAMES_A_ROUND))));
      stats.push(await sequence.stats());
    }
    const last = -(FRAMES_A_ROUND + 1);
    rounds.push({ bandwidth, frameMs: quantile(ms.slice(last)), solveMs: quantile(stats.slice(last).map(({ solveMs }) => solveMs)) });
  }
  const part = (of: 'facesMs' | 'solveMs' | 'placeMs' | 'normalsMs'): Spread => spread(stats.map((one) => one[of]));
  return {
    firstMs, spline: part('facesMs'), solve: part('solveMs'), place: part('placeMs'), normals: part('normalsMs'), frame: spread(ms), rounds,
  };
}

export async function cheapFrames(sequence: Sequence): Promise<CheapFrames> {
  const firstMs = await msOf(sequence.preview(0.1));
  const ms: number[] = [];
  for (let k = 0; k <= FRAMES; ++k) ms.push(await msOf(sequence.preview(timeOf(k, FRAMES))));
  let agreement: Distance = NO_DISTANCE;
  for (let k = 0; k <= COMPARED; ++k) {
    const cheap = await frameOf(sequence.preview(timeOf(k, COMPARED)));
    const exact = await frameOf(sequence.evaluate(timeOf(k, COMPARED)));
    agreement = worse(agreement, distanceOf(cheap.positions, exact.positions));
    for (const frame of [cheap, exact]) frame.release();
  }
  return { firstMs, preview: spread(ms), agreement };
}
