/**
 * Files of the engine as located by the app's bundler. In the npm package, `packaged/browser-files` replaces this file.
 */
import wasmUrl from '../../build/wasm/shapespline.wasm?url';
import filesUrl from '../../build/wasm/shapespline_files.wasm?url';
import shellsUrl from '../../build/wasm/shapespline_shells.wasm?url';
import threadsUrl from '../../build/wasm/shapespline_threads.wasm?url';
import workerUrl from './worker/engine.worker.ts?worker&url';
import { notLoaded } from './api/errors.ts';
import type { BrowserFiles } from './caller/browser-files.ts';
import { FallbackWorker } from './caller/fallback-worker.ts';

/** A frame sandboxed without allow-same-origin has no origin. A worker there can only import from a host. */
function workerAddress(): string {
  const { href } = new URL(workerUrl, import.meta.url);
  if (globalThis.origin !== 'null') return href;
  return `data:text/javascript,${encodeURIComponent(`import ${JSON.stringify(href)};`)}`;
}

export const files: BrowserFiles = {
  wasm: () => new URL(wasmUrl, import.meta.url),
  filesWasm: () => new URL(filesUrl, import.meta.url),
  shellsWasm: () => new URL(shellsUrl, import.meta.url),
  threads: () => new URL(threadsUrl, import.meta.url),
  // The worker knows its own URLs.
  forWorker: () => ({}),
  startWorker: (name, loaded) =>
    new FallbackWorker([() => new Worker(workerAddress(), { type: 'module', name })], loaded),
  notStarted: (silent) => notLoaded('worker script', silent ? 'it does not respond' : 'it did not start'),
};
