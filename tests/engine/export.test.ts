import { readFileSync } from 'node:fs';
import { WebIO, type Accessor, type Primitive } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { MeshoptDecoder } from 'meshoptimizer';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Sequence } from '../../web/engine/api/api.ts';
import type { ExportedFile } from '../../web/engine/api/types.ts';
import { draco, meshopt, quantised } from './support/compress.ts';
import { bendKeys, bendSequence, failureOf, frameAt, testEngine, type Bend } from './support/engines.ts';
import { expectPlayed, expectValid, exported } from './support/exported.ts';
import { paintedFile } from './support/painted.ts';
import { rigFile } from './support/rig.ts';
import { bar, diagonal, largestDistance } from './support/shapes.ts';
import { threePlayer } from './support/three-player.ts';

/** The JSON chunk of a GLB. */
function jsonOf(bytes: Uint8Array): unknown {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
}

/** The primitive of a document, read by glTF-Transform. */
async function primitiveOf(bytes: Uint8Array): Promise<Primitive> {
  await MeshoptDecoder.ready;
  const io = new WebIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  const document = await io.readBinary(bytes as Uint8Array<ArrayBuffer>);
  return document.getRoot().listMeshes()[0]!.listPrimitives()[0]!;
}

/** Number of targets per number type of their normals. */
async function targetNormals(bytes: Uint8Array): Promise<{ float: number; short: number }> {
  const arrays = (await primitiveOf(bytes)).listTargets().map((target) => target.getAttribute('NORMAL')!.getArray());
  const float = arrays.filter((array) => array instanceof Float32Array).length;
  return { float, short: arrays.length - float };
}

/** Sums of the base's and each target's normals, by vertex number. */
async function shownNormals(bytes: Uint8Array): Promise<Float32Array[]> {
  const primitive = await primitiveOf(bytes);
  const numbers = primitive.getAttribute('_SHAPESPLINE_VERTEX')!;
  const base = primitive.getAttribute('NORMAL')!;
  const elements = (accessor: Accessor, i: number): number[] => accessor.getElement(i, []);
  return primitive.listTargets().map((target) => {
    const normals = new Float32Array(3 * base.getCount());
    for (let i = 0; i < base.getCount(); i += 1) {
      const added = elements(target.getAttribute('NORMAL')!, i);
      normals.set(
        elements(base, i).map((value, c) => value + added[c]!),
        3 * numbers.getScalar(i),
      );
    }
    return normals;
  });
}

const engine = testEngine();
let bend: Bend & { sequence: Sequence };
const size = (): number => diagonal(bend.poses[0]!);

beforeAll(async () => {
  bend = await bendSequence(engine);
});

