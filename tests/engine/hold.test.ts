/** Motions that hold resting vertices, through the engine and the command line. */
import { expect, it } from 'vitest';
import type { Hold } from '../../web/engine/api/types.ts';
import { dataFile, hasData } from './support/data.ts';
import { folderOf, runCli } from './support/cli.ts';
import { frameAt, testEngine } from './support/engines.ts';
import { bent, bar, diagonal, largestDistance } from './support/shapes.ts';
import { poseFiles } from './support/glb.ts';

const engine = testEngine();
const mesh = bar();
const files = poseFiles(
  mesh,
  [0, 50, 20, 70].map((degrees) => bent(mesh, degrees)),
);

it('is switched on and off by an update, without encoding, and does not change the keys', async () => {
  const keys = await engine.importKeyframes(files);
  const sequence = await engine.createSequence(keys);
  const before = await sequence.stats();
  const at = async (t: number): Promise<Float32Array> => (await frameAt(sequence, t)).positions;
  const [first, last] = sequence.range;
  const t = first + 0.2 * (last - first);
  const plain = await at(t);
  // The bar rests on its end.
  const sliding = async (): Promise<number[]> => (await sequence.measures([t, last + 1])).sliding;
  const [slides, beyond] = await sliding();
  expect(beyond).toBeNaN();
  await sequence.update({ hold: 'on' });
  expect(largestDistance(await at(t), plain)).toBeGreaterThan(1e-4 * diagonal(plain));
  expect((await sliding())[0]).toBeLessThan(0.6 * slides!);
  const pose = bent(mesh, 0);
  expect(largestDistance(await at(first), pose)).toBeLessThan(1e-5 * diagonal(pose));
  await sequence.update({ hold: 'off' });
  expect(await at(t)).toEqual(plain);
  expect((await sequence.stats()).encodeMs).toBe(before.encodeMs);
  await expect(sequence.update({ hold: 'tight' as Hold })).rejects.toMatchObject({ code: 'invalid-option' });
  sequence.dispose();
});

it('is in the table of the command line, with the sliding of resting vertices', async () => {
  const folder = await folderOf(files);
  const keys = await engine.importKeyframes(files);
  const largest: number[] = [];
  for (const hold of ['off', 'on'] as const) {
    const words = ['measure', ...files.map(({ name }) => name), '--hold', hold, '--frames', '13'];
    const { code, stdout, stderr } = await runCli(folder, ...words);
    expect([code, stderr]).toEqual([0, '']);
    const [head, ...rows] = stdout
      .trimEnd()
      .split('\n')
      .filter((line) => !line.startsWith('#'))
      .map((line) => line.split(','));
    const column = (name: string): number[] => rows.map((row) => Number(row[head!.indexOf(name)]));
    const sequence = await engine.createSequence(keys, { hold });
    const { sliding } = await sequence.measures(column('time'));
    column('lri sliding').forEach((cell, index) => expect(cell).toBeCloseTo(sliding[index]!, 4));
    largest.push(Math.max(...sliding));
    sequence.dispose();
  }
  expect(largest[0]).toBeGreaterThan(0.05);
  expect(largest[1]).toBeLessThan(0.6 * largest[0]!);
});

it.skipIf(!hasData)('reduces the error against a captured walk, on the command line @all', async () => {
  const man = dataFile('skin/CesiumMan.glb');
  const folder = await folderOf([{ ...man, name: 'man.glb' }]);
  const errors: number[] = [];
  for (const hold of ['off', 'on']) {
    const { code, stdout, stderr } = await runCli(
      folder,
      ...['measure', 'man.glb', '--animation', '0', '--sample', '7', '--hold', hold, '--against', 'man.glb'],
    );
    expect([code, stderr]).toEqual([0, '']);
    errors.push(Number(/# lri: KG error ([\d.]+) %/.exec(stdout)?.[1]));
  }
  const [off, held] = errors as [number, number];
  expect(held).toBeLessThan(0.98 * off);
});
