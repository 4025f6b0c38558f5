/** The only error type that the engine throws, and the messages of its own failures. */
import type { ErrorPlace } from './types.ts';

/** Codes that arise outside the core. The core's codes are listed in wasm/core/base/status.h. */
export type EngineCode =
  | 'cancelled' // the caller's AbortSignal was aborted
  | 'disposed' // a call on a disposed object
  | 'invalid-option' // an unknown name, or a value of the wrong type or range
  | 'crashed' // the worker trapped or ended unexpectedly
  | 'out-of-memory'
  | 'no-simd' // this browser's WebAssembly lacks SIMD
  | 'not-loaded'; // the worker's script or the wasm file could not be fetched or started

/** An error as plain data, for sending between workers. */
export interface ErrorData {
  code: string;
  message: string;
  place: ErrorPlace;
}

/** A failure. `code` is stable, `message` is a sentence for the user, `place` locates it in numbers. */
export class EngineError extends Error {
  override readonly name = 'EngineError';
  readonly code: string;
  readonly place: ErrorPlace;

  constructor(code: string, message: string, place: ErrorPlace = {}, cause?: unknown) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.place = place;
  }

  static from(data: ErrorData): EngineError {
    return new EngineError(data.code, data.message, data.place);
  }
}

/** Creates an error with a code checked by the compiler. */
export function engineError(code: EngineCode, message: string, cause?: unknown): EngineError {
  return new EngineError(code, message, {}, cause);
}

export function cancelled(): EngineError {
  return engineError('cancelled', 'The work was cancelled. Everything built before is unchanged.');
}

export function disposed(what: string): EngineError {
  return engineError('disposed', `This ${what} has been disposed of and can no longer be used.`);
}

export function crashed(reason: string): EngineError {
  return engineError(
    'crashed',
    `The computation stopped unexpectedly (${reason}). It restarts with the next step. ` +
      'If it stops again, use fewer keys or a mesh with fewer faces.',
  );
}

export function outOfMemory(): EngineError {
  return engineError(
    'out-of-memory',
    'There is not enough memory. Close other pages, or use fewer keys or a mesh with fewer faces.',
  );
}

export function notLoaded(what: string, reason: string, part = 'The computation'): EngineError {
  return engineError(
    'not-loaded',
    `${part} could not be loaded (${what}: ${reason}). Check the connection and reload the page.`,
  );
}

export function vertexCountMismatch(what: string, given: number, wanted: number, place?: ErrorPlace): EngineError {
  const count = (vertices: number): string => vertices.toLocaleString('en');
  const sentence = `${what} has ${count(given)} vertices, but the keys have ${count(wanted)}. Use a pose of the same mesh.`;
  return new EngineError('vertex-count-mismatch', sentence, place);
}

export function invalidOption(message: string): EngineError {
  return engineError('invalid-option', message);
}

/** Whether the work was cancelled, as opposed to failed. */
export function isCancelled(error: unknown): boolean {
  return error instanceof EngineError && (error.code === 'cancelled' || error.code === 'disposed');
}

/** The message of any thrown value. */
export function messageOf(reason: unknown): string {
  return reason instanceof Error ? reason.message : String(reason);
}

/** Whether a JavaScript engine's error text means out of memory; it differs between browsers and Emscripten. */
export function isOutOfMemory(text: string): boolean {
  return /out of memory|\bOOM\b|enlarge memory|allocation (failed|size)|could not allocate|ERR_WORKER_OUT_OF_MEMORY/i.test(
    text,
  );
}

/** The result of the work, or 'cancelled' as soon as the signal aborts; the work's later result is ignored. */
export function untilAborted<T>(signal: AbortSignal | undefined, work: Promise<T>): Promise<T> {
  if (!signal) return work;
  return new Promise<T>((resolve, reject) => {
    const abort = (): void => reject(cancelled());
    if (signal.aborted) abort();
    signal.addEventListener('abort', abort, { once: true });
    work.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