describe('an animated GLB', () => {
  it('passes the official validator, and three.js plays the computed vertices', async () => {
    const options = { frames: 20, range: [-0.3, 1.3] as [number, number], duration: 4 };
    const { times } = await bend.sequence.planExport(options);
    const bytes = await exported(bend.sequence, options);
    await expectValid(bytes);
    const player = await threePlayer(bytes);
    expect(player.duration).toBeCloseTo(4, 6);
    expect(player.times).toHaveLength(times.length);
    expect(times).toHaveLength(23); // the three keys are not on this grid
    for (const [index, t] of times.entries()) {
      const computed = (await frameAt(bend.sequence, t)).positions;
      expect(largestDistance(player.positionsAt(player.times[index]!), computed)).toBeLessThan(1e-4 * size());
    }
  });

  it.each([
    ['textures, a normal map, two materials and seams', async () => paintedFile()],
    ['the same, compressed with meshopt and quantised', async () => (await meshopt([await paintedFile()]))[0]!],
    ['the same, compressed with Draco', async () => (await draco([await paintedFile()]))[0]!],
    ['the same, quantised', async () => quantised(await paintedFile())],
    ['a skin, morph targets and several parts', async () => rigFile()],
  ])('of an input with %s is valid, plays the computed vertices and keeps the look', async (_, make) => {
    const file = await make();
    const keys = await engine.importKeyframes([file]);
    const sequence = await engine.createSequence(keys);
    const bytes = await expectPlayed(sequence, { frames: 6, range: [sequence.range[0] - 0.2, sequence.range[1]] });
    const again = (await engine.importKeyframes([{ name: 'again.glb', bytes }])).info;
    const plain = keys.info.scene.materials.length === 0; // then the export has a default one
    if (!plain) expect(again.scene.materials).toEqual(keys.info.scene.materials);
    expect(again.scene.groups).toEqual(
      keys.info.scene.groups.map((group) => (plain ? { ...group, material: 0 } : group)),
    );
    expect(again.scene.images).toEqual(keys.info.scene.images);
    expect(again.scene.uvs).toEqual(keys.info.scene.uvs);
    expect(again.faces).toEqual(keys.info.faces);
    if (file.name === 'painted.glb') {
      expect(keys.info.scene.materials.map(({ name }) => name)).toEqual(['skin', 'cloth']);
      expect(keys.info.scene.materials[0]!.normalImage).toBeGreaterThanOrEqual(0);
      expect(keys.info.report.weldedVertices).toBeLessThan(keys.info.report.vertices / 4);
    }
    sequence.dispose();
  });

  it('opens again as the same project, also if the range excludes keys', async () => {
    const { sequence } = await bendSequence(engine, {
      boundary: 'hermite',
      startSpeed: 0,
      stretch: 'log',
      endTangent: bend.poses[0]!,
    });
    await sequence.update({
      keyTimes: [2, 3, 7],
      tension: [0, 0.5, 0],
      bias: [0, -0.5, 0],
      turns: [{ key: 1, turns: 1 }],
    });
    for (const range of [null, [2.5, 4] as [number, number]]) {
      const bytes = await exported(sequence, { frames: 9, range, duration: 2 });
      await expectValid(bytes);
      const keys = await engine.importKeyframes([{ name: 'project.glb', bytes }]);
      expect(keys.info.names).toEqual(bend.keys.info.names);
      expect(keys.info.times).toEqual([2, 3, 7]);
      expect(keys.info.project).toEqual(sequence.options);
      const again = await engine.createSequence(keys, { ...keys.info.project });
      for (const t of [2, 2.2, 5, 9]) {
        const [a, b] = [await frameAt(sequence, t), await frameAt(again, t)];
        // float32 rounds the keys, and extrapolation magnifies this.
        expect(largestDistance(a.positions, b.positions)).toBeLessThan((t > 7 ? 1e-3 : 1e-5) * size());
      }
      again.dispose();
    }
    sequence.dispose();
  });

  it('opens again as the same motion if parts are equally close at several locations', async () => {
    const keys = await engine.importKeyframes([await rigFile()], { animation: 'nod', sample: [0, 0.4, 1.1, 2.2, 3] });
    for (const precision of ['single', 'exact'] as const) {
      const sequence = await engine.createSequence(keys, { precision });
      const file = await engine.importKeyframes([
        { name: 'project.glb', bytes: await exported(sequence, { frames: 12 }) },
      ]);
      const again = await engine.createSequence(file, { ...file.info.project });
      for (const t of [0.2, 0.65, 1.6, 2.5]) {
        const [a, b] = [await frameAt(sequence, t), await frameAt(again, t)];
        // The keys themselves differ by 1.5e-7 in single precision, 2e-8 in double.
        expect(largestDistance(a.positions, b.positions)).toBeLessThan(
          (precision === 'single' ? 2e-6 : 2e-7) * keys.info.report.diagonal,
        );
      }
      sequence.dispose();
      again.dispose();
    }
  });

  it('plays back and forth with the same shapes, and opens again as the same keys at the same speed', async () => {
    const options = { frames: 5, duration: 4, bounce: true };
    const bytes = await exported(bend.sequence, options);
    await expectValid(bytes);
    const player = await threePlayer(bytes);
    expect(player.times).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    for (const second of [0, 1, 2, 3, 4, 5.5, 7, 8]) {
      const t = (second <= 4 ? second : 8 - second) / 4;
      if (t % 0.25 !== 0) continue;
      const computed = (await frameAt(bend.sequence, t)).positions;
      expect(largestDistance(player.positionsAt(second), computed)).toBeLessThan(1e-4 * size());
    }
    const { info } = await engine.importKeyframes([{ name: 'a.glb', bytes }]);
    expect([info.times, info.speed]).toEqual([[0, 0.5, 1], 0.25]);
    const [principal] = await bend.sequence.export({ ...options, frames: null, targets: 'principal' });
    await expectValid(principal!.bytes);
    const rig = await threePlayer(principal!.bytes);
    expect(rig.duration).toBeCloseTo(8, 5);
    expect(largestDistance(rig.positionsAt(6), (await frameAt(bend.sequence, 0.5)).positions)).toBeLessThan(
      2e-3 * size(),
    );
  });

  it('has the fewest targets for its tolerance, states its error, and is exact at the keys', async () => {
    const targets: number[] = [];
    for (const tolerance of [1, 0.1, 0.02]) {
      const plan = await bend.sequence.planExport({ tolerance });
      const bytes = await exported(bend.sequence, { tolerance });
      await expectValid(bytes);
      const player = await threePlayer(bytes);
      expect(player.times).toHaveLength(plan.times.length);
      let largest = 0;
      for (let i = 0; i <= 200; i += 1)
        largest = Math.max(
          largest,
          largestDistance(player.positionsAt(i / 200), (await frameAt(bend.sequence, i / 200)).positions),
        );
      const { diagonal: whole } = bend.keys.info.report;
      expect(largest).toBeLessThan((tolerance / 100) * whole);
      expect(largest).toBeLessThan(1.02 * plan.error! * whole);
      expect(largest).toBeGreaterThan(0.95 * plan.error! * whole);
      for (const [key, t] of bend.keys.info.times.entries())
        expect(largestDistance(player.positionsAt(t), bend.poses[key]!)).toBeLessThan(1e-6 * whole);
      const { extras } = jsonOf(bytes) as { extras: { shapespline: { mesh: { error: number } } } };
      expect(extras.shapespline.mesh.error).toBe(plan.error);
      targets.push(plan.targets);
    }
    expect(targets).toEqual([...targets].sort((a, b) => a - b));
    expect(targets[1]).toBeLessThan(30);
  });

  it('names its nodes, mesh, materials and targets', async () => {
    const bytes = await exported(bend.sequence, { frames: 3, name: 'bar' });
    const json = jsonOf(bytes) as Record<string, { name: string; extras?: { targetNames: string[] } }[]>;
    expect([json.nodes, json.meshes, json.animations].map((list) => list![0]!.name)).toEqual(['bar', 'bar', 'bar']);
    expect(json.materials![0]!.name).toBe('plain');
    expect(json.meshes![0]!.extras!.targetNames).toEqual(
      bend.keys.info.names.slice(1).map((name, i) => `${name} t=${0.5 * (i + 1)}`),
    );
  });

  it('a shape without a material looks everywhere as on the page', async () => {
    const [, clay] = /const CLAY = '#([0-9a-f]{6})'/.exec(readFileSync('web/viewer/shape.ts', 'utf8'))!;
    const linear = [0, 2, 4].map((at) => {
      const share = Number.parseInt(clay!.slice(at, at + 2), 16) / 255;
      return ((share + 0.055) / 1.055) ** 2.4;
    });
    const { materials } = jsonOf(await exported(bend.sequence, { frames: 3 })) as {
      materials: { pbrMetallicRoughness: { baseColorFactor: number[] } }[];
    };
    const { baseColorFactor } = materials[0]!.pbrMetallicRoughness;
    for (const [channel, value] of linear.entries()) expect(baseColorFactor[channel]).toBeCloseTo(value, 2);
  });

  it.each(['quantized', 'meshopt'] as const)(
    'is smaller when %s, says what that costs, and opens again',
    async (compression) => {
      const { keys, poses } = await bendKeys(engine, bar(8, 80));
      const sequence = await engine.createSequence(keys);
      const options = { frames: 20 };
      const plain = await exported(sequence, options);
      const bytes = await exported(sequence, { ...options, compression });
      await expectValid(bytes);
      const { float, short } = await targetNormals(bytes);
      expect(short).toBeGreaterThan(float); // the bar's normals rotate by up to 80 degrees
      // Of 24 bytes per vertex, 8 remain for the position (16 bits per coordinate, padded), and 8 for the normal if it
      // fits.
      const quantized = (8 + (8 * short + 12 * float) / (short + float)) / 24;
      // Smooth surfaces move so evenly that they need fewer bits than the stored 16 and 12 per coordinate.
      const most = compression === 'quantized' ? quantized + 0.02 : (3 * (16 + 12)) / 8 / 24;
      expect(bytes.length).toBeLessThan(most * plain.length);
      const stated = (await sequence.planExport({ ...options, compression })).bytes / bytes.length;
      expect(stated).toBeGreaterThan(0.85);
      expect(stated).toBeLessThan(2);
      const [normals, wanted] = [await shownNormals(bytes), await shownNormals(plain)];
      // The error is at most half a step of the base and of the target along each axis.
      for (const [target, values] of normals.entries())
        expect(largestDistance(values, wanted[target]!)).toBeLessThan(Math.sqrt(3) / (2 ** 11 - 1));
      const again = await engine.importKeyframes([{ name: 'small.glb', bytes }]);
      expect(again.info.warnings).toEqual([]);
      expect(again.info.project).toEqual(sequence.options);
      expect(again.info.faces.length).toBe(keys.info.faces.length);
      for (const [key, pose] of poses.entries())
        expect(largestDistance(again.positions(key), pose)).toBeLessThan(6e-5 * keys.info.report.diagonal);
      sequence.dispose();
    },
  );

  it('of keys and in-betweens plays within the tolerance, with a table and drivers, and opens again', async () => {
    const options = { targets: 'principal', tolerance: 0.1 } as const;
    const plan = await bend.sequence.planExport(options);
    const files = await bend.sequence.export(options);
    expect(files.map(({ name }) => name)).toEqual(['shapespline.glb', 'shapespline.csv', 'shapespline.py']);
    const { bytes } = files[0]!;
    await expectValid(bytes);
    const player = await threePlayer(bytes);
    const { diagonal: whole } = bend.keys.info.report;
    for (let i = 0; i <= 100; i += 1)
      expect(
        largestDistance(player.positionsAt(i / 100), (await frameAt(bend.sequence, i / 100)).positions),
      ).toBeLessThan(1e-3 * whole);
    expect(plan.targets).toBeLessThan((await bend.sequence.planExport({ tolerance: 0.1 })).targets);
    const again = await engine.importKeyframes([{ name: 'rig.glb', bytes }]);
    expect(again.info.names).toEqual(bend.keys.info.names);
    for (const [key, pose] of bend.poses.entries())
      expect(largestDistance(again.positions(key), pose)).toBeLessThan(1e-6 * whole);
  });

  it('of keys and in-betweens has its weights at the requested times', async () => {
    const options = { targets: 'principal', frames: 24 } as const;
    const plan = await bend.sequence.planExport(options);
    expect(plan.times).toEqual((await bend.sequence.planExport({ frames: 24 })).times);
    expect(plan.targets).toBeLessThan(8);
    const [{ bytes }, table] = (await bend.sequence.export(options)) as [ExportedFile, ExportedFile];
    await expectValid(bytes);
    expect(new TextDecoder().decode(table.bytes).trim().split('\n')).toHaveLength(1 + plan.times.length);
    const player = await threePlayer(bytes);
    const { diagonal: whole } = bend.keys.info.report;
    const off = async (t: number): Promise<number> =>
      largestDistance(player.positionsAt(t), (await frameAt(bend.sequence, t)).positions) / whole;
    for (const t of plan.times) expect(await off(t)).toBeLessThan(1e-3);
    let largest = 0;
    for (let i = 0; i <= 300; i += 1) largest = Math.max(largest, await off(i / 300));
    expect(largest).toBeLessThan(1.01 * plan.error!);
    // With only two shapes, linear interpolation between few weights has large errors, which are reported.
    const rough = await bend.sequence.planExport({ ...options, frames: 2 });
    expect(rough.times).toEqual([0, 0.5, 1]);
    expect(rough.error).toBeGreaterThan(10 * plan.error!);
  });

  it('in place has no overall translation', async () => {
    const centre = (positions: Float64Array): number =>
      positions.reduce((sum, value, i) => (i % 3 === 1 ? sum + value : sum), 0);
    const keys = bend.keys.arrange([0, 0], [0, 1]);
    const lifted = keys.withPose(
      'lifted',
      2,
      bend.poses[0]!.map((value, i) => (i % 3 === 1 ? value + 20 : value)),
    );
    const sequence = await engine.createSequence(lifted);
    const lift = async (inPlace: boolean): Promise<number> => {
      const player = await threePlayer(await exported(sequence, { frames: 3, inPlace }));
      return (centre(player.positionsAt(2)) - centre(player.positionsAt(0))) / (bend.poses[0]!.length / 3);
    };
    expect(await lift(false)).toBeCloseTo(20, 3);
    expect(Math.abs(await lift(true))).toBeLessThan(1e-3);
    expect(sequence.options.inPlace).toBe(false);
    sequence.dispose();
  });
});

