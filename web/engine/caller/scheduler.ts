/**
 * Sends one request at a time to a sequence's worker, the most urgent first. A visible frame does not wait for frames
 * fetched ahead or for an export. A request that was passed often enough goes next, so playback on a slow worker does
 * not block the plots.
 */
import { cancelled } from '../api/errors.ts';

/** Urgency of a request. Lower values go first, equal ones in order of arrival. */
export const urgency = { shown: 0, ahead: 1, batch: 2 } as const;
export type Urgency = (typeof urgency)[keyof typeof urgency];

export interface Task {
  urgency: Urgency;
  start(): Promise<unknown>;
}

/** Number of more urgent tasks that can pass a waiting one. */
const MAX_PASSED = 4;

export class Scheduler {
  private waiting: Task[] = [];
  /** The number of tasks that have passed each waiting task. */
  private readonly passed = new WeakMap<Task, number>();
  private busy = false;

  /**
   * Returns the task's own promise. The task starts once all more urgent tasks have run; until then the signal can
   * withdraw it.
   */
  run<T>(level: Urgency, work: () => Promise<T>, signal?: AbortSignal): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      if (signal?.aborted) return reject(cancelled());
      const withdraw = (): void => {
        if (this.withdraw(task)) reject(cancelled());
      };
      const start = (): Promise<void> => {
        signal?.removeEventListener('abort', withdraw); // one signal may last for a whole playback
        return work().then(resolve, reject);
      };
      const task: Task = { urgency: level, start };
      signal?.addEventListener('abort', withdraw, { once: true });
      this.add(task);
    });
  }

  add(task: Task): void {
    const place = this.waiting.findIndex((other) => other.urgency > task.urgency);
    this.waiting.splice(place < 0 ? this.waiting.length : place, 0, task);
    this.next();
  }

  /** Withdraws a task; false if it has started. */
  withdraw(task: Task): boolean {
    const place = this.waiting.indexOf(task);
    if (place >= 0) this.waiting.splice(place, 1);
    return place >= 0;
  }

  private next(): void {
    if (this.busy) return;
    const late = this.waiting.findIndex((task) => this.passedBy(task) >= MAX_PASSED);
    const [task] = this.waiting.splice(Math.max(late, 0), 1);
    if (!task) return;
    for (const other of this.waiting)
      if (other.urgency > task.urgency) this.passed.set(other, this.passedBy(other) + 1);
    this.busy = true;
    void task.start().finally(() => {
      this.busy = false;
      this.next();
    });
  }

  private passedBy(task: Task): number {
    return this.passed.get(task) ?? 0;
  }
}
