/**
 * A worker that is started in the first of several ways that works. What is posted before its script has said that it
 * runs is kept, so that nothing is lost with a way that fails.
 */
import type { StartedWorker } from '../caller/browser-files.ts';
import type { Ready } from '../wire/protocol.ts';

export type Way = () => StartedWorker;

export class PatientWorker implements StartedWorker {
  onmessage: StartedWorker['onmessage'] = null;
  onmessageerror: StartedWorker['onmessageerror'] = null;
  onerror: StartedWorker['onerror'] = null;
  private readonly ways: Way[];
  private worker: StartedWorker | null = null;
  /** null once the script runs. */
  private waiting: Parameters<Worker['postMessage']>[] | null = [];
  private over = false;

  constructor(ways: Way[]) {
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
    this.worker?.terminate();
  }

  private start(): void {
    const way = this.ways.shift();
    try {
      this.worker = way?.() ?? null;
    } catch {
      return this.start(); // refused at once
    }
    // Whoever made this one has not yet said what is to be told of errors.
    if (!this.worker) return queueMicrotask(() => this.fail(new ErrorEvent('error')));
    const { worker } = this;
    worker.onmessage = (event: MessageEvent<Ready>) => {
      if (event.data.type === 'ready') this.begin();
      else this.onmessage?.call(worker as Worker, event);
    };
    worker.onmessageerror = (event) => this.onmessageerror?.call(worker as Worker, event);
    worker.onerror = (event) => {
      if (!this.waiting) return this.fail(event);
      event.preventDefault();
      worker.terminate();
      if (!this.over) this.start();
    };
  }

  private begin(): void {
    const calls = this.waiting ?? [];
    this.waiting = null;
    for (const call of calls) this.worker?.postMessage(...call);
  }

  private fail(event: ErrorEvent): void {
    if (!this.over) this.onerror?.call(this.worker as Worker, event);
  }
}
