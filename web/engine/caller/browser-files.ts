/** Interface to the code that locates the engine's files in a browser. */
import type { EngineError } from '../api/errors.ts';
import type { WorkerFiles } from '../wire/protocol.ts';

/** A worker or its replacement. */
export interface StartedWorker
  extends Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onmessageerror' | 'onerror'> {
  /** The worker did not start, and its script sent no message. */
  readonly silent?: boolean;
}

export interface BrowserFiles {
  wasm(): URL;
  filesWasm(): URL;
  shellsWasm(): URL;
  threads(): URL;
  /** Configured or default URLs that a worker fetches when needed. */
  forWorker(given: { draco?: string | undefined; worker?: URL | undefined }): WorkerFiles;
  /** Uses `given`, or else the engine's own script. `loaded` settles when the engine's other files have loaded. */
  startWorker(name: string, loaded: Promise<unknown>, given?: URL): StartedWorker;
  /** The error of a worker that did not start. */
  notStarted(silent: boolean, given?: URL): EngineError;
}
