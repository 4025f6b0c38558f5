import { describe, expect, it } from 'vitest';
import { bendKeys, bendSequence, failureOf, frameAt, testEngine } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { bar, bent } from './support/shapes.ts';

const faultyWorker = new URL('./support/faulty-worker.mjs', import.meta.url);

describe('a worker', () => {
  it.each([
    [1001, 'crashed', 'that exits'],
    [1002, 'crashed', 'that throws'],
    [1003, 'crashed', 'that traps'],
    [1004, 'out-of-memory', 'that runs out of memory'],
  ])('at fault %d gives code %s (%s), and the next call works with the motion as it was', async (fault, code) => {
    const { sequence } = await bendSequence(testEngine({ workerUrl: faultyWorker }));
    await sequence.update({ boundary: 'hermite', startSpeed: 0.5, keyTimes: [0, 1, 3] });
    const before = (await frameAt(sequence, 0.4)).positions;
    const error = await failureOf(sequence.evaluate(fault));
    expect(error.code).toBe(code);
    expect(error.message).toMatch(/[.!]$/);
    expect((await frameAt(sequence, 0.4)).positions).toEqual(before);
    expect(sequence.options).toMatchObject({ boundary: 'hermite', startSpeed: 0.5 });
  });

  it('that traps rejects all its requests', async () => {
    const { sequence } = await bendSequence(testEngine({ workerUrl: faultyWorker }));
    const series = failureOf(sequence.evaluateMany([0, 1003, 1]));
    expect((await series).code).toBe('crashed');
    expect(await sequence.patches()).toBeInstanceOf(Int32Array);
  });

  it('that cannot be started gives an error with a code', async () => {
    const missing = new URL('./support/no-such-worker.mjs', import.meta.url);
    const engine = testEngine({ workerUrl: missing });
    expect((await failureOf(engine.importKeyframes(poseFiles(bar(), [bent(bar(), 0), bent(bar(), 9)])))).code).toBe(
      'crashed',
    );
  });

  it('without its wasm gives an error with a code', async () => {
    const engine = testEngine({ wasmUrl: new URL('./support/no-such.wasm', import.meta.url) });
    expect((await failureOf(bendKeys(engine))).code).toBe('not-loaded');
  });
});

describe('cancelling', () => {
  it('rejects within a second while a large sequence is built, and the old one still works', async () => {
    const engine = testEngine();
    const { sequence } = await bendSequence(engine);
    const before = (await frameAt(sequence, 0.4)).positions;
    const large = bar(60, 600); // 151,200 faces
    const { keys } = await bendKeys(engine, large);
    const controller = new AbortController();
    const begun = new Promise<void>((resolve) => {
      void failureOf(engine.createSequence(keys, {}, { signal: controller.signal, onProgress: () => resolve() })).then(
        (error) => {
          expect(error.code).toBe('cancelled');
          ended = performance.now();
        },
      );
    });
    let ended = Infinity;
    await begun;
    const asked = performance.now();
    controller.abort();
    expect((await frameAt(sequence, 0.4)).positions).toEqual(before);
    await new Promise((wake) => setTimeout(wake, 50));
    expect(ended - asked).toBeLessThan(1000);
  });

  it('of an import or an export changes nothing', async () => {
    const engine = testEngine();
    const { sequence, mesh, poses } = await bendSequence(engine);
    const controller = new AbortController();
    const options = { signal: controller.signal };
    const works = [
      engine.importKeyframes(poseFiles(mesh, poses), {}, options),
      sequence.export({ frames: 200 }, options),
    ].map(failureOf);
    controller.abort();
    for (const work of works) expect((await work).code).toBe('cancelled');
    expect(await frameAt(sequence, 0.4)).toBeTruthy();
    expect(await sequence.export({ frames: 2 })).toHaveLength(1);
  });
});
