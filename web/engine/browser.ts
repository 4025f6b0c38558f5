/** The engine in a browser. */
import { siblingModule, type EngineUrls, type FileUrls, urlsFor } from './api/configure.ts';
import type { Engine } from './api/api.ts';
import { engineError } from './api/errors.ts';
import { files } from './browser-files.ts';
import { EngineClient, onlyOnce } from './caller/engine.ts';
import { compileFrom } from './caller/wasm-file.ts';
import { endedWorker, type Spawn } from './caller/worker-client.ts';
import type { FromWorker, Locked } from './wire/protocol.ts';
import { lockReleased } from './wire/worker-lock.ts';

/** Starts fetching the wasm and a first worker immediately. More workers are started as needed. */
export function createEngine({ onLost, ...own }: EngineUrls = {}): Engine {
  const { wasmUrl, filesUrl, shellsUrl, workerUrl, threadsUrl, dracoUrl } = urlsFor(own);
  const possible = threadsUrl !== null && globalThis.crossOriginIsolated && navigator.hardwareConcurrency > 1;
  const worker = ofPage(workerUrl);
  const compiled = onlyOnce(() => compileThreaded(threadsUrl));
  const module = compile(ofPage(wasmUrl) ?? files.wasm(), 'wasmUrl');
  const filesWasm = ofPage(filesUrl) ?? siblingModule(ofPage(wasmUrl), 'files');
  const shellsWasm = ofPage(shellsUrl) ?? siblingModule(ofPage(wasmUrl), 'shells');
  const engine = new EngineClient({
    spawn: spawnFrom(module, worker, onLost),
    module,
    filesModule: onlyOnce(async () => compile(filesWasm ?? files.filesWasm(), 'filesUrl')),
    shellsModule: onlyOnce(async () => compile(shellsWasm ?? files.shellsWasm(), 'shellsUrl')),
    threaded: possible ? () => Promise.race([compiled(), late()]) : null,
    files: files.forWorker({ draco: ofPage(dracoUrl)?.href, worker }),
  });
  engine.warm();
  return engine;
}

/** Resolves a configured URL against the page's URL. */
function ofPage(url: string | URL | null | undefined): URL | undefined {
  return url ? new URL(url, document.baseURI) : undefined;
}

/**
 * Longest wait, in milliseconds, of a large mesh for the two-thread module, which is fetched while its files are read.
 */
const PATIENCE = 1000;

function late(): Promise<null> {
  return new Promise((resolve) => void setTimeout(resolve, PATIENCE, null));
}

// Two threads share memory, which browsers allow only on isolated pages. Without it, one thread gives the same results.
async function compileThreaded(given: string | URL | null | undefined): Promise<WebAssembly.Module | null> {
  try {
    return await compile(ofPage(given) ?? files.threads(), 'threadsUrl');
  } catch {
    return null;
  }
}

let workers = 0;

function spawnFrom(loaded: Promise<unknown>, workerUrl: URL | undefined, onLost: (() => void) | undefined): Spawn {
  return (events) => {
    const name = `shapespline worker ${++workers} ${performance.timeOrigin} ${Math.random()}`;
    const worker = files.startWorker(name, loaded, workerUrl);
    let replied = false;
    let wanted = true;
    const lost = (reason: string): void => {
      const unexpected = wanted;
      events.failure(endedWorker(reason));
      if (unexpected) onLost?.();
    };
    worker.onmessage = ({ data }: MessageEvent<FromWorker | Locked>) => {
      replied = true;
      if (data.type === 'locked') void lockReleased(name).then(() => lost('the browser ended it'));
      else events.message(data);
    };
    worker.onmessageerror = () => events.failure(endedWorker('a message could not be read'));
    worker.onerror = (event) => {
      event.preventDefault();
      if (replied || event.message) lost(event.message);
      else events.failure(files.notStarted(worker.silent === true, workerUrl));
    };
    const terminate = (): void => {
      wanted = false;
      worker.terminate();
    };
    return { post: (message, transfer) => worker.postMessage(message, transfer), terminate };
  };
}

async function compile(url: URL, option: keyof FileUrls): Promise<WebAssembly.Module> {
  if (!hasSimd()) {
    throw engineError(
      'no-simd',
      'This browser cannot run the computation: it has no WebAssembly with SIMD. ' +
        'Any current version of Firefox, Chrome, Edge or Safari can.',
    );
  }
  return compileFrom(url, option);
}

/** Validates the smallest module with a vector instruction: a function that returns i8x16.splat(0). */
function hasSimd(): boolean {
  return !!globalThis.WebAssembly?.validate(
    new Uint8Array([
      0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
    ]),
  );
}
