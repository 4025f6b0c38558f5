/** The caller's side of one worker. Calls become promises, and the worker's end rejects all open ones. */
import { crashed, EngineError, invalidOption, isOutOfMemory, messageOf, outOfMemory } from '../api/errors.ts';
import type {
  CallName,
  CoreCallName,
  FileCallName,
  FromWorker,
  Program,
  RequestOf,
  ResultOf,
  ShellCallName,
  ToWorker,
} from '../wire/protocol.ts';
import type { Progress } from '../api/types.ts';

/** Common interface of browser and Node workers. */
export interface WorkerPort {
  post(message: ToWorker, transfer: Transferable[]): void;
  terminate(): void;
}

export interface PortEvents {
  message(message: FromWorker): void;
  /** The worker ended or failed to start. */
  failure(error: EngineError): void;
}

/** Starts a worker. */
export type Spawn = (events: PortEvents) => WorkerPort;

export interface WorkerCall {
  transfer?: Transferable[];
  onProgress?: ((progress: Progress) => void) | undefined;
}

interface Open {
  resolve(value: unknown): void;
  reject(error: EngineError): void;
  onProgress: ((progress: Progress) => void) | undefined;
  fraction: number;
}

export type CoreWorker = WorkerClient<CoreCallName>;
export type FilesWorker = WorkerClient<FileCallName>;
export type ShellsWorker = WorkerClient<ShellCallName>;

export class WorkerClient<Name extends CallName> {
  private readonly open = new Map<number, Open>();
  private readonly port: WorkerPort;
  private readonly started: Promise<void>;
  private lastId = 0;
  private ended: EngineError | null = null;

  constructor(spawn: Spawn, program: Promise<Program>) {
    this.port = spawn({
      message: (message) => this.receive(message),
      failure: (error) => this.terminate(error),
    });
    this.started = program.then(
      (given) => this.post({ type: 'start', ...given }, []),
      (error: EngineError) => this.terminate(error),
    );
  }

  get alive(): boolean {
    return this.ended === null;
  }

  call<K extends Name>(
    type: K,
    request: RequestOf<K>,
    { transfer, onProgress }: WorkerCall = {},
  ): Promise<ResultOf<K>> {
    if (this.ended) return Promise.reject(this.ended);
    const id = ++this.lastId;
    return new Promise<ResultOf<K>>((resolve, reject) => {
      this.open.set(id, { resolve: resolve as (value: unknown) => void, reject, onProgress, fraction: 0 });
      // TypeScript cannot form the union of all requests from a generic K without this assertion.
      const message = { ...request, type, id } as unknown as ToWorker;
      void this.started.then(() => this.post(message, transfer ?? []));
    });
  }

  /** Ends the worker and rejects its open requests. Idempotent. */
  terminate(reason: EngineError): void {
    if (this.ended) return;
    this.ended = reason;
    this.port.terminate();
    const open = [...this.open.values()];
    this.open.clear();
    for (const call of open) call.reject(reason);
  }

  private post(message: ToWorker, transfer: Transferable[]): void {
    if (this.ended) return;
    try {
      this.port.post(message, transfer);
    } catch (error) {
      this.receive(notPosted(message, error));
    }
  }

  private receive(message: FromWorker): void {
    const call = this.open.get(message.id);
    if (message.type === 'progress') return void (call && this.report(call, message.stage, message.fraction));
    this.open.delete(message.id);
    if (message.type === 'result') return call?.resolve(message.value);
    const error = EngineError.from(message.error);
    if (message.fatal) this.terminate(error);
    call?.reject(error);
  }

  private report(call: Open, stage: string, fraction: number): void {
    call.fraction = Math.min(1, Math.max(call.fraction, fraction));
    call.onProgress?.({ stage, fraction: call.fraction });
  }
}

/**
 * The reply to a message that could not be posted: its clone exceeds the memory, or an array was transferred elsewhere.
 * The worker goes on with other messages, unless this one was to start it.
 */
export function notPosted(message: ToWorker, reason: unknown): FromWorker {
  if (message.type === 'start') return { type: 'error', id: 0, error: endedWorker(reason), fatal: true };
  const text = messageOf(reason);
  const error = isOutOfMemory(text)
    ? outOfMemory()
    : invalidOption(
        `The data could not be sent to the worker (${text}). Do not transfer arrays while a call uses them.`,
      );
  return { type: 'error', id: message.id, error, fatal: false };
}

/** The error after a worker has ended unexpectedly. */
export function endedWorker(reason: unknown): EngineError {
  const text = messageOf(reason);
  return isOutOfMemory(text) ? outOfMemory() : crashed(text);
}
