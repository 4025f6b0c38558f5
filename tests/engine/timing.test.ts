/** Timing of the intervals between keys, as the engine computes it. */
import { expect, it } from 'vitest';
import type { MotionOptions } from '../../web/engine/api/types.ts';
import { bendSequence, frameAt, testEngine } from './support/engines.ts';
import { diagonal, largestDistance } from './support/shapes.ts';

const engine = testEngine();
const TIMES = [-0.3, 0, 0.13, 0.25, 0.37, 0.5, 0.7, 0.9, 1, 1.4];

async function framesOf(change: Partial<MotionOptions>): Promise<Float32Array[]> {
  const { sequence } = await bendSequence(engine, change);
  const frames: Float32Array[] = [];
  for (const t of TIMES) frames.push((await frameAt(sequence, t)).positions);
  sequence.dispose();
  return frames;
}

it('0 is the plain motion bit for bit; other values keep the keys and the motion beyond them', async () => {
  const plain = await framesOf({});
  expect(await framesOf({ earlier: [0, 0, 0], swing: [0, 0, 0] })).toEqual(plain);
  const size = diagonal(plain[1]!);
  for (const change of [{ earlier: [0.3, -0.2, 0] }, { swing: [-1, 1.5, 0] }]) {
    const timed = await framesOf(change);
    TIMES.forEach((t, i) => {
      const moved = largestDistance(timed[i]!, plain[i]!) / size;
      if (t < 0 || t > 1) expect(timed[i], `at ${t}`).toEqual(plain[i]);
      else if ([0, 0.5, 1].includes(t)) expect(moved, `at ${t}`).toBeLessThan(1e-6);
      else expect(moved, `at ${t}`).toBeGreaterThan(1e-3);
    });
  }
});

it('other methods refuse it, and an inherited value is left out', async () => {
  const { sequence, keys } = await bendSequence(engine, { earlier: [0.2, 0, 0] });
  await expect(engine.createSequence(keys, { method: 'shell', earlier: [0.2, 0, 0] })).rejects.toThrow(
    "The method 'shell' does not support timing. Use the method 'lri'.",
  );
  await sequence.update({ method: 'linear' });
  expect(sequence.options.earlier).toEqual([]);
  sequence.dispose();
});
