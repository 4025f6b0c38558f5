/** A shape encoded once, and its motions. */
import { describe, expect, it } from 'vitest';
import type { Shape } from '../../web/engine/api/api.ts';
import { bendKeys, failureOf, frameAt, testEngine } from './support/engines.ts';

const TIMES = [-0.3, 0, 0.2, 0.7, 1.4];

async function encoded(): Promise<{ engine: ReturnType<typeof testEngine>; shape: Shape }> {
  const engine = testEngine();
  const { keys } = await bendKeys(engine);
  return { engine, shape: await engine.encode(keys) };
}

describe('a shape', () => {
  it('has any number of motions with one encoding; each equals that of a separate sequence', async () => {
    const engine = testEngine();
    const { keys } = await bendKeys(engine);
    const shape = await engine.encode(keys);
    await shape.motion();
    const before = await shape.stats();
    const choices = [
      {},
      { method: 'linear' as const },
      { method: 'cubic-vertex' as const },
      { method: 'geodesic' as const },
      { method: 'rotation-strain' as const },
      { method: 'rimd' as const },
      { boundary: 'hermite' as const, startSpeed: 0 },
      { keyTimes: keys.info.times.map((t) => t * t) },
    ];
    const motions = await Promise.all(choices.map((options) => shape.motion(options)));
    for (const t of TIMES)
      for (const [index, { keyTimes, ...options }] of choices.entries() as IterableIterator<
        [number, { keyTimes?: number[] }]
      >) {
        const sequence = await engine.createSequence(keys, options);
        if (keyTimes) await sequence.update({ keyTimes });
        const [own, shared] = [await frameAt(sequence, t), await frameAt(motions[index]!, t)];
        expect(shared.positions).toEqual(own.positions);
        expect(shared.normals).toEqual(own.normals);
        sequence.dispose();
      }
    const after = await shape.stats();
    expect([after.encodings, after.factorisations]).toEqual([before.encodings, before.factorisations]);
    expect([after.encodeMs, after.factorMs]).toEqual([before.encodeMs, before.factorMs]);
  });

  it('makes LRI space for the first motion or request that needs it', async () => {
    const made = async (shape: Shape): Promise<number[]> => {
      const { encodings, factorisations, patches } = await shape.stats();
      return [encodings, factorisations, Math.sign(patches)];
    };
    const { engine, shape } = await encoded();
    const stages = new Set<string>();
    const onProgress = ({ stage }: { stage: string }): void => void stages.add(stage);
    const blend = await shape.motion({ method: 'linear' }, { onProgress });
    expect((await blend.evaluate(0.5))?.t).toBe(0.5);
    expect(await shape.components()).toContain(0);
    expect(await made(shape)).toEqual([0, 0, 0]);
    expect(stages.size).toBe(0);
    await shape.motion({ method: 'geodesic' }, { onProgress });
    expect(await made(shape)).toEqual([1, 2, 1]);
    expect([...stages]).toEqual(expect.arrayContaining(['encoding', 'factorising']));
    const sequence = await engine.createSequence((await bendKeys(engine)).keys, { method: 'cubic-vertex' });
    expect((await sequence.stats()).encodings).toBe(0);
    expect((await sequence.shapePlane([0.5])).curve).toHaveLength(2);
    expect((await sequence.stats()).encodings).toBe(1);
  });

  it('still works after the making of LRI space was cancelled', async () => {
    const { shape } = await encoded();
    const blend = await shape.motion({ method: 'linear' });
    const before = (await frameAt(blend, 0.3)).positions;
    const controller = new AbortController();
    const motion = failureOf(shape.motion({}, { signal: controller.signal, onProgress: () => controller.abort() }));
    expect((await motion).code).toBe('cancelled');
    expect((await shape.stats()).encodings).toBe(0);
    expect((await frameAt(blend, 0.3)).positions).toEqual(before);
    expect((await (await shape.motion()).evaluate(0.3))?.t).toBe(0.3);
    expect((await shape.stats()).encodings).toBe(1);
  });

  it('handles its motions in turn, and keeps the newest request of each', async () => {
    const { shape } = await encoded();
    const [one, two] = await Promise.all([shape.motion(), shape.motion({ method: 'linear' })]);
    const frames = await Promise.all([one.evaluate(0.1), two.evaluate(0.2), one.evaluate(0.3), two.evaluate(0.4)]);
    // The first request is running when the others arrive.
    expect(frames.map((frame) => frame?.t ?? null)).toEqual([0.1, null, 0.3, 0.4]);
  });

  it('can have more motions than its worker keeps', async () => {
    const { shape } = await encoded();
    const motions = await Promise.all(
      Array.from({ length: 20 }, (_, i) => shape.motion({ boundary: 'hermite', startSpeed: i })),
    );
    const first = (await frameAt(motions[0]!, 0.2)).positions;
    for (const motion of motions) await frameAt(motion, 0.2);
    expect((await frameAt(motions[0]!, 0.2)).positions).toEqual(first);
    expect((await frameAt(motions[1]!, 0.2)).positions).not.toEqual(first);
  });

  it('makes a motion again with its own key times, although the caller reuses their array', async () => {
    const { shape } = await encoded();
    const keyTimes = [0, 0.5, 1];
    const first = await shape.motion({ keyTimes });
    const before = (await frameAt(first, 0.6)).positions.slice();
    for (let others = 0; others < 16; ++others) {
      keyTimes[1]! += 0.02;
      await shape.motion({ keyTimes });
    }
    expect(first.keyTimes).toEqual([0, 0.5, 1]);
    expect((await frameAt(first, 0.6)).positions).toEqual(before);
  });

  it('ends a motion that is disposed of, and ends all its motions when disposed of', async () => {
    const { shape } = await encoded();
    const [one, two] = [await shape.motion(), await shape.motion()];
    one.dispose();
    one.dispose();
    expect(await failureOf(one.evaluate(0))).toMatchObject({ code: 'disposed', message: /^This motion / });
    expect((await two.evaluate(0))?.t).toBe(0);
    shape.dispose();
    expect((await failureOf(two.evaluate(0))).code).toBe('disposed');
    expect((await failureOf(shape.motion())).code).toBe('disposed');
  });

  it('refuses options of another kind, and a refused motion does not affect the others', async () => {
    const engine = testEngine();
    const { keys } = await bendKeys(engine);
    expect((await failureOf(engine.encode(keys, { boundary: 'natural' } as object))).code).toBe('invalid-option');
    const shape = await engine.encode(keys, { stretch: 'log' });
    expect(shape.options.stretch).toBe('log');
    const motion = await shape.motion();
    expect(motion.options).toMatchObject({ stretch: 'log', boundary: 'natural' });
    expect((await failureOf(shape.motion({ patches: 3 } as object))).code).toBe('invalid-option');
    expect((await failureOf(shape.motion({ keyTimes: [1, 0, 2] }))).code).toBe('times-not-increasing');
    expect((await motion.evaluate(0.5))?.t).toBe(0.5);
    expect(await failureOf(shape.motion({}, { signal: AbortSignal.abort() }))).toMatchObject({ code: 'cancelled' });
  });
});
