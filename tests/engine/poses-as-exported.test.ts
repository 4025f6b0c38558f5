/**
 * Poses whose vertices exporters have split differently, caches, numbered files and objects, through engine and CLI.
 */
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import { readPose } from '../../web/engine/api/read-poses.ts';
import type { InputFile } from '../../web/engine/api/types.ts';
import { folderOf, runCli } from './support/cli.ts';
import { dataFile, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';
import { meshGlb } from './support/glb.ts';
import { bar, bent, type Mesh } from './support/shapes.ts';

const engine = testEngine();
const text = (content: string): Uint8Array => new TextEncoder().encode(content);

/** Every corner has a separate vertex, as in flat shading. */
function split({ positions, indices }: Mesh, pose = positions): { mesh: Mesh; pose: Float32Array } {
  const corners = Float32Array.from([...indices].flatMap((v) => [...pose.subarray(3 * v, 3 * v + 3)]));
  return { mesh: { positions: corners, indices: indices.map((_, corner) => corner) }, pose: corners };
}

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

function pc2(poses: Float32Array[]): Uint8Array {
  const head = new DataView(new ArrayBuffer(32));
  text('POINTCACHE2\0').forEach((byte, i) => head.setUint8(i, byte));
  head.setInt32(12, 1, true);
  head.setInt32(16, poses[0]!.length / 3, true);
  head.setFloat32(24, 1, true);
  head.setInt32(28, poses.length, true);
  return Uint8Array.from([head, ...poses].flatMap(({ buffer }) => [...new Uint8Array(buffer as ArrayBuffer)]));
}

const mesh = bar();
const degrees = Array.from({ length: 13 }, (_, frame) => 10 * frame);
const poses = degrees.map((angle) => bent(mesh, angle).slice());
const vertices = mesh.positions.length / 3;

describe('poses with differently split vertices', () => {
  const flat = split(mesh, poses[6]);
  const files: InputFile[] = [
    { name: 'a.glb', bytes: meshGlb(mesh) },
    { name: 'b.glb', bytes: meshGlb(flat.mesh, flat.pose) },
  ];

  it('use the vertices of the first pose', async () => {
    const keys = await engine.importKeyframes(files);
    expect(keys.info.report.vertices).toBe(vertices);
    expect(keys.positions(1)).toEqual(poses[6]);
    const sequence = await engine.createSequence(keys);
    const frame = await sequence.evaluate(1);
    frame!.positions.forEach((x, i) => expect(Math.abs(x - poses[6]![i]!)).toBeLessThan(1e-4));
    sequence.dispose();
  });

  it('can be added to open keys', async () => {
    const keys = await engine.importKeyframes([files[0]!, { name: 'c.glb', bytes: meshGlb(mesh, poses[3]) }]);
    expect(await readPose(engine, [files[1]!], keys)).toEqual(poses[6]);
  });
});

describe('on the command line', () => {
  it('equal poses give a warning with advice', async () => {
    const bytes = meshGlb(mesh);
    const folder = await folderOf([
      { name: 'a.glb', bytes },
      { name: 'b.glb', bytes },
    ]);
    const { code, stdout } = await runCli(folder, 'inspect', 'a.glb', 'b.glb');
    expect(code).toBe(0);
    const { warnings } = JSON.parse(stdout) as { warnings: { code: string; message: string }[] };
    expect(warnings[0]!.code).toBe('same-poses');
    expect(warnings[0]!.message).toMatch(/^Keys 1 and 2 are the same pose.*Apply the modifiers/);
    const done = await runCli(folder, 'complete', 'a.glb', 'b.glb', '--output', 'out.glb', '--frames', '3');
    expect(done.stderr).toMatch(/same pose/);
  });

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

  it('a PC2 is sampled with its OBJ', async () => {
    const folder = await folderOf([
      { name: 'bar.obj', bytes: text(obj(mesh)) },
      { name: 'bar.pc2', bytes: pc2(poses) },
    ]);
    const { code, stderr, stdout } = await runCli(folder, 'inspect', 'bar.obj', 'bar.pc2', '--sample', '0,0.25,0.5');
    expect(stderr).toBe('');
    expect(code).toBe(0);
    expect(JSON.parse(stdout)).toMatchObject({
      keys: [{ time: 0 }, { time: 0.25 }, { time: 0.5 }],
      animations: [{ name: 'bar', start: 0, end: 0.5, keys: 13 }],
      vertices: { raw: vertices },
    });
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

describe.skipIf(!hasData)("Blender's files", () => {
  const three = (name: string): InputFile[] => [0, 1, 2].map((key) => dataFile(`blender/${name}_${key}.glb`));

  it.each([
    ['baked_flat', 1584],
    ['suzsm', 555],
  ])('%s are poses of one mesh', async (name, count) => {
    const keys = await engine.importKeyframes(three(name));
    expect(keys.info.report.vertices).toBe(count);
    const sequence = await engine.createSequence(keys);
    expect((await sequence.evaluate(0.25))!.indefiniteFaces).toBe(0);
    sequence.dispose();
  });
});
