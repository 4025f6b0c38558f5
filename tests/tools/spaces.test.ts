/** Rotation-strain and RIMD compared with an implementation of their formulas in numpy, which Blender includes. */
import { expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import type { Method } from '../../web/engine/api/types.ts';
import { poseFiles } from '../engine/support/glb.ts';
import { bar, bent, diagonal, largestDistance, moved } from '../engine/support/shapes.ts';
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

describeBlender('the rival spaces', () => {
  it('are what their formulas give, to 1e-6 of the diagonal', async () => {
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
});
