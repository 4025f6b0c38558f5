/** Ratios of numbers from the same round, for tables and targets: medians over the rounds. */
import { short } from './format.ts';
import type { RoundMedians } from './frames.ts';
import type { Run } from './measure.ts';
import type { NativeRound, SolverRound } from './native-round.ts';
import { quantile } from './quantile.ts';

export type OfRound = (run: Run, round: RoundMedians) => number;

/** Milliseconds to read the factor twice at this bandwidth, a lower bound for any solve. */
export const boundMs = (run: Run, bandwidth: number): number => (2000 * run.factorBytes) / bandwidth;

export const solveOverBound: OfRound = (run, { solveMs, bandwidth }) => solveMs / boundMs(run, bandwidth);
export const frameOverSolve: OfRound = (_, { frameMs, solveMs }) => frameMs / solveMs;
/** Time from the file's bytes to the first frame. */
export const untilFrameMs: OfRound = ({ importMs }, round) => importMs + round.untilFrameMs;
export const factorMs: OfRound = (_, round) => round.factorMs;
export const solveMs: OfRound = (_, round) => round.solveMs;

/** Time of a native solver, or NaN without it. */
export const ofNative =
  (solver: keyof NativeRound, value: keyof SolverRound): OfRound =>
  (_, { native }) =>
    native[solver]?.[value] ?? Number.NaN;

/** Ratio of a native solver's time to ours in wasm. */
export const over =
  (solver: keyof NativeRound, step: 'factorMs' | 'solveMs'): OfRound =>
  (run, round) =>
    ofNative(solver, step)(run, round) / round[step];

const values = (run: Run, of: OfRound): number[] => run.exact.rounds.map((round) => of(run, round));

export const ofRounds = (run: Run, of: OfRound): number => quantile(values(run, of));

/** Median, lowest and highest value, to show the machine's variation. */
export function steady(run: Run, of: OfRound): string {
  return `${short(ofRounds(run, of))} (${short(Math.min(...values(run, of)))} to ${short(Math.max(...values(run, of)))})`;
}
