/** Where the files of the engine are, for pages and programs that keep them elsewhere than beside its scripts. */
import { invalidOption } from './errors.ts';

export interface FileUrls {
  /** shapespline.wasm; default: the one beside the engine's script. */
  wasmUrl?: string | URL | undefined;
  /**
   * shapespline_files.wasm, fetched when files are first read or written; default: the one beside `wasmUrl` where that
   * is given, else beside the engine's script.
   */
  filesUrl?: string | URL | undefined;
  /**
   * The worker's script, a module; default: the one beside the engine's script. May be on another origin, where the
   * page's policy lets a `blob:` worker start; one of the page's own origin needs nothing.
   */
  workerUrl?: string | URL | undefined;
  /**
   * shapespline_threads.wasm, for large meshes where two threads may share memory (a page that is crossOriginIsolated,
   * a machine of more than one processor); null: none. Default: the one beside the engine's script.
   */
  threadsUrl?: string | URL | null | undefined;
  /** draco_decoder_gltf.wasm, for files with Draco's compression; default: the one beside the engine's script. */
  dracoUrl?: string | URL | undefined;
}

/** Of one engine. */
export interface EngineUrls extends FileUrls {
  /**
   * A worker has ended by itself. What it was asked is rejected; the next call starts another one with the same keys.
   */
  onLost?: (() => void) | undefined;
}

const NAMES = ['wasmUrl', 'filesUrl', 'workerUrl', 'threadsUrl', 'dracoUrl'] as const;

let configured: FileUrls = {};
let inUse = false;

/**
 * Says once where the files are, for all engines. Relative addresses count from the page's, in Node from the folder in
 * which the program was started. Error: invalid-option, also where an engine has been made already with other files.
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

/** For an engine that is made now: its own files, else those that were configured. */
export function urlsFor(own: FileUrls): FileUrls {
  inUse = true;
  return { ...configured, ...own };
}

/** The module for files, where the core is somewhere of its own. */
export function besideCore(wasm: URL | undefined): URL | undefined {
  return wasm && new URL('shapespline_files.wasm', wasm);
}
