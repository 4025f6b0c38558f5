/** Methods that fit shapes while a motion is made: kept measures, unsupported options, cancellation. */
import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import { dataFile, hasData } from './support/data.ts';
import { bendKeys, failureOf, frameAt, testEngine } from './support/engines.ts';
import { bar, bent, diagonal, foam, largestDistance, rolledSheet, type Mesh } from './support/shapes.ts';

const engine = testEngine();

/** The same triangles, reduced in size, each with its own vertices. */
function apart({ indices, positions }: Mesh): Mesh {
  const moved = new Float32Array(3 * indices.length);
  indices.forEach((vertex, corner) => {
    const start = corner - (corner % 3);
    for (let axis = 0; axis < 3; ++axis) {
      const mean = [0, 1, 2].reduce((sum, c) => sum + positions[3 * indices[start + c]! + axis]! / 3, 0);
      moved[3 * corner + axis] = mean + 0.9 * (positions[3 * vertex + axis]! - mean);
    }
  });
  return { indices: indices.map((_, corner) => corner), positions: moved };
}

async function importSheet(n: number): Promise<{ keys: Keys; poses: Float32Array[] }> {
  const { faces, poses } = rolledSheet(n, 3.5);
  const keys = await engine.createKeys({
    faces,
    poses: poses.map((positions, i) => ({ name: `${i}`, time: i, positions })),
  });
  return { keys, poses };
}

