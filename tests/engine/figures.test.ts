/** The guide's statements about figures, checked on their links' motions. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { FIGURES } from '../../web/app/guide/figures.ts';
import type { Facts } from '../../web/app/guide/guide-page.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

it('Fig. 3 passes near the pose that its tangents point to, much nearer than with free ends', async () => {
  const { state, ask } = FIGURES.find(({ link }) => link === 'figure=3')!;
  const { keys, motion, encoding } = readPermalink(state)!;
  const bytes = await readFile(new URL('../../public/samples/cactus.glb', import.meta.url));
  const poses = await engine.importKeyframes([{ name: 'cactus.glb', bytes }]);
  const keyTimes = keys!.map(([, time]) => time);
  const chosen = poses.arrange(
    keys!.map(([pose]) => pose),
    keyTimes,
  );
  const tangents = {
    startTangent: poses.positions(encoding.startTangentPose!),
    endTangent: poses.positions(encoding.endTangentPose!),
  };
  const percentWith = async (options: object): Promise<number> => {
    const sequence = await engine.createSequence(chosen, options);
    const said = await ask!(sequence, { keyTimes } as unknown as Facts, poses);
    sequence.dispose();
    return Number(/average ([\d.]+) %/.exec(said)![1]);
  };
  const near = await percentWith({ ...motion, ...tangents });
  expect(near).toBeGreaterThan(0);
  expect(near).toBeLessThan(3);
  // In coordinates, tangents of speed v leave 1 - v / 4 of the distance from the geodesic's middle to that pose.
  expect((await percentWith({})) / near).toBeGreaterThan(3);
});
