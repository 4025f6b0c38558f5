/** Eigen's factorisation of the same system, native, on the same machine, and the double solution that frames are compared with. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
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

export function runNative(mesh: string): { native: NativeRun; reference: Float64Array } {
  const referenceFile = `${mesh}.reference`;
  const output = execFileSync(program, [mesh, referenceFile, String(REFERENCE_TIME)], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
  const bytes = readFileSync(referenceFile);
  const reference = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer);
  return { native: JSON.parse(output) as NativeRun, reference };
}
