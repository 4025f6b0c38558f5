import { beforeAll, describe, expect, it } from 'vitest';
import { measure } from '../../web/app/drawing/measures.ts';
import type { Sequence } from '../../web/engine/api/api.ts';
import { bendKeys, bendSequence, failureOf, frameAt, testEngine, type Bend } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { bar, diagonal, largestDistance, moved, type Mesh } from './support/shapes.ts';

const engine = testEngine();
let bend: Bend & { sequence: Sequence };

beforeAll(async () => {
  bend = await bendSequence(engine);
});

const positionsAt = async (sequence: Sequence, t: number): Promise<Float32Array> =>
  (await frameAt(sequence, t)).positions;

describe('a sequence', () => {
  it('passes through its keys for all boundaries, to 1e-5 of the diagonal in float32', async () => {
    for (const boundary of ['hermite', 'periodic', 'natural'] as const) {
      await bend.sequence.update({ boundary });
      for (const [key, t] of [0, 0.5, 1].entries()) {
        const pose = bend.poses[key]!;
        expect(largestDistance(await positionsAt(bend.sequence, t), pose)).toBeLessThan(1e-5 * diagonal(pose));
      }
    }
  });

  it('knows its times, its range and its options', () => {
    expect(bend.sequence.keyTimes).toEqual([0, 0.5, 1]);
    expect(bend.sequence.range).toEqual([0, 1]);
    expect(bend.sequence.options).toMatchObject({ method: 'lri', boundary: 'natural', reference: 0 });
  });

  it('gives unit normals that point outward', async () => {
    const { positions, normals } = await frameAt(bend.sequence, 0);
    let outward = 0;
    for (let i = 0; i < normals.length; i += 3) {
      expect(Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!)).toBeCloseTo(1, 5);
      outward += Math.sign(normals[i]! * positions[i]! + normals[i + 1]! * positions[i + 1]!);
    }
    expect(outward).toBeGreaterThan(0.8 * (normals.length / 3));
  });

  it('is pure: the same t gives the same bits, independent of earlier requests, in every worker', async () => {
    const first = await positionsAt(bend.sequence, 0.37);
    await positionsAt(bend.sequence, -2);
    await bend.sequence.update({ boundary: 'periodic', keyTimes: [0, 0.2, 3] });
    await positionsAt(bend.sequence, 0.9);
    await bend.sequence.update({ boundary: 'natural', keyTimes: [0, 0.5, 1] });
    expect(await positionsAt(bend.sequence, 0.37)).toEqual(first);
    const other = await engine.createSequence(bend.keys);
    expect(await positionsAt(other, 0.37)).toEqual(first);
    other.dispose();
  });

  it('keeps the volume of a bend that a blend of vertices loses', async () => {
    const mean = (values: number[]): number => values.reduce((a, b) => a + b) / values.length;
    const measured = async (): Promise<number> => {
      const { volume } = await bend.sequence.measures([0, 0.5, 1, 0.25, 0.75]);
      return Math.min(...volume.slice(3)) / mean(volume.slice(0, 3));
    };
    expect(await measured()).toBeGreaterThan(0.99);
    await bend.sequence.update({ method: 'linear' });
    expect(await measured()).toBeLessThan(0.96);
    await bend.sequence.update({ method: 'lri' });
  });

  it('rotates every face separately in rotation-strain coordinates, and refuses unsupported options', async () => {
    const sequence = await engine.createSequence(bend.keys, { method: 'rotation-strain', precision: 'exact' });
    for (const [key, t] of sequence.keyTimes.entries())
      expect(largestDistance(await positionsAt(sequence, t), bend.poses[key]!)).toBeLessThan(1e-6);
    const rival = await positionsAt(sequence, 0.3);
    const { volume } = await sequence.measures([0, 0.3]);
    expect(Math.abs(volume[1]! / volume[0]! - 1)).toBeLessThan(0.002);
    for (const change of [
      { hold: 'on' as const },
      { pins: [{ vertex: 0, radius: 0.1 }] },
      { turns: [{ key: 1, turns: 1 }] },
    ]) {
      const { code, message } = await failureOf(sequence.update(change));
      expect(code).toBe('invalid-option');
      expect(message).toMatch(/'lri'/);
    }
    await sequence.update({ method: 'lri' });
    // For a bar that bends in one plane, both methods agree.
    expect(largestDistance(await positionsAt(sequence, 0.3), rival)).toBeLessThan(1e-2);
    sequence.dispose();
  });

  it('measures an open surface like the page, at any position', async () => {
    const { positions, indices } = bar();
    const open = { positions: positions.map((value) => value + 7), indices: indices.slice(6) };
    const { keys } = await bendKeys(engine, open);
    const sequence = await engine.createSequence(keys);
    const { volume, area } = await sequence.measures([0.3]);
    const shown = measure((await frameAt(sequence, 0.3)).positions, keys.info.faces);
    expect(shown.volume).toBeCloseTo(volume[0]!, 3);
    expect(shown.area).toBeCloseTo(area[0]!, 3);
    sequence.dispose();
  });

  it('encodes and factors once, also when the time, options and key times change', async () => {
    const sequence = await engine.createSequence(bend.keys);
    const before = await sequence.stats();
    for (const t of [-0.4, 0, 0.3, 1, 1.4]) (await frameAt(sequence, t)).release();
    for (const boundary of ['hermite', 'periodic', 'natural'] as const) await sequence.update({ boundary });
    for (const method of ['geodesic', 'linear', 'cubic-vertex', 'rotation-strain', 'rimd', 'lri'] as const) {
      await sequence.update({ method });
      await frameAt(sequence, 0.3);
    }
    await sequence.update({ keyTimes: [0, 0.1, 5], startSpeed: 0.5, tension: [0, 0.5, 0], bias: [0.5, -1, 0] });
    await frameAt(sequence, 2);
    const after = await sequence.stats();
    // A recomputation would have taken a different time.
    expect([after.encodeMs, after.factorMs]).toEqual([before.encodeMs, before.factorMs]);
    expect(after.solves).toBeGreaterThan(before.solves);
    sequence.dispose();
  });

  it('changes the slope at a key by its bias: 0 changes no bit, and no key changes', async () => {
    const sequence = await engine.createSequence(bend.keys);
    const [plain, before] = [await positionsAt(sequence, 0.7), await positionsAt(sequence, 0.4)];
    await sequence.update({ bias: [0, 0, 0] });
    expect(await positionsAt(sequence, 0.7)).toEqual(plain);
    for (const bias of [1, -1]) {
      await sequence.update({ bias: [0, bias, 0] });
      expect(largestDistance(await positionsAt(sequence, 0.7), plain)).toBeGreaterThan(1e-3);
      expect(largestDistance(await positionsAt(sequence, 0.4), before)).toBeGreaterThan(1e-3);
      for (const [key, t] of sequence.keyTimes.entries()) {
        expect(largestDistance(await positionsAt(sequence, t), bend.poses[key]!)).toBeLessThan(1e-4);
      }
    }
    sequence.dispose();
  });

  it('changes the times of its keys', async () => {
    const sequence = await engine.createSequence(bend.keys, { boundary: 'hermite' });
    await sequence.update({ keyTimes: [-1, 3, 4] });
    expect([sequence.keyTimes, sequence.range]).toEqual([
      [-1, 3, 4],
      [-1, 4],
    ]);
    expect(largestDistance(await positionsAt(sequence, 3), bend.poses[1]!)).toBeLessThan(1e-4);
    sequence.dispose();
  });

  it('keeps its motion when an update is refused', async () => {
    const before = await positionsAt(bend.sequence, 0.7);
    const refused = [
      { keyTimes: [0, 0, 1] },
      { keyTimes: [0, 1] },
      { tension: [1] },
      { bias: [0, 1] },
      { turns: [{ key: 9, turns: 1 }] },
      { boundary: 'periodic' as const, period: 0.5 },
    ];
    const codes = [];
    for (const change of refused) codes.push((await failureOf(bend.sequence.update(change))).code);
    expect(codes).toEqual([
      'times-not-increasing',
      'time-count-mismatch',
      'invalid-option',
      'invalid-option',
      'invalid-option',
      'invalid-option',
    ]);
    expect(bend.sequence.options).toMatchObject({
      boundary: 'natural',
      tension: [],
      bias: [],
      turns: [],
      period: null,
    });
    expect(await positionsAt(bend.sequence, 0.7)).toEqual(before);
  });

  it('refuses options that do not fit its keys', async () => {
    const wrong: [object, string][] = [
      [{ reference: 3 }, 'invalid-option'],
      [{ tension: [0] }, 'invalid-option'],
      [{ turns: [{ key: 3, turns: 1 }] }, 'invalid-option'],
      [{ boundary: 'periodic', period: 0.5 }, 'invalid-option'],
      [{ startTangent: new Float32Array(6) }, 'vertex-count-mismatch'],
    ];
    for (const [options, code] of wrong) {
      expect([options, (await failureOf(engine.createSequence(bend.keys, options))).code]).toEqual([options, code]);
    }
  });

  it('gives the plane, the bending energy and the patches', async () => {
    const plane = await bend.sequence.shapePlane([0, 0.5, 0.75, 1]);
    expect(plane.keys).toHaveLength(6);
    expect(plane.curve).toHaveLength(8);
    expect(plane.explained).toBeGreaterThan(0.99);
    plane.curve.slice(0, 2).forEach((value, i) => expect(value).toBeCloseTo(plane.keys[i]!, 8));
    const energy = await bend.sequence.bendingEnergy([0, 0.25, 0.5]);
    expect(energy).toHaveLength(3);
    expect(energy.every((e) => Number.isFinite(e) && e >= 0)).toBe(true);
    for (const method of ['geodesic', 'linear'] as const) {
      const straight = await engine.createSequence(bend.keys, { method });
      const [start, between, key] = await straight.bendingEnergy([0, 0.25, 0.5]);
      expect(between!, method).toBeLessThan(1e-6 * key!);
      expect(start!, method).toBeLessThan(1e-6 * key!);
      expect(key!, method).toBeGreaterThan(10 * Math.max(...energy));
      straight.dispose();
    }
    const spacing = await bend.sequence.keySpacing();
    expect(spacing.distance).toHaveLength(2);
    expect(spacing.distance.every((distance) => distance > 0)).toBe(true);
    expect(spacing.tension).toHaveLength(3);
    expect(spacing.tension.every((tension) => tension >= 0 && tension <= 1)).toBe(true);
    const { speed, overshoot } = await bend.sequence.motionSpeed([0, 0.25, 0.5, 2]);
    expect(speed).toHaveLength(4);
    expect(speed.every((value) => value > 0)).toBe(true);
    expect(overshoot[3]).toBe(0);
    expect(overshoot.every((value) => value >= 0)).toBe(true);
    const patches = await bend.sequence.patches();
    const { patches: count } = await bend.sequence.stats();
    expect(patches).toHaveLength(bend.mesh.indices.length / 3);
    expect(Math.max(...patches)).toBe(count - 1);
    expect(Math.min(...patches)).toBe(0);
  });

  it('returns the component of each face, and adds turns to one component before a key', async () => {
    const [body, wheel] = [bar(2, 12), bar(2, 2, 1)];
    const shift = body.positions.length / 3;
    const turned = (degrees: number): number[] => {
      const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      return [...moved(wheel, (x, y, z) => [c * x - s * y + 2, s * x + c * y, z + 4])];
    };
    const pose = (degrees: number): Float32Array => Float32Array.from([...body.positions, ...turned(degrees)]);
    const mesh: Mesh = {
      positions: pose(0),
      indices: Uint32Array.from([...body.indices, ...[...wheel.indices].map((v) => v + shift)]),
    };
    const sequence = await engine.createSequence(await engine.importKeyframes(poseFiles(mesh, [pose(0), pose(60)])));
    expect((await sequence.stats()).components).toBe(2);
    const components = await sequence.components();
    expect([...components]).toEqual(
      Array.from({ length: mesh.indices.length / 3 }, (_, f) => (3 * f < body.indices.length ? 0 : 1)),
    );

    const expectTurned = async (t: number, degrees: number): Promise<void> => {
      // Accuracy of the rotation centre found from the keys.
      expect(largestDistance(await positionsAt(sequence, t), pose(degrees))).toBeLessThan(
        1e-3 * diagonal(mesh.positions),
      );
    };
    await expectTurned(0.5, 30);
    await sequence.update({ turns: [{ key: 1, turns: 1, component: 1 }] });
    await expectTurned(0.5, 210);
    await expectTurned(1, 60);
    await sequence.update({ turns: [{ key: 1, turns: -1, component: 1 }] });
    await expectTurned(0.5, -150);
    expect((await failureOf(sequence.update({ turns: [{ key: 1, turns: 1, component: 2 }] }))).code).toBe(
      'invalid-option',
    );
    await expectTurned(0.5, -150);
    sequence.dispose();
  });

  it('resolves replaced requests to null and the last one to its frame', async () => {
    const times = Array.from({ length: 20 }, (_, i) => i / 10);
    const frames = await Promise.all(times.map((t) => bend.sequence.evaluate(t)));
    const shown = frames.filter((frame) => frame !== null);
    expect(frames.at(-1)?.t).toBe(1.9);
    expect(shown.length).toBeLessThan(times.length);
    expect(frames.at(-1)?.positions).toEqual(await positionsAt(bend.sequence, 1.9));
  });

  it('gives every frame of a series, and handles other requests meanwhile', async () => {
    const order: string[] = [];
    const many = bend.sequence.evaluateMany([0, 0.25, 0.5, 0.75, 1]).then((frames) => {
      order.push('series');
      return frames;
    });
    await frameAt(bend.sequence, 0.1);
    order.push('frame');
    expect((await many).map(({ t }) => t)).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(order).toEqual(['frame', 'series']);
  });

  it('reports growing progress while it is built', async () => {
    const fractions: number[] = [];
    const stages = new Set<string>();
    const onProgress = ({ stage, fraction }: { stage: string; fraction: number }): void => {
      stages.add(stage);
      fractions.push(fraction);
    };
    (await engine.createSequence(bend.keys, {}, { onProgress })).dispose();
    expect(fractions).toEqual(fractions.slice().sort((a, b) => a - b));
    expect(fractions.at(-1)).toBe(1);
    expect(stages.size).toBeGreaterThan(1);
  });

  it('can be made and disposed of many times', async () => {
    for (let i = 0; i < 20; ++i) {
      const sequence = await engine.createSequence(bend.keys);
      await frameAt(sequence, i / 20);
      sequence.dispose();
      sequence.dispose();
      expect((await failureOf(sequence.evaluate(0))).code).toBe('disposed');
    }
  });
});

describe('arranged keys', () => {
  it('give further sequences without another import', async () => {
    const { keys, poses } = await bendKeys(engine);
    const arranged = keys.arrange([2, 0], [0, 1]).withPose('last', 2, poses[1]!);
    keys.dispose();
    const sequence = await engine.createSequence(arranged);
    for (const [t, pose] of [
      [0, 2],
      [1, 0],
      [2, 1],
    ] as const) {
      expect(largestDistance(await positionsAt(sequence, t), poses[pose]!)).toBeLessThan(1e-4);
    }
    sequence.dispose();
  });
});
