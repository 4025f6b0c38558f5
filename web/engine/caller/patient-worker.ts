/**
 * A worker that is started in the first way that works. Messages are kept until its script reports that it runs, so
 * none is lost to a way that fails. A silent script has failed as well.
 */
import type { StartedWorker } from './browser-files.ts';
import type { Ready } from '../wire/protocol.ts';

export type Way = () => StartedWorker;

const REPORT_MS = 50;
/**
 * How long a script may stay silent after the rest of the engine, which is larger, has loaded. Counted in steps,
 * because a machine wakes from sleep with one timer overdue.
 */
const SILENT_STEPS = 6;
const STEP_MS = 5000;
/** Without a message: no script has run. */
const NOT_STARTED = { message: '', preventDefault: () => undefined } as unknown as ErrorEvent;

export class PatientWorker implements StartedWorker {
  onmessage: StartedWorker['onmessage'] = null;
  onmessageerror: StartedWorker['onmessageerror'] = null;
  onerror: StartedWorker['onerror'] = null;
  /** The last way that was tried ran into silence. */
  silent = false;
  private readonly ways: Way[];
  private worker: StartedWorker | null = null;
  /** null once the script runs, or without another way to send the messages. */
  private waiting: Parameters<Worker['postMessage']>[] | null = [];
  private running = false;
  private over = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** `loaded` settles when the rest has loaded. */
  constructor(
    ways: Way[],
    private readonly loaded: Promise<unknown>,
  ) {
    this.ways = [...ways];
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
    const way = this.ways.shift();
    try {
      this.worker = way?.() ?? null;
    } catch {
      return this.start(); // refused at once
    }
    // The caller must still set its handlers, and the browser must still report a policy violation.
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
    if (this.ways.length === 0) this.post();
  }

  /** Another way, if there is one. */
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
    for (const call of calls) this.worker?.postMessage(...call);
  }

  private fail(event: ErrorEvent): void {
    if (!this.over) this.onerror?.call(this.worker as Worker, event);
  }
}
