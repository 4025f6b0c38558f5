/**
 * Eigen and our own solver on the same system, native, on the same machine, and the double solutions that frames are
 * compared with.
 */
import { rm } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { withProgram } from './line-protocol.ts';
import type { EigenRound, RunEigen } from './eigen.ts';
import { REFERENCE } from './runner.ts';
import { SWEEP } from './sweep.ts';

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
  /** Our own, native, in either precision. */
  single: Solver;
  double: Solver;
}

/** The double solutions lie beside the mesh during `work`, which may ask for rounds of Eigen on the mesh's system. */
export async function withNative<T>(
  mesh: string,
  work: (native: NativeRun, runEigen: RunEigen) => Promise<T>,
): Promise<T> {
  try {
    return await withProgram(program, [mesh, mesh + REFERENCE, ...SWEEP.map(String)], async ({ next, ask }) =>
      work((await next()) as NativeRun, async () => (await ask()) as EigenRound),
    );
  } finally {
    await Promise.all(SWEEP.map((_, k) => rm(mesh + REFERENCE + k, { force: true })));
  }
}
