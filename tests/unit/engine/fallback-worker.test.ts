/** A worker is started by the first method that works; a silent start counts as failed. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { StartedWorker } from '../../../web/engine/caller/browser-files.ts';
import { FallbackWorker, type StartMethod } from '../../../web/engine/caller/fallback-worker.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

class Script implements StartedWorker {
  onmessage: StartedWorker['onmessage'] = null;
  onmessageerror: StartedWorker['onmessageerror'] = null;
  onerror: StartedWorker['onerror'] = null;
  readonly got: unknown[] = [];
  ended = false;
  postMessage(message: unknown): void {
    structuredClone(message);
    this.got.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  say(data: unknown): void {
    this.onmessage?.call(this as never, { data } as MessageEvent);
  }
  fail(message = ''): void {
    this.onerror?.call(this as never, { message, preventDefault: () => undefined } as ErrorEvent);
  }
}

function setUp(methods: number, loaded: Promise<unknown> = Promise.resolve()) {
  const scripts: Script[] = [];
  const method: StartMethod = () => scripts[scripts.push(new Script()) - 1]!;
  const worker = new FallbackWorker(Array<StartMethod>(methods).fill(method), loaded);
  const heard: unknown[] = [];
  const errors: ErrorEvent[] = [];
  worker.onmessage = ({ data }: MessageEvent) => void heard.push(data);
  worker.onerror = (event) => void errors.push(event);
  return { worker, scripts, heard, errors };
}

it('no message is lost if a method fails', async () => {
  const { worker, scripts, heard, errors } = setUp(2);
  worker.postMessage('first');
  expect(scripts[0]!.got).toEqual([]);
  scripts[0]!.fail();
  expect([scripts[0]!.ended, scripts[1]!.got]).toEqual([true, ['first']]);
  scripts[1]!.say({ type: 'ready' });
  worker.postMessage('second');
  scripts[1]!.say({ type: 'result' });
  await vi.advanceTimersByTimeAsync(600_000);
  expect([scripts[1]!.got, heard, errors]).toEqual([['first', 'second'], [{ type: 'result' }], []]);
  expect(worker.silent).toBe(false);
});

it('a waiting message that cannot be posted is answered with an error, and the others are posted', () => {
  const { worker, scripts, heard } = setUp(2);
  const bytes = new Uint8Array(3);
  for (const [id, data] of [bytes, 'good'].entries()) worker.postMessage({ type: 'import', id, data });
  const torn = { type: 'import', id: 2, data: () => 0 };
  worker.postMessage(torn);
  structuredClone(bytes.buffer, { transfer: [bytes.buffer] });
  scripts[0]!.say({ type: 'ready' });
  expect(heard).toMatchObject(
    [0, 2].map((id) => ({ type: 'error', id, fatal: false, error: { code: 'invalid-option' } })),
  );
  expect(scripts[0]!.got).toEqual([{ type: 'import', id: 1, data: 'good' }]);
});

it('a script that cannot be sent its program has failed', () => {
  const { worker, scripts, heard } = setUp(2);
  worker.postMessage({ type: 'start', module: () => 0 });
  scripts[0]!.say({ type: 'ready' });
  expect(heard).toMatchObject([{ type: 'error', fatal: true, error: { code: 'crashed' } }]);
});

it('silence is a failure of one method, then of all', async () => {
  const { worker, scripts, errors } = setUp(2);
  await vi.advanceTimersByTimeAsync(40_000);
  expect([scripts.length, scripts[0]!.ended, errors]).toEqual([2, true, []]);
  await vi.advanceTimersByTimeAsync(40_000);
  expect([scripts[1]!.ended, errors.length, errors[0]!.message, worker.silent]).toEqual([true, 1, '', true]);
});

it('the time limit starts once the page has loaded, and ends with the first message', async () => {
  let loaded: () => void = () => undefined;
  const { scripts, errors } = setUp(1, new Promise<void>((resolve) => (loaded = resolve)));
  await vi.advanceTimersByTimeAsync(600_000);
  loaded();
  await vi.advanceTimersByTimeAsync(20_000);
  scripts[0]!.say({ type: 'ready' });
  // Work has no time limit after this.
  await vi.advanceTimersByTimeAsync(3_600_000);
  expect([scripts[0]!.ended, errors]).toEqual([false, []]);
});

it('reports later that every method was refused, without a DOM', async () => {
  const errors: unknown[] = [];
  const refused: StartMethod = () => {
    throw new Error('refused');
  };
  const worker = new FallbackWorker([refused, refused], Promise.resolve());
  worker.onerror = (event) => void errors.push(event);
  await vi.advanceTimersByTimeAsync(100);
  expect(errors).toMatchObject([{ message: '' }]);
});

it('a terminated worker reports nothing', async () => {
  const { worker, errors, scripts } = setUp(1);
  worker.terminate();
  await vi.advanceTimersByTimeAsync(600_000);
  expect([errors, scripts[0]!.ended]).toEqual([[], true]);
});
