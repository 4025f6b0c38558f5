/** What the solver and the frames are to reach, as ratios within one run. */
import type { Run } from './measure.ts';
import type { NativeRun } from './native.ts';

export interface Target {
  faces: number;
  what: string;
  value: number;
  /** The value must not be above or, for `atLeast`, below it. */
  limit: number;
  atLeast: boolean;
  met: boolean;
}

const GB = 2 ** 30;

/** Milliseconds that reading the factor twice takes: no solve can be faster. */
export function boundMs(run: Run): number {
  return (2000 * run.factorBytes) / run.bandwidth;
}

export function targetsOf(run: Run, native: NativeRun): Target[] {
  const targets: Target[] = [];
  const add = (what: string, value: number, limit: number, atLeast = false): void => {
    targets.push({ faces: run.faces, what, value, limit, atLeast, met: atLeast ? value >= limit : value <= limit });
  };
  const solveGain = native.eigen.solveMs / run.solve.median, factorGain = native.eigen.factorMs / run.factorMs;
  const medium = run.vertices > 160_000 && run.vertices < 600_000, large = run.vertices >= 600_000;
  if (medium || large) {
    add('solve / read bound', run.solve.median / boundMs(run), 1.8);
    add('frame / solve', run.frame.median / run.solve.median, 2.5);
    add("Eigen's solve / ours", solveGain, large ? 7.5 : 6, true);
    add("Eigen's factorisation / ours", factorGain, large ? 15 : 8, true);
  }
  if (run.faces <= 12_000) add('frame, ms', run.frame.median, 1);
  else if (run.faces <= 36_000) add('frame, ms', run.frame.median, 3);
  if (large) add('wasm memory, GB', run.heapBytes / GB, 1.5);
  add('error, 1e-5 of the diagonal', run.error / 1e-5, 1);
  return targets;
}
