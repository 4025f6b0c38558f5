/** The fit of the timing finds the timing of a motion that has one. */
import { expect, it } from 'vitest';
import { fitTiming } from '../../web/study/timing-fit.ts';
import { bendKeys, testEngine } from './support/engines.ts';

const engine = testEngine();
const KEYS = [0, 0.5, 1];

/** Frames of the bend with this timing, and its shape. */
async function timedBend(timing: { earlier: number[]; swing: number[] }, times: number[]) {
  const { keys } = await bendKeys(engine);
  const shape = await engine.encode(keys);
  const motion = await shape.motion({ ...timing, keyTimes: KEYS });
  const shapes = (await motion.evaluateMany(times)).map((frame) => frame.positions.slice());
  motion.dispose();
  return { shape, animation: { times, frame: (index: number) => shapes[index]! } };
}

const evenly = Array.from({ length: 21 }, (_, i) => i / 20);

it('finds the numbers of a timed motion, and lowers the error on unseen frames', async () => {
  const { shape, animation } = await timedBend({ earlier: [0.2, -0.1, 0], swing: [0, 0.5, 0] }, evenly);
  const fit = (await fitTiming({ shape, options: { keyTimes: KEYS }, animation }, KEYS))!;
  expect(fit.unseen!.after).toBeLessThan(0.4 * fit.unseen!.before);
  expect(fit.unseen!.frames).toBe(8);
  // Nearly even motion hardly tells both numbers apart, so the ridge lowers them.
  expect(fit.earlier[0]).toBeGreaterThan(0.12);
  expect(fit.earlier[1]).toBeLessThan(-0.05);
  expect(fit.earlier[2]).toBe(0);
  shape.dispose();
});

it('finds none in the plain motion, and needs frames between the keys', async () => {
  const { shape, animation } = await timedBend({ earlier: [], swing: [] }, evenly);
  const fit = (await fitTiming({ shape, options: { keyTimes: KEYS }, animation }, KEYS))!;
  for (const value of [...fit.earlier, ...fit.swing]) expect(Math.abs(value)).toBeLessThan(0.01);
  const keys = { times: KEYS, frame: animation.frame };
  expect(await fitTiming({ shape, options: { keyTimes: KEYS }, animation: keys }, KEYS)).toBeNull();
  const stop = new AbortController();
  stop.abort();
  await expect(
    fitTiming({ shape, options: { keyTimes: KEYS }, animation }, KEYS, { signal: stop.signal }),
  ).rejects.toThrow();
  shape.dispose();
});
