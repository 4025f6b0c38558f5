/** Shapes given by weights of the keys, and their positions in shape space. */
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Sequence } from '../../web/engine/api/api.ts';
import { folderOf, listed, runCli } from './support/cli.ts';
import { dataFile, hasData } from './support/data.ts';
import { bendSequence, failureOf, frameAt, testEngine, type Bend } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { diagonal, largestDistance } from './support/shapes.ts';

const engine = testEngine();
let bend: Bend & { sequence: Sequence };
let size: number;

beforeAll(async () => {
  bend = await bendSequence(engine);
  size = diagonal(bend.poses[0]!);
});

const blended = async (weights: number[]): Promise<Float32Array> => {
  const frame = await bend.sequence.evaluateBlend(weights);
  return frame!.positions;
};

describe('a blend of keys', () => {
  it('is a different shape off the curve, independent of earlier shapes', async () => {
    const weights = [0.8, -0.6, 0.8];
    const shape = await blended(weights);
    for (const t of [0, 0.25, 0.5, 0.75, 1]) {
      expect(largestDistance(shape, (await frameAt(bend.sequence, t)).positions)).toBeGreaterThan(0.01 * size);
    }
    expect(await blended(weights)).toEqual(shape);
  });

  it('is null if a newer request replaces it', async () => {
    const asked = [0, 0.1, 0.2, 0.3].map((w) => bend.sequence.evaluateBlend([1 - w, w, 0]));
    const frames = await Promise.all(asked);
    expect(frames.map((frame) => frame !== null)).toEqual([true, false, false, true]);
    frames.forEach((frame) => frame?.release());
  });

  it('needs one weight per key, and a sum of 1', async () => {
    const sentence = async (weights: number[]): Promise<string> => {
      const { code, message } = await failureOf(bend.sequence.evaluateBlend(weights));
      expect(code).toBe('invalid-option');
      return message;
    };
    expect(await sentence([0.5, 0.5])).toBe('There are 2 weights for 3 keys. Give one per key.');
    expect(await sentence([0.5, 0.5, 0.5])).toBe('The weights of a blend must sum to 1, not 1.5.');
    expect(await sentence([NaN, 1, 0])).toBe('The weights of a blend must be numbers, one per key.');
    await bend.sequence.evaluateBlend([1 / 3, 1 / 3, 1 / 3 + 9e-7]);
  });
});

describe('complete --blend', () => {
  it('writes the shape that the engine blends', async () => {
    const files = poseFiles(bend.mesh, bend.poses);
    const folder = await folderOf(files);
    const names = files.map(({ name }) => name);
    const run = (...words: string[]) => runCli(folder, 'complete', ...names, ...words);
    const weights = [0.7, -0.5, 0.8];
    const { code, stdout, stderr } = await run(
      '--blend',
      weights.join(','),
      '--output',
      'blend.obj',
      '--report',
      'r.json',
    );
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(/^blend\.obj: 1 shape, \d+ bytes\n$/);
    const lines = (await readFile(path.join(folder, 'blend.obj'), 'utf8')).split('\n');
    const positions = lines.filter((line) => line.startsWith('v ')).flatMap((line) => line.split(' ').slice(1, 4));
    expect(largestDistance(Float32Array.from(positions.map(Number)), await blended(weights))).toBeLessThan(1e-5 * size);
    const report = JSON.parse(await readFile(path.join(folder, 'r.json'), 'utf8')) as Record<string, object>;
    expect(report['frames']).toEqual([]);
    expect(report['options']).toMatchObject({ export: { blend: weights } });

    expect((await run('--blend=-0.5,1,0.5', '--output', 'blend.glb')).code).toBe(0);
    for (const [words, sentence] of [
      [['--blend', '1,0', '--output', 'bad.obj'], 'There are 2 weights for 3 keys. Give one per key.'],
      [['--blend', '1,1,0', '--output', 'bad.obj'], '--blend: must sum to 1, not 2'],
      [['--blend', '1,0,0', '--output', 'bad.pc2'], '--blend gives one shape: bad.pc2 must end in .glb, .obj or .ply'],
      [['--blend', '1,0,0', '--at', '1', '--output', 'bad.obj'], '--blend gives one shape: leave out --at'],
    ] as const) {
      const wrong = await run(...words);
      expect(wrong.code, words.join(' ')).toBe(2);
      expect(wrong.stderr).toContain(sentence);
    }
    expect((await listed(folder)).filter((name) => name.startsWith('bad'))).toEqual([]);
  });
});

/** Weights of three keys around a circle. At radius 1, each key is at a third of the way; larger radii extrapolate. */
function around(share: number, radius: number): number[] {
  return [0, 1, 2].map((k) => 1 / 3 + (2 / 3) * radius * Math.cos(2 * Math.PI * (share - k / 3)));
}

describe.skipIf(!hasData)('blends of real keys with large turns', () => {
  const lion = (...poses: number[]): string[] => poses.map((pose) => `turns/lion/${pose}.obj`);
  it.each([
    ['lion 1, 2, 3', lion(1, 2, 3), 240],
    ['lion 4, 7, 9 @all', lion(4, 7, 9), 240],
    ['cat @all', ['turns/cat/cat2.off', 'turns/cat/cat5.off', 'turns/cat/cat8.off'], 90],
    ['low-poly cat @all', ['01', '13', '25'].map((pose) => `obj/lowpoly-cat/cat_0000${pose}.obj`), 600],
  ])('%s: go around the keys without a jump, and are each key at its weights', async (_, names, steps) => {
    const keys = await engine.importKeyframes(names.map(dataFile));
    const sequence = await engine.createSequence(keys);
    const across = diagonal(keys.positions(0));
    const at = async (weights: number[]): Promise<Float32Array> => {
      const frame = await sequence.evaluateBlend(weights);
      const positions = Float32Array.from(frame!.positions);
      frame!.release();
      return positions;
    };
    for (const k of [0, 1, 2])
      expect(largestDistance(await at(around(k / 3, 1)), keys.positions(k))).toBeLessThan(1e-4 * across);
    for (const radius of [1, 0.5, 1.6]) {
      let last = await at(around(0, radius));
      const moved: number[] = [];
      for (let i = 1; i <= steps; i += 1) {
        const shape = await at(around(i / steps, radius));
        moved.push(largestDistance(shape, last));
        last = shape;
      }
      expect(Math.max(...moved)).toBeLessThan(across);
      // The remaining share of the largest step after subdivision: small for a motion, all of it for a jump.
      const worst = moved.indexOf(Math.max(...moved));
      const parts = 32;
      let [most, before] = [0, await at(around(worst / steps, radius))];
      for (let i = 1; i <= parts; i += 1) {
        const shape = await at(around((worst + i / parts) / steps, radius));
        most = Math.max(most, largestDistance(shape, before));
        before = shape;
      }
      expect(most / moved[worst]!).toBeLessThan(4 / parts);
    }
    sequence.dispose();
    keys.dispose();
  });
});
