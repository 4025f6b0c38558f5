/** Other methods compared with implementations of their formulas in numpy, which Blender includes. */
import { expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import type { Method } from '../../web/engine/api/types.ts';
import { poseFiles } from '../engine/support/glb.ts';
import { bar, bent, diagonal, largestDistance, moved, rolledSheet } from '../engine/support/shapes.ts';
import { describeBlender, runInBlender } from './blender.ts';
import { engine } from './made.ts';

const RIVALS = ['rotation-strain', 'rimd'] as const;
const TIMES = [0.1, 0.35, 0.6, 0.8];

/** A bar that is bent, then twisted by 270 degrees, and scaled at its twisted end. */
async function importBar(): Promise<Keys> {
  const mesh = bar(2, 16);
  const twisted = moved(mesh, (x, y, z) => {
    const [angle, scale] = [(1.5 * Math.PI * z) / 10, 1 + z / 20];
    const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
    return [c * x - s * y, s * x + c * y, 1.1 * z];
  });
  const poses = [mesh.positions, bent(mesh, 100), twisted, bent(mesh, -40)];
  return engine.importKeyframes(poseFiles(mesh, poses), { keyTimes: [0, 0.3, 0.7, 1] });
}

async function shapesOf(keys: Keys, method: Method): Promise<number[][]> {
  const sequence = await engine.createSequence(keys, { method, precision: 'exact' });
  const frames = await sequence.evaluateMany(TIMES);
  sequence.dispose();
  return frames.map(({ positions }) => [...positions]);
}

describeBlender('the compared spaces', () => {
  it('match their formulas, to 1e-6 of the diagonal', async () => {
    const keys = await importBar();
    const poses = keys.info.times.map((_, key) => [...keys.positions(key)]);
    const lri = await shapesOf(keys, 'lri');
    const expected = await runInBlender<Record<(typeof RIVALS)[number], number[][]>>('rival_spaces.py', {
      ...{ faces: [...keys.info.faces], keys: poses, keyTimes: keys.info.times, times: TIMES, lri },
    });
    const size = diagonal(Float32Array.from(poses[0]!));
    for (const method of RIVALS) {
      const shapes = await shapesOf(keys, method);
      shapes.forEach((shape, index) => {
        expect(largestDistance(shape, expected[method][index]!) / size, `${method} at ${TIMES[index]}`).toBeLessThan(
          1e-6,
        );
        // The shapes differ from the common starting shapes.
        expect(largestDistance(shape, lri[index]!) / size).toBeGreaterThan(1e-5);
      });
    }
  });

  it('of shells have the least energies by their formulas', async () => {
    const samples = 4;
    const { faces, poses } = rolledSheet(4, 2.5);
    const keys = await engine.createKeys({
      faces,
      poses: poses.map((positions, time) => ({ name: `${time}`, time, positions })),
    });
    const paths: Record<string, number[][]> = {};
    for (const method of ['lri', 'lengths', 'shell'] as const) {
      const sequence = await engine.createSequence(keys, { method, spaceSamples: samples, precision: 'exact' });
      const times = Array.from({ length: samples + 1 }, (_, i) => i / samples);
      paths[method] = (await sequence.evaluateMany(times)).map(({ positions }) => [...positions]);
      sequence.dispose();
    }
    const [t, step] = [0.4, 1 / 24];
    const plain = await engine.createSequence(keys);
    const around = (await plain.evaluateMany([t - step, t, t + step])).map(({ positions }) => [...positions]);
    const { falls, bending, density } = await runInBlender<{
      falls: number[];
      bending: Record<string, number>;
      density: number;
    }>('shell_energy.py', { faces: [...faces], paths, around, step });
    expect((await plain.shellBending([t]))[0]! / density).toBeCloseTo(1, 6);
    expect(falls).toHaveLength(samples - 1);
    for (const fall of falls) expect(fall).toBeLessThan(1e-6);
    expect(bending['lengths']).toBeLessThan(0.95 * bending['lri']!);
    expect(bending['shell']).toBeLessThan(0.95 * bending['lengths']!);
  });
});
