/** URLs of the engine's files. */
import { invalidOption } from './errors.ts';

export interface FileUrls {
  /** URL of shapespline.wasm; default: next to the engine's script. */
  wasmUrl?: string | URL | undefined;
  /**
   * shapespline_files.wasm, fetched when files are first read or written; default: next to `wasmUrl` if given,
   * otherwise next to the engine's script.
   */
  filesUrl?: string | URL | undefined;
  /** shapespline_shells.wasm, fetched for the first motion of method lengths or shell; default: as for `filesUrl`. */
  shellsUrl?: string | URL | undefined;
  /**
   * The worker's script, a module; default: next to the engine's script. A script from another origin needs a page
   * policy that allows a `blob:` worker.
   */
  workerUrl?: string | URL | undefined;
  /**
   * shapespline_threads.wasm, for large meshes if two threads can share memory (the page is crossOriginIsolated and has
   * more than one processor); null: none. Default: next to the engine's script.
   */
  threadsUrl?: string | URL | null | undefined;
  /** URL of draco_decoder_gltf.wasm, for files with Draco compression; default: next to the engine's script. */
  dracoUrl?: string | URL | undefined;
}

/** URLs for one engine. */
export interface EngineUrls extends FileUrls {
  /** A worker ended unexpectedly. Its requests are rejected; the next call starts a new worker with the same keys. */
  onLost?: (() => void) | undefined;
}

const NAMES = ['wasmUrl', 'filesUrl', 'shellsUrl', 'workerUrl', 'threadsUrl', 'dracoUrl'] as const;

let configured: FileUrls = {};
let inUse = false;

/**
 * Sets the files for all engines, once. Relative URLs are resolved against the page's URL, or in Node against the
 * working directory. Error: invalid-option, also if an engine already uses other files.
 */
export function configure(urls: FileUrls): void {
  const unknown = Object.keys(urls).find((name) => !NAMES.some((known) => known === name));
  if (unknown !== undefined)
    throw invalidOption(`configure has no option ${unknown}. The options are ${NAMES.join(', ')}.`);
  for (const name of NAMES) checkUrl(name, urls[name]);
  const differs = NAMES.some((name) => name in urls && String(urls[name]) !== String(configured[name]));
  if (inUse && differs) {
    throw invalidOption(
      'configure was called too late: call it before the first engine is made or <shape-spline> starts.',
    );
  }
  configured = { ...configured, ...urls };
}

function checkUrl(name: string, url: unknown): void {
  const good = url === undefined || (typeof url === 'string' && url !== '') || url instanceof URL;
  if (!good && !(url === null && name === 'threadsUrl')) {
    throw invalidOption(`${name} must be a URL: a string or a URL object.`);
  }
}

/** The files of a new engine: its own, or else the configured ones. */
export function urlsFor(own: FileUrls): FileUrls {
  inUse = true;
  return { ...configured, ...own };
}

/** URL of another module if only the core's URL is configured. */
export function siblingModule(wasm: URL | undefined, name: 'files' | 'shells'): URL | undefined {
  return wasm && new URL(`shapespline_${name}.wasm`, wasm);
}
