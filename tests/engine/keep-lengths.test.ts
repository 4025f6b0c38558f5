/** Motions of the method `lri` through shapes that keep lengths: measures, unsupported options, keys in warnings. */
import { describe, expect, it } from 'vitest';
import type { Keys, Motion } from '../../web/engine/api/api.ts';
import { failureOf, frameAt, testEngine } from './support/engines.ts';
import { bar, largestDistance, moved, rolledSheet, split } from './support/shapes.ts';

const engine = testEngine();

const sheet = (n: number): Promise<Keys> => keysOf(rolledSheet(n, 3.5));

async function keysOf({ faces, poses }: ReturnType<typeof rolledSheet>): Promise<Keys> {
  return engine.createKeys({ faces, poses: poses.map((positions, i) => ({ name: `${i}`, time: i, positions })) });
}

/** Lengths of the sides of all faces. */
function lengthsOf(faces: Uint32Array, positions: Float32Array): number[] {
  return [...faces].map((a, i) => {
    const b = faces[i % 3 === 2 ? i - 2 : i + 1]!;
    return Math.hypot(...[0, 1, 2].map((axis) => positions[3 * a + axis]! - positions[3 * b + axis]!));
  });
}

/** Largest deviation of the area, and deviation of the lengths (rms), from those between two keys. In percent. */
async function deviations(motion: Motion, keys: Keys): Promise<{ area: number; lengths: number }> {
  const [from, to] = [0, 1].map((key) => lengthsOf(keys.info.faces, keys.positions(key))) as [number[], number[]];
  const times = Array.from({ length: 49 }, (_, i) => i / 48);
  const { area } = await motion.measures(times);
  let sum = 0;
  for (const t of times) {
    const found = lengthsOf(keys.info.faces, (await frameAt(motion, t)).positions);
    for (const [i, length] of found.entries()) sum += (length / ((1 - t) * from[i]! + t * to[i]!) - 1) ** 2;
  }
  const wanted = (t: number): number => (1 - t) * area[0]! + t * area.at(-1)!;
  return {
    area: 100 * Math.max(...area.map((one, i) => Math.abs(one / wanted(times[i]!) - 1))),
    lengths: 100 * Math.sqrt(sum / times.length / from.length),
  };
}

it('too many keys are refused with their own number before any shape is fitted', async () => {
  const { faces, poses } = rolledSheet(2, 1);
  const many = Array.from({ length: 1000 }, (_, i) => ({ name: `${i}`, time: i, positions: poses[i % 2]! }));
  const keys = await engine.createKeys({ faces, poses: many });
  const stages = new Set<string>();
  const onProgress = ({ stage }: { stage: string }): void => void stages.add(stage);
  const failure = await failureOf(engine.createSequence(keys, { keepLengths: 3 }, { onProgress }));
  expect([failure.code, failure.message]).toEqual([
    'too-large',
    'With keepLengths 3, 1,000 keys need 2,997 shapes between them, but a motion can have at most 2,000 keys and ' +
      'shapes in all. Set keepLengths to 1, or use at most 500 keys.',
  ]);
  expect([...stages]).toEqual(['welding']);
});

