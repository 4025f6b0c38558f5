import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import { EngineError } from '../../web/engine/api/errors.ts';
import { farthest } from '../../web/engine/api/distances.ts';
import type { ImportOptions } from '../../web/engine/api/types.ts';
import { dataFile, dataFiles, hasData } from './support/data.ts';
import { frameAt, testEngine } from './support/engines.ts';
import { expectPlayed } from './support/exported.ts';
import { diagonal, largestDistance } from './support/shapes.ts';

const engine = testEngine();
const load = (names: string[], options?: ImportOptions): Promise<Keys> =>
  engine.importKeyframes(names.map(dataFile), options);

const inputs: [
  string,
  string[],
  ImportOptions,
  { vertices: number; weldedVertices?: number; faces: number },
  number,
][] = [
  [
    'three poses',
    ['cactus/cactus-1.glb', 'cactus/cactus-2.glb', 'cactus/cactus-3.glb'],
    {},
    { vertices: 5261, faces: 10518 },
    3,
  ],
  ['morph targets with an animation', ['cactus/cactus-morph.glb'], {}, { vertices: 5261, faces: 10518 }, 3],
  [
    'morph targets with many key times',
    ['morph/Horse.glb'],
    {},
    { vertices: 796, weldedVertices: 494, faces: 984 },
    NaN,
  ],
  [
    'a buffer beside the file',
    ['morph/AnimatedMorphSphere.gltf', 'morph/AnimatedMorphSphere.bin'],
    {},
    { vertices: 1876, faces: 960 },
    NaN,
  ],
  ['two primitives', ['morph/MorphStressTest.gltf'], {}, { vertices: 1528, faces: 2412 }, NaN],
  ['a skin', ['skin/CesiumMan.glb'], { sample: 5 }, { vertices: 3273, weldedVertices: 2338, faces: 4672 }, 5],
  [
    'a chosen animation',
    ['skin/Fox.glb'],
    { animation: 1, sample: [0, 0.2, 0.4] },
    { vertices: 1728, weldedVertices: 290, faces: 576 },
    3,
  ],
  ['many parts', ['skin/Soldier.glb'], { sample: 3 }, { vertices: 7434, faces: 11376 }, 3],
];

describe.skipIf(!hasData)('real files', () => {
  it.each(inputs)(
    'with %s import, the motion passes through their keys, and three.js plays the valid export',
    async (_, names, options, report, count) => {
      const keys = await load(names, options);
      expect(keys.info.report).toMatchObject(report);
      if (!Number.isNaN(count)) expect(keys.info.times).toHaveLength(count);
      const sequence = await engine.createSequence(keys);
      for (const [key, t] of keys.info.times.entries()) {
        const pose = keys.positions(key);
        expect(largestDistance((await frameAt(sequence, t)).positions, pose)).toBeLessThan(1e-5 * diagonal(pose));
      }
      const [first, last] = sequence.range;
      for (const t of [first - 0.4 * (last - first), 0.7 * first + 0.3 * last, last + 0.4 * (last - first)]) {
        const { positions, normals } = await frameAt(sequence, t);
        expect(positions.every(Number.isFinite) && normals.every(Number.isFinite)).toBe(true);
      }
      await expectPlayed(sequence, { frames: 4 });
      sequence.dispose();
    },
  );

  const plies = (folder: string): string[] => dataFiles(folder).filter((name) => name.endsWith('.ply'));
  const poses = (folder: string): string[] =>
    dataFiles(folder).filter((name) => name.endsWith('.obj') && !name.includes('reference'));
  it.each([
    ['a gallop', ['morph/Horse.glb'], { sample: 5 }],
    ['a run @all', ['skin/Fox.glb'], { animation: 2, sample: 5 }],
    ['a saddle that is bent', plies('turns/saddle'), {}],
    ['a sheet that is rolled up @all', plies('turns/plate'), {}],
    ['a cat @all', poses('obj/lowpoly-cat'), {}],
    ['a bar of Blender @all', [0, 1, 2].map((pose) => `blender/baked_flat_${pose}.glb`), {}],
  ] as [string, string[], ImportOptions][])(
    'of %s: the error that an export states holds between its frames',
    async (_, names, options) => {
      const keys = await load(names, options);
      for (const boundary of ['natural', 'periodic'] as const) {
        const sequence = await engine.createSequence(keys, { boundary });
        const [first, last] = sequence.range;
        const beyond: [number, number] = [first - 0.4 * (last - first), last + 0.4 * (last - first)];
        for (const asked of [{}, { tolerance: 1 }, { range: beyond }, { frames: 3 }, { frames: 7 }, { frames: 30 }]) {
          const { times, error } = await sequence.planExport(asked);
          const shapes = await sequence.evaluateMany(times);
          let largest = 0;
          for (let i = 1; i < times.length; i += 1)
            for (let share = 1 / 8; share < 1; share += 1 / 8) {
              const { positions } = await frameAt(sequence, times[i - 1]! + share * (times[i]! - times[i - 1]!));
              const [from, to] = [shapes[i - 1]!.positions, shapes[i]!.positions];
              largest = Math.max(largest, farthest(positions, from, to, share));
            }
          expect(largest).toBeGreaterThan(0.97 * error! * keys.info.report.diagonal);
          expect(largest).toBeLessThan(1.02 * error! * keys.info.report.diagonal);
        }
        sequence.dispose();
      }
    },
  );
});

describe.skipIf(!hasData)('malformed files', () => {
  const names = dataFiles('malformed').filter((name) => /\.(gltf|glb|obj|ply|off)$/.test(name));

  it.skipIf(!hasData)('are there', () => expect(names.length).toBeGreaterThan(50));

  it.each(names)('import or are refused with a code and a message: %s', async (name) => {
    const started = performance.now();
    const beside = dataFiles(name.slice(0, name.lastIndexOf('/'))).filter((other) =>
      /\.(bin|png|jpg|jpeg)$/.test(other),
    );
    const outcome = await load([name, ...beside]).catch((error: unknown) => error);
    expect(performance.now() - started).toBeLessThan(5000);
    if (!(outcome instanceof Error)) return;
    expect(outcome).toBeInstanceOf(EngineError);
    expect((outcome as EngineError).code).not.toMatch(/crashed|internal|out-of-memory/);
    expect(outcome.message).toMatch(/^[^\n]{20,}[.!]$/);
  });
});