describe('single shapes and series of files', () => {
  it('are numbered files, exactly one for each requested time', async () => {
    const files = await bend.sequence.export({ format: 'obj', times: [1.3, -0.3, 0.5] });
    expect(files.map(({ name }) => name)).toEqual(['0000.obj', '0001.obj', '0002.obj']);
    const keys = await engine.importKeyframes(files);
    expect(largestDistance(keys.positions(0), (await frameAt(bend.sequence, 1.3)).positions)).toBeLessThan(1e-5);
    const plan = await bend.sequence.planExport({ format: 'obj', times: [1.3, -0.3, 0.5] });
    const written = files.reduce((sum, { bytes }) => sum + bytes.length, 0);
    expect(Math.abs(plan.bytes - written)).toBeLessThan(0.35 * written);
  });

  it('are made one by one, until the caller stops', async () => {
    const fractions: number[] = [];
    const options = { format: 'obj', frames: 50 } as const;
    const taken: string[] = [];
    for await (const { name } of bend.sequence.exportFiles(options, {
      onProgress: (p) => fractions.push(p.fraction),
    })) {
      taken.push(name);
      if (taken.length === 2) break;
    }
    expect(taken).toEqual(['0000.obj', '0001.obj']);
    expect(fractions).toHaveLength(2);
    expect(await bend.sequence.export({ frames: 2 })).toHaveLength(1);
  });

  it('report progress and refuse wrong options', async () => {
    const fractions: number[] = [];
    await bend.sequence.export({ frames: 4 }, { onProgress: ({ fraction }) => fractions.push(fraction) });
    expect(fractions).toEqual(fractions.slice().sort((a, b) => a - b));
    expect(fractions.at(-1)).toBe(1);
    expect((await failureOf(bend.sequence.export({ frames: 0 }))).code).toBe('invalid-option');
    expect((await failureOf(bend.sequence.export({ frame: 4 } as object))).code).toBe('invalid-option');
  });
});
