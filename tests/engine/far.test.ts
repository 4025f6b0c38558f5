/** Shapes far from the origin: exact in the engine, and at their original position in every file. */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import { readPose } from '../../web/engine/api/read-poses.ts';
import type { InputFile } from '../../web/engine/api/types.ts';
import { folderOf, runCli } from './support/cli.ts';
import { frameAt, testEngine } from './support/engines.ts';
import { expectValid } from './support/exported.ts';
import { meshGlb } from './support/glb.ts';
import { bar, bent, diagonal, largestDistance } from './support/shapes.ts';
import { threePlayer } from './support/three-player.ts';

const engine = testEngine();
const mesh = bar(1, 8, 2);
const vertices = mesh.positions.length / 3;
const angles = [0, 50, 20];

type Place = readonly [number, number, number];

/** Absolute positions in double precision. */
const at = (place: Place, positions: Float32Array): number[] =>
  Array.from(positions, (value, i) => value + place[i % 3]!);
const poseAt = (place: Place, degrees: number): number[] => at(place, bent(mesh, degrees, 2));

const rows = (positions: number[], start: string): string =>
  Array.from({ length: vertices }, (_, v) => `${start}${positions.slice(3 * v, 3 * v + 3).join(' ')}\n`).join('');

function obj(positions: number[]): Uint8Array {
  const face = (_: unknown, f: number): string =>
    `f ${[...mesh.indices.subarray(3 * f, 3 * f + 3)].map((v) => v + 1).join(' ')}\n`;
  const faces = Array.from({ length: mesh.indices.length / 3 }, face).join('');
  return new TextEncoder().encode(rows(positions, 'v ') + faces);
}

const filesAt = (place: Place): InputFile[] =>
  angles.map((degrees, i) => ({ name: `${i}.obj`, bytes: obj(poseAt(place, degrees)) }));

/** The original positions of the keys. */
const keysAt = (keys: Keys): number[][] => angles.map((_, key) => at(keys.info.offset, keys.positions(key)));

const UTM: Place = [432_100, 5, 5_412_345];
const PLACES: Place[] = [[300, 0, 150], [1000, 0, 500], [5000, 0, 2500], [85_227, 10, 446_522], UTM];

describe('a shape far from the origin', () => {
  it.each(PLACES.map((place) => [`${place.join(', ')}${place === UTM ? '' : ' @all'}`, place] as const))(
    'at %s is exported within the error that the plan states',
    async (_, place) => {
      const keys = await engine.importKeyframes(filesAt(place));
      const sequence = await engine.createSequence(keys);
      const size = keys.info.report.diagonal;
      for (const compression of ['none', 'quantized', 'meshopt'] as const)
        for (const targets of ['frames', 'principal'] as const) {
          const options = { compression, targets, tolerance: 0.05 } as const;
          const { error } = await sequence.planExport(options);
          const [file] = await sequence.export(options);
          await expectValid(file!.bytes);
          const player = await threePlayer(file!.bytes);
          let worst = 0;
          for (let i = 0; i <= 80; i += 1) {
            const t = (i / 80) * 2;
            const expected = at(keys.info.offset, (await frameAt(sequence, t)).positions);
            worst = Math.max(worst, largestDistance(player.positionsAt(t), expected) / size);
          }
          expect(worst).toBeLessThan(error! + 1e-6);
          expect(error!).toBeLessThan(8e-4);
          for (const [key, degrees] of angles.entries()) {
            const off = largestDistance(player.positionsAt(key), poseAt(place, degrees)) / size;
            expect(off).toBeLessThan(compression === 'none' ? 2e-6 : 7e-5);
            expect(off).toBeLessThan(error! + 1e-6);
          }
          const again = await engine.importKeyframes([file!]);
          expect(again.info.offset).toEqual(keys.info.offset);
          expect(again.info.project).not.toBeNull();
          for (const [key, pose] of keysAt(again).entries())
            expect(largestDistance(pose, poseAt(place, angles[key]!)) / size).toBeLessThan(
              compression === 'none' ? 1e-6 : 7e-5,
            );
        }
      sequence.dispose();
    },
  );

  it('keeps a tangent of a saved project, which is relative to the same offset', async () => {
    const keys = await engine.importKeyframes(filesAt(UTM));
    const startTangent = await readPose(engine, [{ name: 't.obj', bytes: obj(poseAt(UTM, -40)) }], keys);
    const sequence = await engine.createSequence(keys, { boundary: 'hermite', startTangent });
    const [file] = await sequence.export({ frames: 5 });
    const again = await engine.importKeyframes([file!]);
    expect(again.info.offset).toEqual(keys.info.offset);
    expect(again.info.project!.startTangent).toEqual(startTangent);
    sequence.dispose();
  });
});

