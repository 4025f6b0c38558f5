/**
 * Starts a worker by the first method that works. Messages are kept until the script reports that it runs, so no failed
 * start loses any. A silent script counts as failed.
 */
import type { StartedWorker } from './browser-files.ts';
import type { Ready, ToWorker } from '../wire/protocol.ts';
import { notPosted } from './worker-client.ts';

export type StartMethod = () => StartedWorker;

const REPORT_MS = 50;
/**
 * Longest silence of a script after the rest of the engine, which is larger, has loaded. Counted in steps, because a
 * machine wakes from sleep with one overdue timer.
 */
const SILENT_STEPS = 6;
const STEP_MS = 5000;
/** An error without a message means that no script has run. */
const NOT_STARTED = { message: '', preventDefault: () => undefined } as unknown as ErrorEvent;

export class FallbackWorker implements StartedWorker {
  onmessage: StartedWorker['onmessage'] = null;
  onmessageerror: StartedWorker['onmessageerror'] = null;
  onerror: StartedWorker['onerror'] = null;
  /** The script of the last method sent no message. */
  silent = false;
  private readonly methods: StartMethod[];
  private worker: StartedWorker | null = null;
  /** null once the script runs, or if no other method can send the messages. */
  private waiting: Parameters<Worker['postMessage']>[] | null = [];
  private running = false;
  private over = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `loaded` settles when the rest of the engine has loaded. */
  constructor(
    methods: StartMethod[],
    private readonly loaded: Promise<unknown>,
  ) {
    this.methods = [...methods];
    this.start();
  }

  postMessage(message: unknown, transfer: Transferable[] | StructuredSerializeOptions = []): void {
    const call = [message, transfer] as Parameters<Worker['postMessage']>;
    if (this.waiting) this.waiting.push(call);
    else this.worker?.postMessage(...call);
  }

  terminate(): void {
    this.over = true;
    clearTimeout(this.timer);
    this.worker?.terminate();
  }

  private start(): void {
    const method = this.methods.shift();
    try {
      this.worker = method?.() ?? null;
    } catch {
      return this.start(); // the browser refused it immediately
    }
    // The caller has to set its handlers first, and the browser has to report a policy violation first.
    if (!this.worker) return void setTimeout(() => this.fail(NOT_STARTED), REPORT_MS);
    const { worker } = this;
    worker.onmessage = (event: MessageEvent<Ready>) => {
      if (!this.running) this.begin();
      if (event.data.type !== 'ready') this.onmessage?.call(worker as Worker, event);
    };
    worker.onmessageerror = (event) => this.onmessageerror?.call(worker as Worker, event);
    worker.onerror = (event) => {
      if (this.running) return this.fail(event);
      event.preventDefault();
      this.startNext(event);
    };
    this.silent = false;
    const limit = (): void => this.limitSilence(worker, SILENT_STEPS);
    this.loaded.then(limit, limit);
    if (this.methods.length === 0) this.post();
  }

  /** Tries the next method, if any. */
  private startNext(event: ErrorEvent): void {
    clearTimeout(this.timer);
    this.worker?.terminate();
    if (this.over) return;
    if (this.waiting) this.start();
    else this.fail(event);
  }

  private limitSilence(worker: StartedWorker, steps: number): void {
    if (this.running || this.over || worker !== this.worker) return;
    if (steps > 0) {
      this.timer = setTimeout(() => this.limitSilence(worker, steps - 1), STEP_MS);
      return;
    }
    this.silent = true;
    this.startNext(NOT_STARTED);
  }

  private begin(): void {
    this.running = true;
    clearTimeout(this.timer);
    this.post();
  }

  private post(): void {
    const calls = this.waiting ?? [];
    this.waiting = null;
    for (const [message, transfer] of calls)
      try {
        this.worker?.postMessage(message, transfer as Transferable[]);
      } catch (error) {
        // Its caller has returned, so the error becomes the worker's reply.
        const data = notPosted(message as ToWorker, error);
        this.onmessage?.call(this.worker as Worker, { data } as MessageEvent);
      }
  }

  private fail(event: ErrorEvent): void {
    if (!this.over) this.onerror?.call(this.worker as Worker, event);
  }
}
