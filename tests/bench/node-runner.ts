/** The engine in Node's own workers. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { withEngine } from '../../web/engine/node.ts';
import { compareKeys } from './key-counts.ts';
import { measure } from './measure.ts';
import { REFERENCE, type Runner } from './runner.ts';
import { compareResolutions } from './resolutions.ts';
import { runMotion } from './whole-sequences.ts';

/** Targets are for one thread. */
const ONE_THREAD = { threadsUrl: null };

/** `reader`: the module that measures memory bandwidth. */
export function nodeRunner(reader: string): Runner {
  const bytesOf = (file: string): Uint8Array<ArrayBuffer> => new Uint8Array(readFileSync(file));
  return {
    name: `Node ${process.version}`,
    measure: (mesh, runNative) =>
      withEngine(
        (engine) =>
          measure(engine, {
            name: path.basename(mesh),
            mesh: bytesOf(mesh),
            reference: (k) => Promise.resolve(new Float64Array(bytesOf(mesh + REFERENCE + k).buffer)),
            reader: bytesOf(reader),
            runNative,
            processBytes: () => process.memoryUsage().rss,
          }),
        ONE_THREAD,
      ),
    motion: (mesh, motion) =>
      withEngine((engine) => runMotion(engine, path.basename(mesh), bytesOf(mesh), motion), ONE_THREAD),
    resolutions: (coarse, fine) =>
      withEngine((engine) => compareResolutions(engine, bytesOf(coarse), bytesOf(fine)), ONE_THREAD),
    keys: (few, many, count) =>
      withEngine((engine) => compareKeys(engine, bytesOf(few), bytesOf(many), count), ONE_THREAD),
    close: () => Promise.resolve(),
  };
}
