/** The engine in a browser. */
import defaultWasmUrl from '../../build/wasm/shapespline.wasm?url';
import { lockReleased } from './wire/worker-lock.ts';
import type { Engine } from './api/api.ts';
import { EngineClient, onlyOnce } from './caller/engine.ts';
import { engineError } from './api/errors.ts';
import type { FromWorker, Locked } from './wire/protocol.ts';
import { compileFrom, notLoaded } from './caller/wasm-file.ts';
import { endedWorker, type Spawn } from './caller/worker-client.ts';

export interface EngineUrls {
  /** The worker's script, a module; default: the one that was bundled with this file. May be on another origin. */
  workerUrl?: string | URL;
  /** shapespline.wasm; default: the one that was bundled with this file. */
  wasmUrl?: string | URL;
  /**
   * shapespline_threads.wasm, for large meshes on a page that is cross-origin isolated; null: none. Default: the
   * bundled one.
   */
  threadsUrl?: string | URL | null;
  /**
   * A worker has ended by itself. What it was asked is rejected; the next call starts another one with the same keys.
   */
  onLost?: () => void;
}

/** Starts fetching the wasm and a first worker at once; further workers are made when they are needed. */
export function createEngine({ workerUrl, wasmUrl, threadsUrl, onLost }: EngineUrls = {}): Engine {
  const url = new URL(wasmUrl ?? defaultWasmUrl, document.baseURI);
  const possible = threadsUrl !== null && globalThis.crossOriginIsolated && navigator.hardwareConcurrency > 1;
  const compiled = onlyOnce(() => compileThreaded(threadsUrl));
  const threaded = possible ? () => Promise.race([compiled(), late()]) : null;
  const engine = new EngineClient({ spawn: spawnFrom(workerUrl, onLost), module: compile(url), threaded });
  engine.warm();
  return engine;
}

/**
 * Milliseconds that a large mesh may wait for the module for two threads, which is fetched while its files are read.
 */
const PATIENCE = 1000;

function late(): Promise<null> {
  return new Promise((resolve) => void setTimeout(resolve, PATIENCE, null));
}

// Two threads share memory, which browsers allow where the host isolates the page. Without them everything works the
// same.
async function compileThreaded(given: string | URL | null | undefined): Promise<WebAssembly.Module | null> {
  try {
    const url = given ?? (await import('../../build/wasm/shapespline_threads.wasm?url')).default;
    return await compile(new URL(url, document.baseURI));
  } catch {
    return null;
  }
}

let workers = 0;

function spawnFrom(workerUrl: string | URL | undefined, onLost: (() => void) | undefined): Spawn {
  return (events) => {
    const name = `shapespline worker ${++workers} ${performance.timeOrigin} ${Math.random()}`;
    const given = workerUrl && sameOrigin(new URL(workerUrl, document.baseURI));
    const worker = given
      ? new Worker(given, { type: 'module', name })
      : new Worker(new URL('./worker/engine.worker.ts', import.meta.url), { type: 'module', name });
    let replied = false;
    let wanted = true;
    const lost = (reason: string): void => {
      const unexpected = wanted;
      events.failure(endedWorker(reason));
      if (unexpected) onLost?.();
    };
    worker.onmessage = ({ data }: MessageEvent<FromWorker | Locked>) => {
      if (!replied && typeof given === 'string') URL.revokeObjectURL(given);
      replied = true;
      if (data.type === 'locked') void lockReleased(name).then(() => lost('the browser has ended it'));
      else events.message(data);
    };
    worker.onmessageerror = () => events.failure(endedWorker('a message could not be received'));
    worker.onerror = (event) => {
      event.preventDefault();
      if (!replied && typeof given === 'string') URL.revokeObjectURL(given);
      if (replied || event.message) lost(event.message);
      else events.failure(notLoaded("the worker's script", 'it did not start'));
    };
    const terminate = (): void => {
      wanted = false;
      worker.terminate();
    };
    return { post: (message, transfer) => worker.postMessage(message, transfer), terminate };
  };
}

// A worker must come from the page's own origin: a script of another one is imported by a small one of ours.
function sameOrigin(url: URL): URL | string {
  if (url.origin === location.origin) return url;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' }));
}

async function compile(url: URL): Promise<WebAssembly.Module> {
  if (!hasSimd()) {
    throw engineError(
      'no-simd',
      'This browser cannot run the computation: its WebAssembly lacks SIMD. ' +
        'Any current version of Firefox, Chrome, Edge or Safari can.',
    );
  }
  return compileFrom(url);
}

/** Validates the smallest module that uses a vector instruction: a function that returns i8x16.splat(0). */
function hasSimd(): boolean {
  return WebAssembly.validate(
    new Uint8Array([
      0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
    ]),
  );
}
