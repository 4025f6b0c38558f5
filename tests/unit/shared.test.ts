/** Objects shared by the elements of a page. */
import { beforeEach, expect, it, vi } from 'vitest';
import { Shared } from '../../web/embed/shared.ts';
import type { Lease } from '../../web/embed/shared.ts';

interface Thing {
  name: string;
}

const GRACE_MS = 1000;
let made: string[];
let ended: string[];
let things: Shared<Thing>;

beforeEach(() => {
  vi.useFakeTimers();
  [made, ended] = [[], []];
  things = new Shared<Thing>((thing) => void ended.push(thing.name), GRACE_MS);
  return () => void vi.useRealTimers();
});

const take = (key: string): Lease<Thing> =>
  things.take(key, async () => {
    made.push(key);
    return { name: key };
  });
it('is made once, and disposed of some time after its last user is removed', async () => {
  const [a, b] = [take('x'), take('x')];
  expect(await a.value).toBe(await b.value);
  expect(made).toEqual(['x']);
  a.release();
  a.release();
  await vi.advanceTimersByTimeAsync(2 * GRACE_MS);
  expect(ended).toEqual([]);
  b.release();
  take('x').release();
  await vi.advanceTimersByTimeAsync(GRACE_MS + 1);
  expect(ended).toEqual(['x']);
  expect(made).toEqual(['x']);
});

it('is cancelled if its last user is removed during its making, and not cached if making fails', async () => {
  const signals: AbortSignal[] = [];
  const slow = things.take('x', async ({ signal }) => {
    signals.push(signal);
    await new Promise((resolve) => setTimeout(resolve, 3 * GRACE_MS));
    return { name: 'x' };
  });
  slow.release();
  await vi.advanceTimersByTimeAsync(5 * GRACE_MS);
  expect([signals[0]!.aborted, ended, things.size]).toEqual([true, ['x'], 0]);
  const failed = things.take('y', () => Promise.reject(new Error('no such')));
  await expect(failed.value).rejects.toThrow('no such');
  expect((await take('y').value).name).toBe('y');
});
