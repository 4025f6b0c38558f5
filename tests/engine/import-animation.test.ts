/** Keys sampled from animations, compared with three.js: its mixer, SkinnedMesh and morph targets. */
import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { dataFile, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';
import { rigFile } from './support/rig.ts';
import { diagonal, largestDistance } from './support/shapes.ts';
import { threePoser } from './support/three-poser.ts';

const engine = testEngine();

/** The largest difference over all times, relative to the diagonal. */
async function differenceToThree(file: InputFile, animation: number, times: number[]): Promise<number> {
  const keys = await engine.importKeyframes([file], { animation, sample: times });
  const poser = await threePoser(file.bytes, animation);
  // Unnamed animations are called "animation 0" here and "animation_0" in three.js.
  expect(keys.info.animations.map(({ name }) => name.replace(' ', '_'))).toEqual(
    poser.names.map((name) => name.replace(' ', '_')),
  );
  expect(keys.info.animation).toBe(animation);
  expect(keys.info.times).toEqual(times);
  const differences = times.map((t, key) => largestDistance(keys.positions(key), poser.positionsAt(t)));
  return Math.max(...differences) / diagonal(keys.positions(0));
}

describe('keys of an animation match three.js', () => {
  it('with skin, morph weights and node transforms at once, in LINEAR, STEP and CUBICSPLINE', async () => {
    const file = await rigFile();
    // Times before, at and between the keys of the samplers. The samplers start and end at different times.
    expect(
      await differenceToThree(file, 0, [0, 0.1, 0.2, 0.5, 0.69, 0.7, 0.9, 1, 1.3, 1.4, 1.75, 1.9, 2]),
    ).toBeLessThan(1e-5);
    expect(await differenceToThree(file, 1, [0, 0.4, 2.2, 3])).toBeLessThan(1e-5);
  });

  it('evenly spaced keys move to the nearest frames, and no two keys are equal', async () => {
    const keys = await engine.importKeyframes([await rigFile()], { animation: 'everything', sample: 6 });
    const frames = (await engine.importKeyframes([await rigFile()], { animation: 'everything', everyFrame: true }))
      .info;
    keys.info.times.forEach((time, key) => {
      const nearest = Math.min(...frames.times.map((frame) => Math.abs(frame - 0.4 * key)));
      expect(Math.abs(time - 0.4 * key)).toBeCloseTo(nearest < 0.2 ? nearest : 0, 6);
    });
    for (let key = 1; key < 6; key += 1) {
      expect(largestDistance(keys.positions(key), keys.positions(key - 1))).toBeGreaterThan(
        0.02 * diagonal(keys.positions(0)),
      );
    }
  });

  const real = [
    ['skin/CesiumMan.glb', 0],
    ['skin/Fox.glb', 0],
    ['skin/Fox.glb', 1],
    ['skin/Fox.glb', 2],
    ['skin/Soldier.glb', 0],
    ['skin/Soldier.glb', 1],
    ['skin/Soldier.glb', 3],
    ['morph/Horse.glb', 0],
  ] as const;

  it.skipIf(!hasData).each(real)('in %s, animation %i', async (name, animation) => {
    const file = dataFile(name);
    const { duration } = await threePoser(file.bytes, animation);
    const { start, end } = (await engine.importKeyframes([file], { animation, sample: 2 })).info.animations[animation]!;
    expect(end).toBeCloseTo(duration, 5);
    const times = [0, 0.13, 0.37, 0.5, 0.81].map((share) => start + share * (end - start));
    expect(await differenceToThree(file, animation, [...times, end])).toBeLessThan(1e-5);
  });
});
