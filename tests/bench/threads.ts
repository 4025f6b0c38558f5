/**
 * npm run bench -- threads [FACES,... --browser]: frames with one thread and with two, in turn, so that both meet the
 * same machine.
 */
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import { short } from './format.ts';
import { frameOf } from './frames.ts';
import { quantile } from './quantile.ts';

/** The choice between one thread and two that the first frames make is over by then. */
const WARM_UP = 15;
const FRAMES = 61;

/** Medians, in milliseconds, with one thread and with a second at hand. */
export interface ThreadsRun {
  vertices: number;
  one: number;
  two: number;
  /** That were found to be faster. */
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
  for (const engine of engines)
    sequences.push(
      await engine.createSequence(await engine.importKeyframes([{ name: 'bench.glb', bytes: mesh.slice() }])),
    );
  const times: [number[], number[]] = [[], []];
  for (let k = -WARM_UP; k < FRAMES; ++k) {
    for (const [i, sequence] of sequences.entries()) {
      const ms = await frameMs(sequence, Math.abs(k));
      if (k >= 0) times[i]!.push(ms);
    }
  }
  const { threads, weldedVertices: vertices } = await sequences[1]!.stats();
  return { vertices, one: quantile(times[0]), two: quantile(times[1]), threads };
}

export function threadsLine({ vertices, one, two, threads }: ThreadsRun): string {
  return (
    `${vertices} vertices: a frame by one thread ${short(one)} ms, with a second at hand ${short(two)} ms ` +
    `(${short(one / two)} times faster; ${threads === 2 ? 'both work' : 'one was found to be faster'})`
  );
}