describe('on the command line', () => {
  const positionsOf = (text: string): number[] =>
    text
      .split('\n')
      .filter((line) => line.startsWith('v '))
      .flatMap((line) => line.slice(2).split(' ').map(Number));

  it('survey coordinates are kept in OBJ, PLY and GLB, and a point cache states the offset', async () => {
    const folder = await folderOf(filesAt(UTM));
    const run = async (...words: string[]) => {
      const outcome = await runCli(folder, ...words);
      expect(outcome).toMatchObject({ code: 0 });
      return outcome;
    };
    const inputs = angles.map((_, i) => `${i}.obj`);
    const size = diagonal(mesh.positions);
    await run('complete', ...inputs, '--output', 'obj/', '--at=0,1,2');
    for (const [key, degrees] of angles.entries()) {
      const text = await readFile(path.join(folder, `obj/000${key}.obj`), 'utf8');
      expect(largestDistance(positionsOf(text), poseAt(UTM, degrees)) / size).toBeLessThan(1e-6);
    }
    await run('complete', ...inputs, '--output', 'motion.glb', '--compression=meshopt');
    const cache = await run('complete', ...inputs, '--output', 'motion.pc2', '--frames=41', '--report', 'report.json');
    expect(cache.stderr).toContain('relative to 432100, 4, 5412348');
    const report = JSON.parse(await readFile(path.join(folder, 'report.json'), 'utf8')) as {
      offset: number[];
      warnings: { code: string }[];
    };
    expect(report.offset).toEqual([432_100, 4, 5_412_348]);
    expect(report.warnings.map(({ code }) => code)).toContain('local-positions');
    const local = positionsOf(await readFile(path.join(folder, 'motion.obj'), 'utf8'));
    expect(Math.max(...local.map(Math.abs))).toBeLessThan(4);

    const again = async (name: string, ...from: string[]) => {
      await run('complete', ...from, '--output', `${name}/`, '--at=0,1,2');
      for (const [key, degrees] of angles.entries()) {
        const text = await readFile(path.join(folder, `${name}/000${key}.obj`), 'utf8');
        expect(largestDistance(positionsOf(text), poseAt(UTM, degrees)) / size).toBeLessThan(7e-5);
      }
    };
    await again('from-glb', 'motion.glb');
    await again('from-cache', 'motion.obj', 'motion.pc2', '--sample=3', '--key-times=0,1,2');
  });

  it('a motion is measured against its own export there', async () => {
    const folder = await folderOf(filesAt(UTM));
    const inputs = angles.map((_, i) => `${i}.obj`);
    const made = await runCli(folder, 'complete', ...inputs, '--output', 'motion.glb', '--frames=61');
    expect(made.code).toBe(0);
    const { stdout } = await runCli(folder, 'measure', ...inputs, '--against', 'motion.glb', '--frames=61');
    expect(Number(/KG error (\S+) %/.exec(stdout)![1])).toBeLessThan(1e-3);
  });

  it('coordinates beyond single precision are refused, and nothing is written', async () => {
    const huge = (factor: number): InputFile[] =>
      angles.map((degrees, i) => ({
        name: `${i}.obj`,
        bytes: obj(poseAt([0, 0, 0], degrees).map((value) => factor * value)),
      }));
    for (const factor of [1e38, 1e39, 1e307]) {
      const folder = await folderOf(huge(factor));
      const outcome = await runCli(folder, 'complete', '0.obj', '1.obj', '2.obj', '--output', 'frames/');
      expect(outcome.code).toBe(1);
      expect(outcome.stderr).toMatch(/^\S+ .*Coordinates may be at most/);
    }
    const folder = await folderOf([]);
    await writeFile(
      path.join(folder, 'a.glb'),
      meshGlb(
        mesh,
        mesh.positions.map((value) => 1.5e38 * value),
      ),
    );
    await writeFile(
      path.join(folder, 'b.glb'),
      meshGlb(
        mesh,
        bent(mesh, 50, 2).map((value) => 1.5e38 * value),
      ),
    );
    expect(await runCli(folder, 'inspect', 'a.glb', 'b.glb')).toMatchObject({ code: 1 });
  });
});
