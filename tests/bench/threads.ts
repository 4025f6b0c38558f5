/** npm run bench -- threads [FACES,...]: frames with one thread and with two, in turn, so that both meet the same machine. */
import { readFileSync } from 'node:fs';
import type { Sequence } from '../../web/engine/api.ts';
import { createEngine } from '../../web/engine/node.ts';
import { short } from './format.ts';
import { quantile } from './quantile.ts';

/** A first frames' choice between one thread and two is over by then. */
const WARM_UP = 15;
const FRAMES = 61;

async function frameMs(sequence: Sequence, k: number): Promise<number> {
  const frame = await sequence.evaluate(-0.2 + (1.4 * k) / FRAMES);
  frame?.release();
  return frame?.ms ?? Number.NaN;
}

/** One line on one mesh. */
export async function compareThreads(mesh: string): Promise<string> {
  const engines = [createEngine({ threadsUrl: null }), createEngine()];
  try {
    const sequences: Sequence[] = [];
    for (const engine of engines) {
      sequences.push(await engine.createSequence(await engine.importKeyframes([{ name: 'bench.glb', bytes: new Uint8Array(readFileSync(mesh)) }])));
    }
    const times: [number[], number[]] = [[], []];
    for (let k = -WARM_UP; k < FRAMES; ++k) {
      for (const [i, sequence] of sequences.entries()) {
        const ms = await frameMs(sequence, Math.abs(k));
        if (k >= 0) times[i]!.push(ms);
      }
    }
    const [one, two] = times.map((list) => quantile(list)) as [number, number];
    const { threads, weldedVertices } = await sequences[1]!.stats();
    return `${weldedVertices} vertices: a frame by one thread ${short(one)} ms, with a second at hand ${short(two)} ms `
      + `(${short(one / two)} times faster; ${threads === 2 ? 'both work' : 'one was found to be faster'})`;
  } finally {
    for (const engine of engines) engine.dispose();
  }
}
