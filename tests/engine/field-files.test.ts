/** Files from the field (tests/fuzz/corpus), compared with three.js, also through the command line. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { readPoses } from '../../web/engine/api/read-poses.ts';
import { folderOf, runCli } from './support/cli.ts';
import { draco } from './support/compress.ts';
import { testEngine } from './support/engines.ts';
import { glbParts, gltfInside, poseFiles } from './support/glb.ts';
import { bar, largestDistance } from './support/shapes.ts';
import { threePoser, threeScene } from './support/three-poser.ts';

const engine = testEngine();
const corpus = path.resolve(import.meta.dirname, '../fuzz/corpus/gltf');
const field = (name: string): InputFile => ({ name, bytes: readFileSync(path.join(corpus, `field-${name}`)) });

describe('objects in another order', () => {
  it('keep their positions, and inspect lists the matches with the rule', async () => {
    const [first, second] = [field('eyes-a.glb'), field('eyes-b.glb')];
    const keys = await engine.importKeyframes([first, second]);
    // EyeR comes first in the second file; three.js keeps each file's order.
    const [a, b] = [keys.positions(0), keys.positions(1)];
    const half = a.length / 2;
    const swapped = Float32Array.from([...b.subarray(half), ...b.subarray(0, half)]);
    const shift = [0, 1, 2].map((c) => b[c]! - a[c]!);
    expect(
      largestDistance(
        b,
        a.map((x, i) => x + shift[i % 3]!),
      ),
    ).toBeLessThan(0.2);
    expect(
      largestDistance(
        swapped,
        a.map((x, i) => x + shift[i % 3]!),
      ),
    ).toBeGreaterThan(1);
    const { stdout } = await runCli(await folderOf([first, second]), 'inspect', first.name, second.name);
    expect(JSON.parse(stdout)).toMatchObject({
      matches: [
        { key: 1, object: 'EyeL', found: 'EyeL', by: 'name' },
        { key: 1, object: 'EyeR', found: 'EyeR', by: 'name' },
      ],
    });
    // The file is also read as an added pose of the open mesh.
    const [pose] = await readPoses(engine, [second], keys);
    expect(pose!.positions).toEqual(b);
  });

  it('and OBJ frames keep the names of objects and materials', async () => {
    const quad = (z: number): string => `v 0 0 0\nv 1 0 0\nv 1 1 ${z}\nv 0 1 ${z}\n`;
    const faces = 'f 1 2 3 4\n';
    const file = (name: string, z: number): InputFile => ({
      name,
      bytes: new TextEncoder().encode(
        `${quad(z)}o Größe 体\nusemtl skin\n${faces}${quad(z + 2)}o Hat\nusemtl felt\nf 5 6 7 8\n`,
      ),
    });
    const folder = await folderOf([file('a.obj', 0), file('b.obj', 1)]);
    const { code } = await runCli(folder, 'complete', 'a.obj', 'b.obj', '--frames', '2', '--output', 'frames/');
    expect(code).toBe(0);
    const lines = readFileSync(path.join(folder, 'frames/0001.obj'), 'utf8')
      .split('\n')
      .filter((line) => /^(o|usemtl|f)\b/.test(line));
    const names = [
      'o Größe 体',
      'usemtl skin',
      'f 1//1 2//2 3//3 4//4',
      'o Hat',
      'usemtl felt',
      'f 5//5 6//6 7//7 8//8',
    ];
    expect(lines).toEqual(names);
  });
});

describe('animations', () => {
  it('of one pose are skipped for the first that moves, as three.js shows it', async () => {
    const file = field('tpose-first.glb');
    const keys = await engine.importKeyframes([file], { sample: 3 });
    expect(keys.info.animation).toBe(1);
    expect(keys.info.animations.map(({ name, moves }) => [name, moves])).toEqual([
      ['TPose', false],
      ['walk', true],
    ]);
    const poser = await threePoser(file.bytes, 1);
    for (const [key, t] of keys.info.times.entries())
      expect(largestDistance(keys.positions(key), poser.positionsAt(t))).toBeLessThan(1e-5);
    const { code, stderr } = await runCli(await folderOf([file]), 'inspect', file.name, '--animation', 'TPose');
    expect([code, stderr]).toEqual([
      1,
      'shapespline: tpose-first.glb: the animation "TPose" is one pose. Choose an animation that moves: 1 "walk".\n',
    ]);
  });

  it('are the keys if each has one pose', async () => {
    const file = field('pose-library.glb');
    const keys = await engine.importKeyframes([file]);
    expect(keys.info.names).toEqual(['TPose', 'reach', 'crouch']);
    for (const [key] of keys.info.names.entries()) {
      const poser = await threePoser(file.bytes, key);
      expect(largestDistance(keys.positions(key), poser.positionsAt(0))).toBeLessThan(1e-5);
    }
    // The third action in a separate file, as an added pose.
    const one = field('pose1.glb');
    const poses = await readPoses(engine, [one], keys);
    const poser = await threePoser(one.bytes, 0);
    expect(poses.map(({ positions }) => largestDistance(positions, poser.positionsAt(0)) < 1e-5)).toEqual([true]);
  });
});

describe('animations of several objects', () => {
  it('play together, as three.js plays both, unless one of them is chosen', async () => {
    const file = field('actions.glb');
    for (const [animation, played] of [
      [undefined, [0, 1]],
      ['all', [0, 1]],
      [0, [0]],
      ['BallAction', [1]],
    ] as const) {
      const keys = await engine.importKeyframes([file], {
        sample: 3,
        ...(animation === undefined ? {} : { animation }),
      });
      const poser = await threePoser(file.bytes, ...played);
      for (const [key, t] of keys.info.times.entries())
        expect(largestDistance(keys.positions(key), poser.positionsAt(t))).toBeLessThan(1e-5);
    }
    const { stdout } = await runCli(await folderOf([file]), 'inspect', file.name);
    expect(JSON.parse(stdout)).toMatchObject({
      animation: 'ArmAction + BallAction',
      together: ['ArmAction', 'BallAction'],
      warnings: [],
    });
  });

  it('are read although an animation that is not used is broken', async () => {
    const file = field('camera-times.glb');
    const keys = await engine.importKeyframes([file]);
    const poser = await threePoser(file.bytes, 0);
    expect(keys.info.warnings).toEqual([]);
    for (const [key, t] of keys.info.times.entries())
      expect(largestDistance(keys.positions(key), poser.positionsAt(t))).toBeLessThan(1e-5);
  });

  it('without a mesh move the bones of the file with the mesh, as three.js applies them by name', async () => {
    const [character, walk] = [field('character.glb'), field('walk-only.glb')];
    const keys = await engine.importKeyframes([character, walk], { sample: 3 });
    const { animations } = await threeScene(walk.bytes);
    const poser = await threePoser(character.bytes, ...animations);
    for (const [key, t] of keys.info.times.entries())
      expect(largestDistance(keys.positions(key), poser.positionsAt(t))).toBeLessThan(1e-5);
  });
});

describe('files of other programs', () => {
  it('with KHR_meshopt_compression are read as three.js reads them', async () => {
    const file = field('khr-meshopt.glb');
    const keys = await engine.importKeyframes([file]);
    const poser = await threePoser(file.bytes, 0);
    for (const [key, t] of keys.info.times.entries())
      expect(largestDistance(keys.positions(key), poser.positionsAt(t))).toBeLessThan(1e-5);
  });
});

describe('messages', () => {
  it('show names in UTF-8', async () => {
    const file = field('umlaut.glb');
    const folder = await folderOf([file]);
    const { stderr } = await runCli(folder, 'inspect', file.name, '--object', 'Körper');
    expect(stderr).toBe('shapespline: umlaut.glb has no object "Körper"; it has "Größe 体".\n');
  });

  it('of the decoders contain no JavaScript errors', async () => {
    const mesh = bar();
    const [file] = await draco(poseFiles(mesh, [mesh.positions]));
    const { json, bin } = glbParts(file!.bytes);
    const text = gltfInside(json, bin).replace(/("KHR_draco_mesh_compression":\{"bufferView":)\d+/, '$1255');
    const bytes = new TextEncoder().encode(text);
    await expect(engine.importKeyframes([{ name: 'd.gltf', bytes }])).rejects.toThrow(
      'd.gltf: its compressed mesh cannot be decoded (mesh 0, primitive 0 refers to buffer view 255, which does not ' +
        'exist). Export the file again, or without compression.',
    );
  });
});
