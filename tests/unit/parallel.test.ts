import { describe, expect, it } from 'vitest';
import { rangesOf } from '../../wasm/toolchain/doctest.mjs';
import { inParallel } from '../../wasm/toolchain/parallel.mjs';

describe('ranges of test cases', () => {
  it.each([
    [343, 6],
    [6, 6],
    [5, 6],
    [1, 4],
  ])('of %i in %i parts hold each once', (count, parts) => {
    const ranges = rangesOf(count, parts);
    const numbers = ranges.flatMap(({ first, last }) => Array.from({ length: last - first + 1 }, (_, i) => first + i));
    expect(numbers).toEqual(Array.from({ length: count }, (_, i) => i + 1));
    expect(ranges.length).toBe(Math.min(count, parts));
  });

  it('of none are none', () => expect(rangesOf(0, 6)).toEqual([]));
});

describe('tasks in parallel', () => {
  it('return what they return, in their order, never more at once than asked for', async () => {
    let running = 0;
    let most = 0;
    const task = (value: number) => async () => {
      most = Math.max(most, ++running);
      for (let turn = 0; turn < 10 - value; ++turn) await Promise.resolve();
      --running;
      return value;
    };
    expect(await inParallel([1, 2, 3, 4, 5].map(task), 2)).toEqual([1, 2, 3, 4, 5]);
    expect(most).toBe(2);
  });

  it('all end before the first failure is thrown', async () => {
    const ended: string[] = [];
    const tasks = ['a', 'b', 'c'].map((name) => async () => {
      await Promise.resolve();
      ended.push(name);
      if (name !== 'c') throw new Error(name);
    });
    await expect(inParallel(tasks, 2)).rejects.toThrow('a');
    expect(ended).toEqual(['a', 'b', 'c']);
  });
});
