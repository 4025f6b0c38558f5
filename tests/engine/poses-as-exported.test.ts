/**
 * Poses whose vertices exporters have split differently, caches, numbered files and objects, through engine and CLI.
 */
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import { folderOf, runCli } from './support/cli.ts';
import { bar, bent, type Mesh } from './support/shapes.ts';
const text = (content: string): Uint8Array => new TextEncoder().encode(content);

const obj = ({ positions, indices }: Mesh, pose = positions): string =>
  [
    'o Body',
    ...Array.from({ length: pose.length / 3 }, (_, v) => `v ${pose.subarray(3 * v, 3 * v + 3).join(' ')}`),
    ...Array.from(
      { length: indices.length / 3 },
      (_, f) => `f ${[...indices.subarray(3 * f, 3 * f + 3)].map((v) => v + 1).join(' ')}`,
    ),
    '',
  ].join('\n');

const floor = (vertices: number): string =>
  `o Floor\nv -9 -9 0\nv 9 -9 0\nv 9 9 0\nf ${vertices + 1} ${vertices + 2} ${vertices + 3}\n`;

const mesh = bar();
const degrees = Array.from({ length: 13 }, (_, frame) => 10 * frame);
const poses = degrees.map((angle) => bent(mesh, angle).slice());
const vertices = mesh.positions.length / 3;

describe('on the command line', () => {
  it('objects are listed, and one of them is selected', async () => {
    const files = [0, 6].map((frame) => ({
      name: `pose-${frame}.obj`,
      bytes: text(obj(mesh, poses[frame]) + floor(vertices)),
    }));
    const folder = await folderOf(files);
    const names = files.map(({ name }) => name);
    const all = JSON.parse((await runCli(folder, 'inspect', ...names)).stdout) as {
      objects: string[];
      components: number;
    };
    expect(all).toMatchObject({ objects: ['Body', 'Floor'], components: 2 });
    const one = JSON.parse((await runCli(folder, 'inspect', ...names, '--object', 'Body')).stdout) as object;
    expect(one).toMatchObject({ components: 1, vertices: { raw: vertices } });
    const none = await runCli(folder, 'inspect', ...names, '--object', 'Roof');
    expect(none.code).toBe(1);
    expect(none.stderr).toMatch(/no object "Roof"; it has "Body", "Floor"/);
  });

  it('a folder of numbered files is sampled', async () => {
    const folder = await folderOf([]);
    await mkdir(path.join(folder, 'run'));
    for (const [frame, pose] of poses.entries())
      await writeFile(path.join(folder, 'run', `bar_${frame + 1}.obj`), obj(mesh, pose));
    const { stdout } = await runCli(folder, 'inspect', 'run', '--sample', '0,0.25,0.5');
    expect(JSON.parse(stdout)).toMatchObject({ keys: [{ time: 0 }, { time: 0.25 }, { time: 0.5 }], animation: 'bar' });
    const every = JSON.parse((await runCli(folder, 'inspect', 'run/')).stdout) as { keys: { name: string }[] };
    expect(every.keys.map(({ name }) => name)).toEqual(poses.map((_, frame) => `bar_${frame + 1}`));
    const empty = await runCli(folder, 'inspect', '.');
    expect(empty.stderr).toMatch(/no model in this folder/);
  });
});
