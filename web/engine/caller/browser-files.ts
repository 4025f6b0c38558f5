/** The engine's interface to the code that locates its files in a browser. */
import type { EngineError } from '../api/errors.ts';
import type { WorkerFiles } from '../wire/protocol.ts';

/** A worker or its replacement. */
export interface StartedWorker
  extends Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onmessageerror' | 'onerror'> {
  /** It did not start because its script is silent. */
  readonly silent?: boolean;
}

export interface BrowserFiles {
  wasm(): URL;
  filesWasm(): URL;
  shellsWasm(): URL;
  threads(): URL;
  /** URLs that a worker fetches itself when needed, configured or default. */
  forWorker(given: { draco?: string | undefined; worker?: URL | undefined }): WorkerFiles;
  /** From `given`, else from the engine's own script. `loaded` settles when the engine's other files have loaded. */
  startWorker(name: string, loaded: Promise<unknown>, given?: URL): StartedWorker;
  /** The error if the worker did not start. */
  notStarted(silent: boolean, given?: URL): EngineError;
}
