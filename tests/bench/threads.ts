/**
 * npm run bench -- threads [FACES,... --browser]: builds and frames with one thread and with two, measured alternately
 * under the same load.
 */
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import { short } from './format.ts';
import { frameOf } from './frames.ts';
import { quantile } from './quantile.ts';

/** Number of first frames after which the choice between one and two threads is settled. */
const WARM_UP = 15;
const BUILDS = 5;
const FRAMES = 61;

/** Medians in milliseconds, with one thread and with a second available. */
export interface ThreadsRun {
  vertices: number;
  /** Time from the keys to the sequence. */
  builtByOne: number;
  builtByTwo: number;
  one: number;
  two: number;
  /** The number of threads found to be faster. */
  threads: 1 | 2;
}

async function frameMs(sequence: Sequence, k: number): Promise<number> {
  const frame = await frameOf(sequence.evaluate(-0.2 + (1.4 * k) / FRAMES));
  frame.release();
  return frame.ms;
}

/** The first engine has no second thread. */
export async function compareThreads(engines: readonly [Engine, Engine], mesh: Uint8Array): Promise<ThreadsRun> {
  const sequences: Sequence[] = [];
  const builds: [number[], number[]] = [[], []];
  for (let round = 0; round < BUILDS; ++round) {
    for (const [i, engine] of engines.entries()) {
      sequences[i]?.dispose();
      const keys = await engine.importKeyframes([{ name: 'bench.glb', bytes: mesh.slice() }]);
      const begun = performance.now();
      sequences[i] = await engine.createSequence(keys);
      builds[i]!.push(performance.now() - begun);
    }
  }
  const times: [number[], number[]] = [[], []];
  for (let k = -WARM_UP; k < FRAMES; ++k) {
    for (const [i, sequence] of sequences.entries()) {
      const ms = await frameMs(sequence, Math.abs(k));
      if (k >= 0) times[i]!.push(ms);
    }
  }
  const { threads, weldedVertices: vertices } = await sequences[1]!.stats();
  const [builtByOne, builtByTwo] = [quantile(builds[0]), quantile(builds[1])];
  return { vertices, builtByOne, builtByTwo, one: quantile(times[0]), two: quantile(times[1]), threads };
}

export function threadsLine({ vertices, builtByOne, builtByTwo, one, two, threads }: ThreadsRun): string {
  return (
    `${vertices} vertices: built by one thread in ${short(builtByOne)} ms, with a second at hand in ` +
    `${short(builtByTwo)} ms (${short(builtByOne / builtByTwo)} times faster); a frame by one thread ${short(one)} ms, with a second at hand ${short(two)} ms ` +
    `(${short(one / two)} times faster; ${threads === 2 ? 'both work' : 'one was found to be faster'})`
  );
}
