/**
 * Runs our native solver and others on the same system and machine. Provides double-precision solutions to compare
 * frames with.
 */
import { rm } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { withProgram } from './line-protocol.ts';
import type { NativeRound, RunNative } from './native-round.ts';
import { REFERENCE } from './runner.ts';
import { SWEEP } from './sweep.ts';

// The path is relative to the bundle, build/node/bench.mjs.
const program = fileURLToPath(new URL('../cmake-release/shapespline_bench_native', import.meta.url));
/** CHOLMOD's BLAS would use all cores. */
const ONE_THREAD = { OPENBLAS_NUM_THREADS: '1', OMP_NUM_THREADS: '1' };

/**
 * The double-precision solutions are stored beside the mesh during `work`, which may request rounds on the mesh's
 * system.
 */
export async function withNative<T>(
  mesh: string,
  work: (unknowns: number, runNative: RunNative) => Promise<T>,
): Promise<T> {
  const args = [mesh, mesh + REFERENCE, ...SWEEP.map(String)];
  try {
    return await withProgram(program, args, ONE_THREAD, async ({ next, ask }) => {
      const { unknowns } = (await next()) as { unknowns: number };
      return work(unknowns, async () => (await ask()) as NativeRound);
    });
  } finally {
    await Promise.all(SWEEP.map((_, k) => rm(mesh + REFERENCE + k, { force: true })));
  }
}
