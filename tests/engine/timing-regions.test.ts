/** Regions with timings of their own, beside the other options of a motion. */
import { expect, it } from 'vitest';
import type { MotionChange, Sequence } from '../../web/engine/api/api.ts';
import type { SequenceOptions, TimingRegion } from '../../web/engine/api/types.ts';
import { frameAt, testEngine } from './support/engines.ts';
import { expectValid } from './support/exported.ts';
import { threePlayer } from './support/three-player.ts';
import { bent, bar, diagonal, largestDistance } from './support/shapes.ts';
import { poseFiles } from './support/glb.ts';

const engine = testEngine();
const mesh = bar();
const poses = [0, 50, 20, 70].map((degrees) => bent(mesh, degrees));
const size = diagonal(poses[0]!);
const KEYS = [0, 1, 2, 3];
const faces = mesh.indices.length / 3;

const region = (first: number, count: number, earlier: number[], swing: number[]): TimingRegion => ({
  faces: count > 0 ? [first, count] : [],
  earlier,
  swing,
  soft: false,
});
const regions = [
  region(0, Math.floor(faces / 3), [0.3, -0.2, 0.2, 0.1], [0, 0.5, 0, 0]),
  region(Math.floor(faces / 3), Math.floor(faces / 3), [-0.3, 0.2, 0, 0], [0.4, 0, -0.5, 0]),
  region(0, 0, [0.1, 0.1, 0, 0], []),
];

async function sequenceWith(options: Partial<SequenceOptions> = {}): Promise<Sequence> {
  const keys = await engine.importKeyframes(poseFiles(mesh, poses), { keyTimes: KEYS });
  return engine.createSequence(keys, { hold: 'off', ...options });
}
const shapeAt = async (sequence: Sequence, t: number): Promise<Float32Array> => (await frameAt(sequence, t)).positions;

it.each<[name: string, options: Partial<SequenceOptions>]>([
  ['natural ends', {}],
  ['Hermite ends', { boundary: 'hermite', startSpeed: 0, endSpeed: 2 }],
  ['a loop', { boundary: 'periodic' }],
  ['tension and bias', { tension: [0, 0.5, 0, 0], bias: [0, 0.3, -0.4, 0] }],
  ['logarithmic stretch', { stretch: 'log' }],
  ['a ghost mesh', { ghostFaces: 80 }],
  ['exact numbers', { precision: 'exact' }],
])('change the motion between the keys only, with %s', async (_name, options) => {
  const sequence = await sequenceWith(options);
  const times = [0.3, 0.5, 1.4, 2.6];
  const plain = await Promise.all(times.map(async (t) => (await sequence.evaluateMany([t]))[0]!.positions.slice()));
  const before = (await sequence.evaluateMany([-0.4]))[0]!.positions.slice();
  await sequence.update({ regions });
  for (const [index, t] of times.entries())
    expect(largestDistance(await shapeAt(sequence, t), plain[index]!)).toBeGreaterThan(1e-3 * size);
  for (const [key, t] of KEYS.entries())
    expect(largestDistance(await shapeAt(sequence, t), poses[key]!)).toBeLessThan(1e-5 * size);
  if (options.boundary !== 'periodic') expect(await shapeAt(sequence, -0.4)).toEqual(before);
  sequence.dispose();
});

it('leave pinned vertices at their places, and still parts in place', async () => {
  const sequence = await sequenceWith();
  const vertex = mesh.positions.length / 3 - 1;
  const placed = async (change: MotionChange, t: number): Promise<Float32Array> => {
    await sequence.update(change);
    return (await shapeAt(sequence, t)).slice(3 * vertex, 3 * vertex + 3);
  };
  const pins = [{ vertex, radius: 0.1, stay: 0 }];
  const loose = await placed({ pins: [], regions }, 0.5);
  const pinned = await placed({ pins, regions: [] }, 0.5);
  const both = await placed({ pins, regions }, 0.5);
  expect(largestDistance(loose, pinned)).toBeGreaterThan(0.05 * size);
  expect(largestDistance(both, pinned)).toBeLessThan(0.15 * largestDistance(loose, pinned));

  const slides = async (change: MotionChange): Promise<number> => {
    await sequence.update({ pins: [], ...change });
    return Math.max(...(await sequence.measures([0.2, 0.5, 0.8])).sliding);
  };
  expect(await slides({ hold: 'on', regions })).toBeLessThan(0.7 * (await slides({ hold: 'off', regions })));
  sequence.dispose();
});

it('stop with the others at a key with tension 1', async () => {
  const sequence = await sequenceWith({ tension: [0, 1, 0, 0], regions });
  const speed = async (t: number): Promise<number> => {
    const shapes = (await sequence.evaluateMany([t - 1e-3, t + 1e-3])).map((frame) => frame.positions.slice());
    return largestDistance(shapes[0]!, shapes[1]!) / 2e-3;
  };
  expect(await speed(1)).toBeLessThan(0.02 * (await speed(0.5)));
  sequence.dispose();
});

it('are in exports, also with one target per key, whose stated error holds', async () => {
  const sequence = await sequenceWith({ regions });
  const { diagonal: diagonalOfKeys } = (await engine.importKeyframes(poseFiles(mesh, poses))).info.report;
  for (const targets of ['frames', 'principal'] as const) {
    const options = { format: 'glb', targets } as const;
    const plan = await sequence.planExport(options);
    const stated = plan.error! * diagonalOfKeys;
    const [file] = await sequence.export(options);
    await expectValid(file!.bytes);
    const player = await threePlayer(file!.bytes);
    let largest = 0;
    for (let i = 0; i <= 60; i += 1)
      largest = Math.max(largest, largestDistance(player.positionsAt(i / 20), await shapeAt(sequence, i / 20)));
    expect(largest).toBeLessThan(1.02 * stated + 1e-5 * size);
    expect(largest).toBeLessThan(0.02 * size);
  }
  sequence.dispose();
});
