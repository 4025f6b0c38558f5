/** Bending by edge lengths and angles: one measure for motions of every method. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import type { SequenceOptions } from '../../web/engine/api/types.ts';
import { bendKeys, failureOf, testEngine } from './support/engines.ts';
import { bar, bent, rolledSheet, type Mesh } from './support/shapes.ts';

const engine = testEngine();

const sampleFile = (name: string): URL => new URL(`../../public/samples/${name}`, import.meta.url);

async function importCactus(): Promise<Keys> {
  const bytes = new Uint8Array(readFileSync(sampleFile('cactus.glb')));
  return engine.importKeyframes([{ name: 'cactus.glb', bytes }], { keyTimes: [0, 0.5, 1] });
}

/** Evenly spaced times from 0 to 1, including 0.5. */
const times = Array.from({ length: 49 }, (_, i) => i / 48);

describe('bending by edge lengths and angles', () => {
  it('is the same for every method with the same motion, and on a coarse mesh', async () => {
    const energiesOf = async (mesh: Mesh, options?: Partial<SequenceOptions>): Promise<number[]> => {
      const poses = [0, 90, 0].map((degrees) => bent(mesh, degrees));
      const keys = await engine.createKeys({
        faces: mesh.indices,
        poses: poses.map((positions, time) => ({ name: `${time}`, time, positions })),
      });
      return (await engine.createSequence(keys, options)).shellBending([0.5, 1, 1.5]);
    };
    const plain = await energiesOf(bar(2, 12));
    const fitted = await energiesOf(bar(2, 12), { method: 'lengths', spaceSamples: 8 });
    const fine = bar(8, 60);
    expect(fine.indices.length / 3).toBeGreaterThan(1000);
    const coarse = await energiesOf(fine);
    plain.forEach((energy, i) => {
      expect(Math.abs(fitted[i]! / energy - 1)).toBeLessThan(0.2);
      expect(Math.abs(coarse[i]! / energy - 1)).toBeLessThan(0.2);
    });
  });

  it('is in units of time to the minus fourth, beyond the keys as well, and none at rest', async () => {
    const { faces, poses } = rolledSheet(4, 2.5);
    const keysAt = (scale: number, shapes: Float32Array[]): Promise<Keys> =>
      engine.createKeys({ faces, poses: shapes.map((positions, i) => ({ name: `${i}`, time: scale * i, positions })) });
    const [first, last] = poses as [Float32Array, Float32Array];
    const quick = await engine.createSequence(await keysAt(1, [first, last, first]));
    const slow = await engine.createSequence(await keysAt(3, [first, last, first]));
    const [one] = await quick.shellBending([0.7]);
    expect((await slow.shellBending([2.1]))[0]! / one!).toBeCloseTo(1 / 81, 6);
    for (const energy of await quick.shellBending([-0.2, 0, 2, 2.2])) expect(energy).toBeGreaterThanOrEqual(0);
    const resting = await engine.createSequence(await keysAt(1, [first, first]));
    expect(await resting.shellBending([0.5])).toEqual([0]);
  });

  it('can be cancelled while its mesh is made and while shapes are evaluated, and reports progress', async () => {
    const sequence = await engine.createSequence(await importCactus());
    for (const stage of ['encoding', 'evaluating']) {
      const abort = new AbortController();
      const fractions: number[] = [];
      const work = sequence.shellBending(times, {
        signal: abort.signal,
        onProgress: (progress) => {
          fractions.push(progress.fraction);
          if (progress.stage === stage || (stage === 'encoding' && progress.stage !== 'evaluating')) abort.abort();
        },
      });
      expect((await failureOf(work)).code).toBe('cancelled');
      expect(fractions.length).toBeGreaterThan(0);
      expect(fractions.every((one, i) => i === 0 || one >= fractions[i - 1]!)).toBe(true);
    }
    expect(await sequence.shellBending([0.3])).toHaveLength(1);
    sequence.dispose();
    expect((await failureOf(sequence.shellBending([0.3]))).code).toBe('disposed');
  });

  it('refuses invalid times and call options', async () => {
    const { keys } = await bendKeys(engine);
    const sequence = await engine.createSequence(keys);
    expect((await failureOf(sequence.shellBending([NaN]))).code).toBe('invalid-option');
    expect((await failureOf(sequence.shellBending([0.5], { abort: true } as object))).code).toBe('invalid-option');
  });
});
