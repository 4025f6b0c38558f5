/** The fit of the timing finds the timing of a motion that has one. */
import { expect, it } from 'vitest';
import type { CallOptions } from '../../web/engine/api/api.ts';
import type { TimingRegion, Timings } from '../../web/engine/api/types.ts';
import { bendKeys, testEngine } from './support/engines.ts';

const engine = testEngine();
const KEYS = [0, 0.5, 1];
const evenly = Array.from({ length: 21 }, (_, i) => i / 20);

/** A shape, and frames of its motion with these timings. */
async function timedBend(timings: Partial<Timings>, times = evenly) {
  const { keys } = await bendKeys(engine);
  const shape = await engine.encode(keys);
  const motion = await shape.motion({ ...timings, keyTimes: KEYS });
  const shapes = (await motion.evaluateMany(times)).map((frame) => frame.positions.slice());
  motion.dispose();
  const animation = { times, at: (index: number) => shapes[index]! };
  const plain = await shape.motion({ keyTimes: KEYS, pins: [] });
  const fitOf = (regions: number, at = times, call?: CallOptions) =>
    engine.fitTiming(plain, { ...animation, times: at }, { regions }, call);
  return { shape, fitOf };
}

it('finds the numbers of a timed motion, and lowers the error on unseen frames', async () => {
  const { shape, fitOf } = await timedBend({ earlier: [0.2, -0.1, 0], swing: [0, 0.5, 0] });
  const { timings, unseen } = (await fitOf(1))!;
  expect(unseen!.after).toBeLessThan(0.4 * unseen!.before);
  expect(unseen!.frames).toBe(14);
  // Nearly even motion hardly tells both numbers apart, so the ridge lowers them.
  expect(timings.earlier[0]).toBeGreaterThan(0.12);
  expect(timings.earlier[1]).toBeLessThan(-0.05);
  expect(timings.earlier[2]).toBe(0);
  // The position moves with the shape in this motion.
  expect(timings.regions).toHaveLength(1);
  expect(timings.regions[0]!.faces).toEqual([]);
  shape.dispose();
});

it('finds the timings of two halves with regions, where one for the whole cannot', async () => {
  const { keys } = await bendKeys(engine);
  const half = keys.info.faces.length / 6;
  const late: TimingRegion = { faces: [0, Math.floor(half)], earlier: [-0.3, -0.3, 0], swing: [], soft: false };
  const { shape, fitOf } = await timedBend({ earlier: [0.3, 0.3, 0], regions: [late] });
  const whole = (await fitOf(1))!.unseen!;
  const { timings, unseen } = (await fitOf(8))!;
  expect(unseen!.before).toBe(whole.before);
  expect(unseen!.after).toBeLessThan(0.8 * whole.after);
  expect(timings.earlier).toEqual([]);
  expect(timings.regions.length).toBeGreaterThan(3);
  // Every face is in one region.
  const faces = timings.regions.flatMap(({ faces: runs }) => runs.filter((_, i) => i % 2 === 1));
  expect(faces.reduce((sum, count) => sum + count, 0)).toBe(keys.info.faces.length / 3);
  shape.dispose();
});

it('finds none in the plain motion, and needs frames between the keys', async () => {
  const { shape, fitOf } = await timedBend({});
  const { timings } = (await fitOf(1))!;
  for (const value of [...timings.earlier, ...timings.swing]) expect(Math.abs(value)).toBeLessThan(0.01);
  expect(await fitOf(1, KEYS)).toBeNull();
  const stop = new AbortController();
  stop.abort();
  await expect(fitOf(1, evenly, { signal: stop.signal })).rejects.toMatchObject({ code: 'cancelled' });
  await expect(fitOf(0)).rejects.toThrow('from 1 to 64, not 0');
  const linear = await shape.motion({ method: 'linear' });
  await expect(engine.fitTiming(linear, { times: evenly, at: () => new Float32Array() })).rejects.toThrow("'lri' only");
  shape.dispose();
});