describe('kept lengths', () => {
  it('keep the lengths and the area of a sheet, pass through the keys, and are pure', async () => {
    const keys = await sheet(14);
    const plain = await engine.createSequence(keys);
    const before = await deviations(plain, keys);
    expect(before.lengths).toBeGreaterThan(1);
    for (const keepLengths of [1, 3]) {
      const sequence = await engine.createSequence(keys, { keepLengths });
      for (const key of [0, 1])
        expect(largestDistance((await frameAt(sequence, key)).positions, keys.positions(key))).toBeLessThan(1e-5);
      const { area, lengths } = await deviations(sequence, keys);
      expect(lengths).toBeLessThan(before.lengths / 3);
      expect(area).toBeLessThan(before.area / 3);
      const first = (await frameAt(sequence, 0.37)).positions.slice();
      await frameAt(sequence, 1.4);
      expect((await frameAt(sequence, 0.37)).positions).toEqual(first);
      expect(sequence.keyTimes).toEqual([0, 1]);
      expect(sequence.options).toMatchObject({ method: 'lri', keepLengths });
    }
  });

  it('follow tension and bias, which act on the splined lengths', async () => {
    const keys = await sheet(6);
    const tension = [1, 1];
    const [eased, even] = [
      await engine.createSequence(keys, { keepLengths: 3, tension }),
      await engine.createSequence(keys, { keepLengths: 3 }),
    ];
    // The cubic that rests at both keys is at 5/32 after a quarter of the time.
    const at = (await frameAt(eased, 0.25)).positions.slice();
    expect(largestDistance(at, (await frameAt(even, 5 / 32)).positions)).toBeLessThan(
      0.1 * largestDistance(at, (await frameAt(even, 0.25)).positions),
    );
  });

  it('refuse unsupported options, and updates that switch them on or off', async () => {
    const keys = await sheet(4);
    for (const [options, what] of [
      [{ hold: 'on' }, 'keeping resting parts in place'],
      [{ pins: [{ vertex: 0, radius: 0.1 }] }, 'pins'],
      [{ boundary: 'periodic' }, "ends other than 'natural'"],
      [{ boundary: 'hermite' }, "ends other than 'natural'"],
      [{ turns: [{ key: 1, turns: 1 }] }, 'full turns'],
    ] as const) {
      const { message } = await failureOf(engine.createSequence(keys, { ...options, keepLengths: 1 } as object));
      expect(message).toBe(`The option keepLengths does not support ${what}. Set keepLengths to 0.`);
    }
    expect((await failureOf(engine.createSequence(keys, { keepLengths: 4 }))).code).toBe('invalid-option');
    const kept = await engine.createSequence(keys, { keepLengths: 1 });
    const plain = await engine.createSequence(keys);
    for (const update of [kept.update({ keepLengths: 0 }), plain.update({ keepLengths: 2 })])
      expect((await failureOf(update)).message).toMatch(/^A motion with keepLengths [12] cannot be updated/);
    expect((await failureOf(kept.evaluateBlend([0.5, 0.5]))).code).toBe('invalid-option');
  });

  it('are refused by other methods', async () => {
    const made = engine.createSequence(await sheet(4), { method: 'linear', keepLengths: 3 });
    await expect(made).rejects.toThrow("The method 'linear' does not support kept lengths. Use the method 'lri'.");
  });

  it("count the user's keys in warnings, and repeat the warnings about the user's keys", async () => {
    const mesh = bar(2, 6, 3);
    const turned = moved(mesh, (x, y, z) => [
      -x * Math.cos(0.3) - y * Math.sin(0.3),
      x * Math.sin(0.3) - y * Math.cos(0.3),
      z,
    ]);
    const mirrored = moved(mesh, (x, y, z) => [-x, y, z]);
    const keys = await engine.createKeys({
      faces: mesh.indices,
      poses: [mesh.positions, turned, mirrored].map((positions, i) => ({ name: '', time: i, positions })),
    });
    const { warnings } = await engine.createSequence(keys, { keepLengths: 1 });
    const texts = (code: string): [number, string][] =>
      warnings.filter((one) => one.code === code).map(({ key, message }) => [key, message.slice(0, 25)]);
    expect(texts('mirrored-key')).toEqual([[2, 'Key 3 is a mirror image o']]);
    expect(texts('ambiguous-turn')[0]).toEqual([1, 'Between key 1 and key 2 t']);
  });

  it('are kept for split vertices as for a welded mesh', async () => {
    const { faces, poses } = rolledSheet(8, 3.5);
    const [one, apart] = [await keysOf({ faces, poses }), await keysOf(split(faces, poses))];
    const plain = await engine.createSequence(one);
    const kept = await engine.createSequence(apart, { keepLengths: 1 });
    expect(kept.warnings.map(({ code }) => code)).not.toContain('lengths-not-fitted');
    expect((await deviations(kept, apart)).area).toBeLessThan((await deviations(plain, one)).area / 3);
  });
});
