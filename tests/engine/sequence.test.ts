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
  it('knows its times, its range and its options', () => {
    expect(bend.sequence.keyTimes).toEqual([0, 0.5, 1]);
    expect(bend.sequence.range).toEqual([0, 1]);
    expect(bend.sequence.options).toMatchObject({ method: 'lri', boundary: 'natural', reference: 0 });
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
});

describe('an update to a method that lacks an inherited option', () => {
  it('leaves the option out and says so', async () => {
    const { keys } = await bendKeys(engine);
    const sequence = await engine.createSequence(keys, { hold: 'on' });
    await sequence.update({ method: 'linear' });
    expect(sequence.warnings).toMatchObject([{ code: 'option-left-out', message: expect.stringMatching(/'linear'/) }]);
    await sequence.update({ method: 'cubic-vertex' });
    expect(sequence.warnings.map(({ code }) => code)).not.toContain('option-left-out');
    sequence.dispose();
    keys.dispose();
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
