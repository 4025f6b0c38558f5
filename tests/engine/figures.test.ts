/** The guide's statements about figures, checked on their links' motions. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { FIGURES } from '../../web/app/guide/figures.ts';
import type { Facts } from '../../web/app/guide/guide-page.ts';
import type { Method } from '../../web/engine/api/types.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

it('Fig. 3 passes near the pose of its tangents, much closer than with natural ends', async () => {
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

it('Fig. 9: by edge lengths and angles, the geodesic peaks at every inner key, and both splines stay below', async () => {
  const { state } = FIGURES.find(({ link }) => link === 'figure=9')!;
  const { view, motion } = readPermalink(state)!;
  const bytes = await readFile(new URL('../../public/samples/dachshund.glb', import.meta.url));
  const keyTimes = Array.from({ length: 8 }, (_, key) => key / 8);
  const shape = await engine.encode(await engine.importKeyframes([{ name: 'dachshund.glb', bytes }], { keyTimes }));
  const times = Array.from({ length: 57 }, (_, i) => i / 64);
  const inner = keyTimes.slice(1, -1).map((t) => times.indexOf(t));
  const energiesOf = async (method: Method): Promise<number[]> => {
    const made = await shape.motion({ ...motion, method, pins: [] });
    return made.shellBending(times);
  };
  expect(view.compare).toEqual(['geodesic', 'shell']);
  const [lri, geodesic, shell] = [await energiesOf('lri'), await energiesOf('geodesic'), await energiesOf('shell')];
  const highest = Math.max(...lri, ...shell);
  for (const key of inner) expect(geodesic[key]!).toBeGreaterThan(1.5 * highest);
  const mean = (values: number[]): number => values.reduce((sum, value) => sum + value / values.length, 0);
  expect(mean(shell)).toBeLessThan(mean(lri));
});
