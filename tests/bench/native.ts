/** Eigen's factorisation of the same system, native, on the same machine, and the double solution that frames are compared with. */
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { REFERENCE_TIME } from './measure.ts';

// Relative to the bundle, build/node/bench.mjs.
const program = fileURLToPath(new URL('../cmake-release/shapespline_bench_native', import.meta.url));

interface Solver {
  orderMs: number;
  factorMs: number;
  solveMs: number;
  /** Largest distance over the bounding box's diagonal, of a system with a known solution. */
  error: number;
}

export interface NativeRun {
  unknowns: number;
  eigen: Solver;
  /** Our own, native, in either precision. */
  single: Solver;
  double: Solver;
}

/** Writes the double solution to `reference`. */
export function runNative(mesh: string, reference: string): NativeRun {
  const output = execFileSync(program, [mesh, reference, String(REFERENCE_TIME)], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
  return JSON.parse(output) as NativeRun;
}
