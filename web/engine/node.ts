/** The engine in Node, over worker threads. */
import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { Engine } from './api/api.ts';
import { siblingModule, type EngineUrls, type FileUrls, urlsFor } from './api/configure.ts';
import { EngineClient, onlyOnce } from './caller/engine.ts';
import { engineError, messageOf } from './api/errors.ts';
import { files } from './node-files.ts';
import type { FromWorker } from './wire/protocol.ts';
import { endedWorker, type Spawn } from './caller/worker-client.ts';

/** The process stays alive while an engine has workers, so dispose of the engine. */
export function createEngine({ onLost, ...own }: EngineUrls = {}): Engine {
  const { wasmUrl, filesUrl, shellsUrl, workerUrl, threadsUrl, dracoUrl } = urlsFor(own);
  const filesWasm = fileUrl(filesUrl) ?? siblingModule(fileUrl(wasmUrl), 'files') ?? files.filesWasm;
  const shellsWasm = fileUrl(shellsUrl) ?? siblingModule(fileUrl(wasmUrl), 'shells') ?? files.shellsWasm;
  const threads = threadsUrl === null ? null : (fileUrl(threadsUrl) ?? files.threads);
  return new EngineClient({
    spawn: spawnFrom(fileUrl(workerUrl) ?? files.worker, onLost),
    module: compile(fileUrl(wasmUrl) ?? files.wasm, 'wasmUrl'),
    filesModule: onlyOnce(() => compile(filesWasm, 'filesUrl')),
    shellsModule: onlyOnce(() => compile(shellsWasm, 'shellsUrl')),
    threaded:
      threads && availableParallelism() > 1 ? onlyOnce(() => compile(threads, 'threadsUrl').catch(() => null)) : null,
    files: files.forWorker(fileUrl(dracoUrl)?.href),
  });
}

/** Resolves a path against the working directory at start. */
function fileUrl(url: string | URL | undefined): URL | undefined {
  if (url === undefined || url instanceof URL) return url;
  return url.startsWith('file:') ? new URL(url) : pathToFileURL(url);
}

/** Runs work with a temporary engine. */
export async function withEngine<T>(work: (engine: Engine) => Promise<T>, urls?: EngineUrls): Promise<T> {
  const engine = createEngine(urls);
  try {
    return await work(engine);
  } finally {
    engine.dispose();
  }
}

/**
 * Node passes the program's flags on to worker threads by itself. They reject only the type of a program given as text.
 */
const isText = /--input[-_]type/.test([...process.execArgv, process.env['NODE_OPTIONS']].join(' '));
const threadOptions = isText ? { execArgv: [], env: { ...process.env, NODE_OPTIONS: '' } } : {};

function spawnFrom(workerUrl: URL, onLost: (() => void) | undefined): Spawn {
  return (events) => {
    const worker = new Worker(workerUrl, threadOptions);
    let wanted = true;
    const lost = (reason: unknown): void => {
      events.failure(endedWorker(reason));
      if (wanted) onLost?.();
      wanted = false;
    };
    worker.on('message', (message: FromWorker) => events.message(message));
    worker.on('messageerror', (error) => events.failure(endedWorker(error)));
    worker.on('error', lost);
    worker.on('exit', (code) => lost(`its thread ended with code ${code}`));
    const terminate = (): void => {
      wanted = false;
      void worker.terminate();
    };
    return { post: (message, transfer) => worker.postMessage(message, transfer as ArrayBuffer[]), terminate };
  };
}

async function compile(url: URL, option: keyof FileUrls): Promise<WebAssembly.Module> {
  try {
    return await WebAssembly.compile(await readFile(url));
  } catch (error) {
    throw engineError(
      'not-loaded',
      `The computation could not be loaded from ${url.pathname} (${messageOf(error)}). ` +
        `Put the .wasm file there, or set its path: configure({ ${option} }).`,
      error,
    );
  }
}
