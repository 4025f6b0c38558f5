import { getEventListeners } from 'node:events';
import { describe, expect, it } from 'vitest';
import { Scheduler, urgency, type Task } from '../../../web/engine/caller/scheduler.ts';

describe('the scheduler', () => {
  it('runs one task at a time, the most urgent first, and tasks of the same priority in order', async () => {
    const scheduler = new Scheduler();
    const begun: string[] = [];
    let running = 0;
    const task = (name: string) => async () => {
      begun.push(name);
      expect(++running).toBe(1);
      await new Promise((wake) => setTimeout(wake, 1));
      --running;
    };
    await Promise.all([
      scheduler.run(urgency.batch, task('first')),
      scheduler.run(urgency.batch, task('batch 1')),
      scheduler.run(urgency.batch, task('batch 2')),
      scheduler.run(urgency.ahead, task('ahead')),
      scheduler.run(urgency.shown, task('shown 1')),
      scheduler.run(urgency.shown, task('shown 2')),
    ]);
    expect(begun).toEqual(['first', 'shown 1', 'shown 2', 'ahead', 'batch 1', 'batch 2']);
  });

  it('does not let a task wait forever for more urgent ones', async () => {
    const scheduler = new Scheduler();
    let shown = 0;
    const frame = async (): Promise<void> => {
      shown += 1;
      await new Promise((wake) => setTimeout(wake));
    };
    const play = (): Promise<void> => scheduler.run(urgency.shown, frame).then(() => again());
    let over = false;
    const again = (): Promise<void> => (over ? Promise.resolve() : play());
    // Two tasks, so one is always waiting.
    const playing = [play(), play()];
    const before = await scheduler.run(urgency.batch, async () => shown);
    over = true;
    await Promise.all(playing);
    expect(before).toBeGreaterThan(1);
    expect(before).toBeLessThan(10);
  });

  it('continues after a failed task', async () => {
    const scheduler = new Scheduler();
    await expect(scheduler.run(urgency.shown, () => Promise.reject(new Error('no')))).rejects.toThrow('no');
    await expect(scheduler.run(urgency.shown, () => Promise.resolve(7))).resolves.toBe(7);
  });

  it('cancels tasks that have not started on a signal, and completes the others', async () => {
    const scheduler = new Scheduler();
    const abort = new AbortController();
    let started = 0;
    const run = (): Promise<number> => scheduler.run(urgency.ahead, async () => ++started, abort.signal);
    const first = run();
    const second = run();
    abort.abort();
    await expect(second).rejects.toMatchObject({ code: 'cancelled' });
    await expect(first).resolves.toBe(1);
    await expect(run()).rejects.toMatchObject({ code: 'cancelled' });
    expect(started).toBe(1);
  });

  it('leaves no listener on a signal that outlasts its tasks', async () => {
    const scheduler = new Scheduler();
    const { signal } = new AbortController();
    const tasks = [Promise.resolve(1), Promise.reject(new Error('no'))].map((work) =>
      scheduler.run(urgency.ahead, () => work, signal),
    );
    await Promise.allSettled(tasks);
    expect(getEventListeners(signal, 'abort')).toEqual([]);
  });

  it('cancels tasks that have not started', async () => {
    const scheduler = new Scheduler();
    let started = 0;
    const task = (): Task => ({ urgency: urgency.shown, start: async () => void ++started });
    const [first, second] = [task(), task()];
    scheduler.add(first);
    scheduler.add(second);
    expect(scheduler.withdraw(first)).toBe(false);
    expect(scheduler.withdraw(second)).toBe(true);
    await new Promise((wake) => setTimeout(wake, 1));
    expect(started).toBe(1);
  });
});
