/** Long playback: what stays behind on a signal that lasts as long as it. */
import { getEventListeners } from 'node:events';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect, it } from 'vitest';
import { bendSequence, testEngine } from './support/engines.ts';

setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc') as () => void;

function heap(): number {
  for (let i = 0; i < 3; ++i) collect();
  return process.memoryUsage().heapUsed;
}

it('10,000 frames on one signal leave no listener and no memory', { timeout: 120_000 }, async () => {
  const { sequence } = await bendSequence(testEngine());
  const { signal } = new AbortController();
  const play = async (frames: number): Promise<void> => {
    for (let i = 0; i < frames; ++i) (await sequence.evaluateAhead((i % 100) / 100, { signal })).release();
  };
  await play(1000);
  const before = heap();
  await play(10_000);
  expect(getEventListeners(signal, 'abort')).toEqual([]);
  expect(heap() - before).toBeLessThan(1e6);
});