describe('lengths', () => {
  it('keeps the area of a sheet that LRI space stretches, passes through the keys, and is pure', async () => {
    const { keys, poses } = await importSheet(14);
    const changes: number[] = [];
    for (const method of ['lri', 'lengths', 'shell'] as const) {
      const sequence = await engine.createSequence(keys, { method, spaceSamples: 12 });
      for (const [key, pose] of poses.entries()) {
        const { positions } = await frameAt(sequence, key);
        expect(largestDistance(positions, pose)).toBeLessThan(1e-5 * diagonal(pose));
      }
      const { area } = await sequence.measures([0, 0.3, 0.5]);
      changes.push(Math.max(Math.abs(area[1]! / area[0]! - 1), Math.abs(area[2]! / area[0]! - 1)));
      const first = (await frameAt(sequence, 0.37)).positions.slice();
      await frameAt(sequence, 1.4);
      expect((await frameAt(sequence, 0.37)).positions).toEqual(first);
      expect(sequence.fitted).toEqual(method === 'lri' ? null : [true]);
      // The strongly bent sheet also gets a warning about times beyond the keys, by the numbers of the user's keys.
      const { warnings } = sequence;
      const others = warnings.filter(({ code }) => code !== 'open-beyond-keys').map(({ code }) => code);
      expect(others).toEqual([]);
      for (const { code, key, message } of warnings) {
        if (code !== 'open-beyond-keys') continue;
        expect(message).toMatch(key === 0 ? /^Before key 1 / : /^Beyond key 2 /);
      }
      expect(sequence.keyTimes).toEqual([0, 1]);
      expect(sequence.options.method).toBe(method);
      sequence.dispose();
    }
    const [lri, lengths] = changes as [number, number, number];
    expect(lri).toBeGreaterThan(0.003);
    expect(lengths).toBeLessThan(0.001);
  });

  it('has a curve in the plane of the keys, through the keys and outside the plane between them', async () => {
    const { keys } = await importSheet(14);
    const times = [0, 0.5, 1];
    const spline = await engine.createSequence(keys);
    const expected = await spline.shapePlane(times);
    const [x, y, u, v] = expected.keys as [number, number, number, number];
    for (const options of [{ method: 'lengths' }, { method: 'shell', inPlace: true }, { keepLengths: 1 }] as const) {
      const sequence = await engine.createSequence(keys, { ...options, spaceSamples: 6 });
      const { keys: points, curve, distance } = await sequence.shapePlane(times);
      expect(points).toEqual(expected.keys);
      for (const i of [0, 1, 4, 5]) expect(curve[i]).toBeCloseTo(expected.curve[i]!, 3);
      expect(distance[1]).toBeGreaterThan(0.02);
      expect(distance[1]).toBeGreaterThan(3 * Math.max(distance[0]!, distance[2]!));
      expect(Math.hypot(curve[2]! - (x + u) / 2, curve[3]! - (y + v) / 2)).toBeLessThan(0.2 * Math.hypot(u - x, v - y));
      expect((await sequence.shapePlane([])).curve).toEqual([]);
      sequence.dispose();
    }
    spline.dispose();
  });

  it('transfers the motion of a coarse mesh to a larger shape', async () => {
    const { keys, poses } = await bendKeys(engine, bar(4, 40));
    const options = { method: 'lengths', spaceFaces: 200, spaceSamples: 6 } as const;
    const sequence = await engine.createSequence(keys, options);
    for (const [key, t] of [0, 0.5, 1].entries()) {
      const { positions } = await frameAt(sequence, t);
      expect(largestDistance(positions, poses[key]!)).toBeLessThan(1e-5 * diagonal(poses[key]!));
    }
    const { volume } = await sequence.measures([0, 0.2, 0.7]);
    for (const one of volume) expect(Math.abs(one / volume[0]! - 1)).toBeLessThan(0.002);
    sequence.dispose();
  });

  it('has about the bending of LRI space, in the same unit, for similar motions', async () => {
    const { keys } = await bendKeys(engine);
    const [plain, fitted] = [
      await engine.createSequence(keys),
      await engine.createSequence(keys, { method: 'lengths', spaceSamples: 8 }),
    ];
    const [ours] = await plain.bendingEnergy([0.5]);
    const [theirs] = await fitted.bendingEnergy([0.5]);
    expect(theirs! / ours!).toBeGreaterThan(0.5);
    expect(theirs! / ours!).toBeLessThan(2);
  });

  it('is one of several motions of a shape, and ends with it', async () => {
    const { keys } = await importSheet(5);
    const shape = await engine.encode(keys);
    const plain = await shape.motion();
    const fitted = await shape.motion({ method: 'lengths', spaceSamples: 4, keyTimes: [0, 3] });
    expect(fitted.keyTimes).toEqual([0, 3]);
    expect((await fitted.keySpacing()).distance).toHaveLength(1);
    const at = (await frameAt(fitted, 1.5)).positions;
    expect(largestDistance(at, (await frameAt(plain, 0.5)).positions)).toBeGreaterThan(1e-3);
    shape.dispose();
    expect((await failureOf(fitted.evaluate(0))).code).toBe('disposed');
  });

  it('refuses unsupported options, updates, and blends of keys', async () => {
    const { keys, poses } = await importSheet(4);
    for (const [options, what] of [
      [{ hold: 'on' }, 'keeping resting parts in place'],
      [{ pins: [{ vertex: 0, radius: 0.1 }] }, 'pins'],
      [{ boundary: 'periodic' }, "ends other than 'natural'"],
      [{ boundary: 'hermite' }, "ends other than 'natural'"],
      [{ startTangent: poses[0]! }, 'end tangents'],
      [{ tension: [0.5, 0] }, 'tension'],
      [{ turns: [{ key: 1, turns: 1 }] }, 'full turns'],
    ] as const) {
      const failure = await failureOf(engine.createSequence(keys, { ...options, method: 'lengths' } as object));
      expect(failure.code).toBe('invalid-option');
      expect(failure.message).toBe(`The method 'lengths' does not support ${what}. Use the method 'lri'.`);
    }
    const sequence = await engine.createSequence(keys, { method: 'lengths', spaceSamples: 2 });
    expect((await failureOf(sequence.update({ method: 'lri' }))).message).toMatch(/make a new sequence/);
    expect((await failureOf(sequence.evaluateBlend([0.5, 0.5]))).code).toBe('invalid-option');
    const plain = await engine.createSequence(keys);
    expect((await failureOf(plain.update({ method: 'lengths' }))).message).toMatch(/make a new sequence/);
  });

  it('refuses a shape whose coarse mesh stays too large, and can use thousands of loose triangles', async () => {
    const keysOf = (mesh: Mesh): Promise<Keys> => {
      const poses = [mesh.positions, bent(mesh, 40, 1)];
      return engine.createKeys({
        faces: mesh.indices,
        poses: poses.map((at, time) => ({ name: `${time}`, time, positions: at })),
      });
    };
    const options = { method: 'lengths', spaceSamples: 2 } as const;
    const failure = await failureOf(engine.createSequence(await keysOf(foam(9)), options));
    expect(failure.code).toBe('invalid-option');
    expect(failure.message).toMatch(
      /^The shape cannot be simplified enough: its coarse mesh still has 4,\d{3} faces, .* 4,000/,
    );
    const sequence = await engine.createSequence(await keysOf(apart(foam(9))), options);
    expect((await frameAt(sequence, 0.5)).positions.every(Number.isFinite)).toBe(true);
  });

  it('can be cancelled, and reports progress', async () => {
    const { keys } = await importSheet(12);
    const abort = new AbortController();
    const fractions: number[] = [];
    const work = engine.createSequence(
      keys,
      { method: 'shell' },
      {
        signal: abort.signal,
        onProgress: ({ stage, fraction }) => {
          fractions.push(fraction);
          if (stage === 'fitting lengths') abort.abort();
        },
      },
    );
    expect((await failureOf(work)).code).toBe('cancelled');
    expect(fractions.every((one, i) => i === 0 || one >= fractions[i - 1]!)).toBe(true);
    const again = await engine.createSequence(keys, { method: 'lengths', spaceSamples: 3 });
    expect(again.range).toEqual([0, 1]);
  });

  it("writes a project of the user's own keys", async () => {
    const { keys } = await importSheet(4);
    const sequence = await engine.createSequence(keys, { method: 'lengths', spaceSamples: 6, spaceFaces: 500 });
    const files = await sequence.export();
    const back = await engine.importKeyframes(files);
    expect(back.info.times).toEqual([0, 1]);
    expect(back.info.project).toMatchObject({ method: 'lengths', spaceSamples: 6, spaceFaces: 500 });
  });

  it.skipIf(!hasData)(
    'bends a walk less than LRI space, in every interval @all',
    async () => {
      const keys = await engine.importKeyframes([dataFile('skin/CesiumMan.glb')], { sample: 12 });
      const shape = await engine.encode(keys);
      const [start, end] = [keys.info.times[0]!, keys.info.times.at(-1)!];
      const times = Array.from({ length: 60 }, (_, i) => start + ((end - start) * i) / 59);
      const [lri, lengths, shell] = await Promise.all(
        (['lri', 'lengths', 'shell'] as const).map(async (method) => {
          const motion = await shape.motion({ method });
          const warned = (code: string): number[] =>
            motion.warnings.filter((one) => one.code === code).map(({ key }) => key);
          const bending = await motion.shellBending(times);
          return {
            mean: bending.reduce((sum, one) => sum + one / times.length, 0),
            notFitted: [...warned('lengths-not-fitted'), ...warned('bending-not-minimised')],
          };
        }),
      );
      // With a shape whose triangles collapse, the bending would be twice that of LRI space.
      expect(lengths!.mean).toBeLessThan(0.95 * lri!.mean);
      expect(shell!.mean).toBeLessThan(lengths!.mean);
      expect([lengths!.notFitted, shell!.notFitted]).toEqual([[], []]);
    },
    60_000,
  );

  const saddle = ['turns/saddle/monkey_saddle_1.ply', 'turns/saddle/monkey_saddle_2.ply'];

  it.skipIf(!hasData)('says that LRI bends less where neighbouring fits are far apart', async () => {
    const keys = await engine.importKeyframes(saddle.map(dataFile), { keyTimes: [0, 1] });
    const sequence = await engine.createSequence(keys, { method: 'lengths', spaceSamples: 24 });
    expect(sequence.fitted).toEqual([true]);
    expect(sequence.warnings.map(({ code }) => code)).toContain('bends-more-than-lri');
  });
});
