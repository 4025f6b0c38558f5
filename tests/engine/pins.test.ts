/** Pins, through the engine, a project file and the command line. */
import { expect, it } from 'vitest';
import type { Sequence } from '../../web/engine/api/api.ts';
import type { Pin } from '../../web/engine/api/types.ts';
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

/** The vertex of the bar's end that moves most. */
function tip(): number {
  const [first, second] = [bent(mesh, 0), bent(mesh, 50)];
  const moved = (v: number): number => Math.hypot(...[0, 1, 2].map((k) => second[3 * v + k]! - first[3 * v + k]!));
  return Array.from({ length: first.length / 3 }, (_, v) => v).reduce((best, v) => (moved(v) > moved(best) ? v : best));
}

const shapeAt = async (sequence: Sequence, t: number): Promise<Float32Array> => (await frameAt(sequence, t)).positions;

it('are set and removed by an update, without encoding', async () => {
  const sequence = await engine.createSequence(await engine.importKeyframes(files));
  const before = await sequence.stats();
  const at = (t: number): Promise<Float32Array> => shapeAt(sequence, t);
  const [first, last] = sequence.range;
  const t = first + 0.5 * (last - first);
  const plain = await at(t);
  const vertex = tip();
  const place = (positions: Float32Array): number[] => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  const off = (a: number[], b: number[]): number => Math.hypot(...a.map((x, k) => x - b[k]!));

  await sequence.update({ pins: [{ vertex, radius: 0.1, stay: 0 }] });
  const stays = place(bent(mesh, 0));
  expect(off(place(await at(t)), stays)).toBeLessThan(0.15 * off(place(plain), stays));

  const move: [number, number, number] = [0, 0, 0.2 * diagonal(plain)];
  await sequence.update({ pins: [{ vertex, radius: 0.1, path: [{ time: t, move }] }] });
  const wanted = place(plain).map((x, k) => x + move[k]!);
  expect(off(place(await at(t)), wanted)).toBeLessThan(0.25 * Math.hypot(...move));

  await sequence.update({ pins: [{ vertex, radius: 0.1 }] });
  const key = bent(mesh, 50);
  expect(largestDistance(await at(first + (last - first) / 3), key)).toBeLessThan(1e-4 * diagonal(key));

  await sequence.update({ pins: [] });
  expect(await at(t)).toEqual(plain);
  expect((await sequence.stats()).encodeMs).toBe(before.encodeMs);
  for (const wrong of [
    { vertex: 1e6, radius: 0.1 },
    { vertex: 0, radius: 2 },
    { vertex: 0, radius: 0.1, stay: 4 },
  ])
    await expect(sequence.update({ pins: [wrong as Pin] })).rejects.toMatchObject({ code: 'invalid-option' });
  expect(await at(t)).toEqual(plain);
  sequence.dispose();
});

it('are in the project of an exported file, with the original keys', async () => {
  const own: Pin = { vertex: tip(), radius: 0.1 };
  const other: Pin = { vertex: 0, radius: 0.1 };
  const pins: Pin[] = [
    { ...own, stay: 1 },
    { ...other, path: [{ time: 0.5, move: [0, 0.1, 0] }] },
  ];
  const keys = await engine.importKeyframes(files);
  const sequence = await engine.createSequence(keys, { pins });
  const size = diagonal(keys.positions(0));
  const [first, last] = sequence.range;
  const times = [0, 0.3, 0.5, 1].map((share) => first + share * (last - first));
  for (const options of [{ frames: 10 }, { range: [first, times[2]!] as [number, number] }]) {
    const plan = await sequence.planExport(options);
    const [file] = await sequence.export(options);
    const again = await engine.importKeyframes([file!]);
    expect(again.info.project?.pins).toEqual(pins);
    for (let key = 0; key < files.length; ++key)
      expect(largestDistance(again.positions(key), keys.positions(key))).toBeLessThan(1e-6 * size);
    // Playback shows the same shapes as before.
    const frames = await engine.importKeyframes([file!], { animation: 0, sample: [0, 1] });
    for (const second of [0, 1])
      expect(largestDistance(frames.positions(second), await shapeAt(sequence, first + second))).toBeLessThan(
        1e-6 * size,
      );
    expect(plan.targets).toBeGreaterThan(files.length);
    const opened = await engine.createSequence(again, again.info.project!);
    for (const t of times)
      expect(largestDistance(await shapeAt(opened, t), await shapeAt(sequence, t))).toBeLessThan(1e-4 * size);
    opened.dispose();
  }
  sequence.dispose();
});

it('that move keys are not in a file with principal targets', async () => {
  const own: Pin = { vertex: tip(), radius: 0.1 };
  const pins: Pin[] = [own, { ...own, stay: 1 }, { ...own, path: [{ time: 0.5, move: [0, 0.1, 0] }] }];
  const sequence = await engine.createSequence(await engine.importKeyframes(files), { pins });
  const [file] = await sequence.export({ targets: 'principal' });
  const again = await engine.importKeyframes([file!]);
  expect(again.info.project?.pins).toEqual([own]);
  sequence.dispose();
});

it.skipIf(!hasData)('hold a foot, on the command line @all', async () => {
  const folder = await folderOf([{ ...dataFile('skin/CesiumMan.glb'), name: 'man.glb' }]);
  const table = async (...words: string[]): Promise<string> => {
    const { code, stdout, stderr } = await runCli(
      folder,
      'measure',
      'man.glb',
      '--sample',
      '6',
      '--frames',
      '5',
      ...words,
    );
    expect([code, stderr]).toEqual([0, '']);
    return stdout;
  };
  const plain = await table();
  expect(await table('--pin', '100:0.05')).not.toBe(plain);
  expect(await table('--pin', '100:patch', '--pin', '2000:stay=2:path=0.2/0/0.1/0')).not.toBe(plain);
  for (const [text, words] of [
    ['foot', "--pin: 'foot' is not a whole number"],
    ['1:0.05:up', "'up' is not stay=KEY or path=T/X/Y/Z,..."],
    ['1:3', 'radius'],
  ] as const) {
    const { code, stderr } = await runCli(folder, 'measure', 'man.glb', '--pin', text);
    expect(code).toBe(2);
    expect(stderr).toContain(words);
  }
  for (const [text, words] of [
    ['999999', '999,999'],
    ['1:stay=40', 'key 40'],
  ] as const) {
    const { code, stderr } = await runCli(folder, 'measure', 'man.glb', '--sample', '6', '--pin', text);
    expect(code).toBe(2);
    expect(stderr).toContain(words);
  }
});
