/** Inside a worker: one wasm module, which answers requests in order of arrival. */
import {
  crashed,
  EngineError,
  engineError,
  isOutOfMemory,
  messageOf,
  notLoaded,
  outOfMemory,
  type ErrorData,
} from '../api/errors.ts';
import type { CallName, CoreCallName, FromWorker, Program, Request, ResultOf, ToWorker } from '../wire/protocol.ts';
import type { Codecs } from './codecs.ts';
import type { Handlers } from './handlers.ts';
import { CoreHandlers } from './core-handlers.ts';
import { fileHandlers } from './file-handlers.ts';
import type { Decode } from './import-files.ts';
import type { SecondThreadStart } from './second-thread.ts';
import type { OnProgress } from './wasm-calls.ts';
import { WasmCore } from './wasm-core.ts';
import { WasmFiles } from './wasm-files.ts';
import type { CoreModule, CreateWasmModule, FilesModule } from './wasm-module.ts';

export interface HandlerHost {
  post(message: FromWorker, transfer: ArrayBuffer[]): void;
  create: CreateWasmModule<CoreModule>;
  /** The glue of the threaded module. */
  createThreaded(): Promise<CreateWasmModule<CoreModule>>;
  /** The glue of the module for files. */
  createFiles(): Promise<CreateWasmModule<FilesModule>>;
  /** The glue and handlers of the module for fitted motions. */
  startShells(module: WebAssembly.Module): Promise<Partial<Handlers<CallName>>>;
  /** Starts a second thread. Nothing waits for a thread that never becomes ready. */
  startSecondThread(start: SecondThreadStart, onReady: () => void): void;
  /** Decodes mesh compression that the core does not support, before the core reads the files. */
  decode: Decode;
  /** Libraries for compressed exports. */
  codecs: Codecs;
}

export class RequestHandler {
  private handlers: Promise<Partial<Handlers<CallName>>> | null = null;
  private tail: Promise<void> = Promise.resolve();

  constructor(private readonly host: HandlerHost) {}

  receive(message: ToWorker): void {
    if (message.type === 'start') {
      this.handlers = this.start(message).catch((reason: unknown) => {
        throw reason instanceof WebAssembly.LinkError ? mismatch(reason) : reason;
      });
      this.handlers.catch(() => undefined); // The first request reports this error.
      return;
    }
    this.tail = this.tail.then(() => this.serve(message));
  }

  private async start({ kind, module, threaded }: Program): Promise<Partial<Handlers<CallName>>> {
    const { create, decode, codecs } = this.host;
    if (kind === 'shells') return this.host.startShells(module);
    if (kind === 'files') return fileHandlers(await this.startFiles(module), decode, codecs);
    const core = threaded && (await this.startThreaded(threaded).catch(() => null));
    return core ?? new CoreHandlers(await WasmCore.start(create, module)).table();
  }

  private async startFiles(module: WebAssembly.Module): Promise<WasmFiles> {
    const create = await this.host.createFiles().catch((reason: unknown) => {
      throw notLoaded('worker script', messageOf(reason), 'The part of shapespline that reads files');
    });
    return WasmFiles.start(create, module);
  }

  private async startThreaded(compiled: WebAssembly.Module): Promise<Handlers<CoreCallName>> {
    const core = await WasmCore.start(await this.host.createThreaded(), compiled);
    const handlers = new CoreHandlers(core);
    const start = core.secondThreadStart(compiled);
    if (start) this.host.startSecondThread(start, handlers.useSecondThread);
    return handlers.table();
  }

  private async serve(request: Request): Promise<void> {
    const { type, id } = request;
    const report: OnProgress = (stage, fraction) => this.host.post({ type: 'progress', id, stage, fraction }, []);
    try {
      const handlers = await this.handlers;
      if (!handlers) throw crashed('the worker was not started');
      // Request and answer belong to the same name, but the compiler cannot follow this through the table.
      const value = await (handlers[type] as (request: Request, report: OnProgress) => ResultOf<CallName>)(
        request,
        report,
      );
      this.host.post({ type: 'result', id, value }, buffersOf(value));
    } catch (reason) {
      const { error, fatal } = describe(reason);
      this.host.post({ type: 'error', id, error, fatal }, []);
    }
  }
}

// Errors reported by the core leave it intact, except lack of memory and internal errors. Any other exception is a
// trap.
function describe(reason: unknown): { error: ErrorData; fatal: boolean } {
  const error = reason instanceof EngineError ? reason : trapped(messageOf(reason));
  const fatal = error !== reason || ['out-of-memory', 'internal', 'crashed', 'not-loaded'].includes(error.code);
  return { error: { code: error.code, message: error.message, place: error.place }, fatal };
}

// The files come from two releases, for example because of an old cache.
function mismatch(reason: Error): EngineError {
  return engineError(
    'not-loaded',
    'The loaded parts of the program have different versions. Reload the page without its ' +
      `cache, or rebuild it (${reason.message}).`,
  );
}

function trapped(text: string): EngineError {
  return isOutOfMemory(text) ? outOfMemory() : crashed(text);
}

/** The buffers of all typed arrays in a result, for transfer. */
export function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) {
    if (value.buffer instanceof ArrayBuffer) found.add(value.buffer);
  } else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) buffersOf(part, found);
  }
  return [...found];
}
