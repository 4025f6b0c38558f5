/** What the elements of a page share, and how one that nobody else stays with becomes another. */
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
const leave = (lease: Lease<Thing>): void => {
  lease.leaving = true;
};
const renamed = (name: string) => async (thing: Thing) => {
  thing.name = name;
};

it('is made once, and ended a while after its last user has left', async () => {
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

it('becomes another one where nobody stays with it', async () => {
  const a = take('x');
  const thing = await a.value;
  expect(things.change([a], 'y', renamed('y'))).toBeNull();
  leave(a);
  const next = things.change([a], 'y', renamed('y'))!;
  expect(await next.value).toBe(thing);
  a.release();
  expect([things.has('x'), things.has('y')]).toEqual([false, true]);
  expect(await take('y').value).toBe(thing);
  expect(made).toEqual(['x']);
  await vi.advanceTimersByTimeAsync(2 * GRACE_MS);
  expect(ended).toEqual([]);
});

it('stays where another user does, and changes where all of them leave', async () => {
  const [a, b] = [take('x'), take('x')];
  await a.value;
  leave(a);
  expect(things.change([a], 'y', renamed('y'))).toBeNull();
  leave(b);
  expect(things.change([], 'y', renamed('y'))).toBeNull();
  const next = things.change([a], 'y', renamed('y'))!;
  expect((await next.value).name).toBe('y');
  expect(made).toEqual(['x']);
});

it('is what it was where the change fails, for whoever stays', async () => {
  const a = take('x');
  const thing = await a.value;
  leave(a);
  const next = things.change([a], 'y', () => Promise.reject(new Error('no such')))!;
  const other = take('y');
  await expect(next.value).rejects.toThrow('no such');
  await expect(other.value).rejects.toThrow('no such');
  next.release();
  other.release();
  expect([things.has('x'), things.has('y')]).toEqual([true, false]);
  expect(await take('x').value).toBe(thing);
  expect(made).toEqual(['x']);
});

it('ends once, also when its last user leaves while it changes or after a change failed', async () => {
  const a = take('x');
  await a.value;
  leave(a);
  const next = things.change([a], 'y', () => new Promise((_, fail) => setTimeout(fail, 3 * GRACE_MS)))!;
  next.value.catch(() => undefined);
  a.release();
  next.release();
  await vi.advanceTimersByTimeAsync(5 * GRACE_MS);
  expect(ended).toEqual(['x']);
  expect(things.size).toBe(0);
});
