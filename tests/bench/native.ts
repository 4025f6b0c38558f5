/** Eigen and our own solver on the same system, native, on the same machine, and the double solution that frames are compared with. */
import { fileURLToPath } from 'node:url';
import { withProgram } from './answers.ts';
import type { EigenRound, RunEigen } from './eigen.ts';
import { REFERENCE_TIME } from './measure.ts';

// Relative to the bundle, build/node/bench.mjs.
const program = fileURLToPath(new URL('../cmake-release/shapespline_bench_native', import.meta.url));

interface Solver {
  orderMs: number;
  factorMs: number;
  solveMs: number;
  /** As of EigenRound. */
  error: number;
}

export interface NativeRun {
  unknowns: number;
  /** Made once: it depends on the structure alone. */
  eigenOrderMs: number;
  /** Our own, native, in either precision. */
  single: Solver;
  double: Solver;
}

/** Writes the double solution to `reference`; `work` may then ask for rounds of Eigen on the mesh's system. */
export function withNative<T>(mesh: string, reference: string, work: (native: NativeRun, runEigen: RunEigen) => Promise<T>): Promise<T> {
  return withProgram(program, [mesh, reference, String(REFERENCE_TIME)], async ({ next, ask }) =>
    work(await next() as NativeRun, async () => await ask() as EigenRound));
}
