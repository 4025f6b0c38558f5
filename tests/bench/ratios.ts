/** Ratios of what was measured in one round, for tables and targets alike: their medians over the rounds. */
import { short } from './format.ts';
import type { RoundMedians } from './frames.ts';
import type { Run } from './measure.ts';
import { quantile } from './quantile.ts';

export type OfRound = (run: Run, round: RoundMedians) => number;

/** Milliseconds that reading the factor twice takes at that many bytes per second: no solve can be faster. */
export const boundMs = (run: Run, bandwidth: number): number => (2000 * run.factorBytes) / bandwidth;

export const solveOverBound: OfRound = (run, { solveMs, bandwidth }) => solveMs / boundMs(run, bandwidth);
export const frameOverSolve: OfRound = (_, { frameMs, solveMs }) => frameMs / solveMs;
/** All from the file's bytes to the first frame, over Eigen's analysis of the same system. */
export const untilFrameOverEigensOrder: OfRound = ({ importMs }, { untilFrameMs, eigen }) =>
  (importMs + untilFrameMs) / eigen.orderMs;
export const eigenOverSolve: OfRound = (_, { eigen, solveMs }) => eigen.solveMs / solveMs;
export const eigenOverFactor: OfRound = (_, { eigen, factorMs }) => eigen.factorMs / factorMs;

const values = (run: Run, of: OfRound): number[] => run.exact.rounds.map((round) => of(run, round));

export const ofRounds = (run: Run, of: OfRound): number => quantile(values(run, of));

/** The median, and the lowest and highest: how steady the machine was. */
export function steady(run: Run, of: OfRound): string {
  return `${short(ofRounds(run, of))} (${short(Math.min(...values(run, of)))} to ${short(Math.max(...values(run, of)))})`;
}
