/** The engine in Node, over worker threads. */
import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import type { Engine } from './api/api.ts';
import { EngineClient, onlyOnce } from './caller/engine.ts';
import { engineError, messageOf } from './api/errors.ts';
import type { FromWorker } from './wire/protocol.ts';
import { endedWorker, type Spawn } from './caller/worker-client.ts';

export interface EngineUrls {
  /** The bundled worker; default: build/node/node-worker.mjs of this repository. */
  workerUrl?: URL;
  /** Default: build/wasm/shapespline.wasm of this repository. */
  wasmUrl?: URL;
  /**
   * For large meshes on a machine of more than one processor; null: none. Default: build/wasm/shapespline_threads.wasm.
   */
  threadsUrl?: URL | null;
}

// The same relative paths hold from this file and from the bundle that it becomes part of (build/node).
const WORKER_URL = new URL('../../build/node/node-worker.mjs', import.meta.url);
const WASM_URL = new URL('../../build/wasm/shapespline.wasm', import.meta.url);
const THREADS_URL = new URL('../../build/wasm/shapespline_threads.wasm', import.meta.url);

/** The process lives as long as an engine has workers: dispose of it. */
export function createEngine({
  workerUrl = WORKER_URL,
  wasmUrl = WASM_URL,
  threadsUrl = THREADS_URL,
}: EngineUrls = {}): Engine {
  const threaded =
    threadsUrl && availableParallelism() > 1 ? onlyOnce(() => compile(threadsUrl).catch(() => null)) : null;
  return new EngineClient({ spawn: spawnFrom(workerUrl), module: compile(wasmUrl), threaded });
}

/** Works with an engine of its own, which ends with the work. */
export async function withEngine<T>(work: (engine: Engine) => Promise<T>, urls?: EngineUrls): Promise<T> {
  const engine = createEngine(urls);
  try {
    return await work(engine);
  } finally {
    engine.dispose();
  }
}

function spawnFrom(workerUrl: URL): Spawn {
  return (events) => {
    const worker = new Worker(workerUrl);
    worker.on('message', (message: FromWorker) => events.message(message));
    worker.on('messageerror', (error) => events.failure(endedWorker(error)));
    worker.on('error', (error) => events.failure(endedWorker(error)));
    worker.on('exit', (code) => events.failure(endedWorker(`its thread ended with code ${code}`)));
    return {
      post: (message, transfer) => worker.postMessage(message, transfer as ArrayBuffer[]),
      terminate: () => void worker.terminate(),
    };
  };
}

async function compile(url: URL): Promise<WebAssembly.Module> {
  try {
    return await WebAssembly.compile(await readFile(url));
  } catch (error) {
    throw engineError(
      'not-loaded',
      `The computation could not be loaded from ${url.pathname} (${messageOf(error)}).`,
      error,
    );
  }
}
