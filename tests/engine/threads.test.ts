/** Two threads over one memory give bit-identical frames, and no result requires the second thread. */
import { existsSync, readdirSync } from 'node:fs';
import { Worker } from 'node:worker_threads';
import { afterEach, describe, expect, it } from 'vitest';
import createWasm from '../../build/wasm/shapespline.mjs';
import createThreaded from '../../build/wasm/shapespline_threads.mjs';
import { WasmCore } from '../../web/engine/worker/wasm-core.ts';
import type { Frame } from '../../web/engine/api/types.ts';
import type { CoreModule, CreateWasmModule } from '../../web/engine/worker/wasm-module.ts';
import { provideOrder, type SharedOrder, sharedOrder } from '../../web/engine/wire/shared-order.ts';
import { bendData, compiled, createBend, kept, type LocalCore, motion } from './support/core.ts';
import { bendKeys, failureOf, frameAt, testEngine } from './support/engines.ts';
import { bar } from './support/shapes.ts';

const faultyWorker = new URL('./support/faulty-worker.mjs', import.meta.url);
const TIMES = [-0.3, 0, 0.2, 0.5, 0.9, 1.4];

/** Linux has one folder per thread here. */
const THREADS_OF_PROCESS = '/proc/self/task';

const secondThreads: Worker[] = [];
afterEach(async () => {
  await Promise.all(secondThreads.splice(0).map((secondThread) => secondThread.terminate()));
});

async function started(glue: CreateWasmModule<CoreModule>, name: string): Promise<LocalCore> {
  const { create, made } = kept(glue);
  return { core: await WasmCore.start(create, await compiled(name)), module: made() };
}

/** A core with a second thread that is ready. */
async function withSecondThread(): Promise<LocalCore & { secondThread: Worker }> {
  const { core, module } = await started(createThreaded, 'shapespline_threads');
  const secondThread = new Worker(new URL('../../build/node/second-thread-node.mjs', import.meta.url), {
    workerData: core.secondThreadStart(await compiled('shapespline_threads')),
  });
  secondThreads.push(secondThread);
  await new Promise((resolve, reject) => secondThread.once('message', resolve).once('error', reject));
  return { core, module, secondThread };
}

describe('two threads', () => {
  it('give the same frames as one thread, bit for bit', async () => {
    const data = bendData(bar(8, 80));
    const { core: alone } = await started(createWasm, 'shapespline');
    const { core: together, module } = await withSecondThread();
    const [one, two] = [createBend(alone, data), createBend(together, data)];
    together.setThreads(two.shape, 2);
    // A busy machine may delay the second thread, so frames are made until it has taken part.
    for (let i = 0; i < 3000 && (i < TIMES.length || module._shapespline_helped() < 20); ++i) {
      const t = TIMES[i % TIMES.length]!;
      expect(
        Buffer.compare(bytes(together.evaluate(two.motion, t, null)), bytes(alone.evaluate(one.motion, t, null))),
      ).toBe(0);
    }
    expect(module._shapespline_helped()).toBeGreaterThanOrEqual(20);
  });

  it('are not required: frames are also made without the second thread, or after it has ended', async () => {
    const data = bendData();
    const { core, module, secondThread } = await withSecondThread();
    const { shape, motion } = createBend(core, data);
    const before = bytes(core.evaluate(motion, 0.3, null));
    core.setThreads(shape, 2);
    expect(bytes(core.evaluate(motion, 0.3, null)).equals(before)).toBe(true);
    await secondThread.terminate();
    const helped = module._shapespline_helped();
    for (let i = 0; i < 20; ++i) expect(bytes(core.evaluate(motion, 0.3, null)).equals(before)).toBe(true);
    expect(module._shapespline_helped()).toBe(helped);
  });
});

describe('a large sequence', () => {
  it('has the same frames with one and two threads, with and without the threaded module', async () => {
    const large = bar(40, 250); // 43,202 vertices
    const [one, two] = await Promise.all(
      [testEngine({ threadsUrl: null }), testEngine()].map(async (engine) => {
        const { keys } = await bendKeys(engine, large);
        expect(keys.info.report.vertices).toBeGreaterThan(40_000);
        return engine.createSequence(keys);
      }),
    );
    for (let i = 0; i < 20; ++i) {
      const t = TIMES[i % TIMES.length]!;
      expect(bytes(await frameAt(two!, t)).equals(bytes(await frameAt(one!, t)))).toBe(true);
    }
    expect((await one!.stats()).threads).toBe(1);
    expect([1, 2]).toContain((await two!.stats()).threads);
  });

  it('uses the elimination order that another worker found', async () => {
    const { core } = await started(createWasm, 'shapespline');
    const request = bendData(bar(8, 80));
    const factorWith = (order: SharedOrder | null): number => {
      const shape = core.encode(request);
      core.motion(shape, motion, null, { order });
      return core.ask('stats', shape, {}).factorBytes;
    };
    const own = factorWith(null);
    const empty = (): SharedOrder => sharedOrder(request.positions[0]!.length / 3);
    const factorBy = (order: Int32Array): number => {
      const shared = empty();
      provideOrder(shared, () => order);
      return factorWith(shared);
    };
    const found = core.eliminationOrder({ ...request, order: empty() });
    expect(factorBy(found)).toBe(own);
    // An order that is not a permutation, and one with more fill.
    expect(factorBy(found.map(() => 0))).toBe(own);
    const other = [...found.filter((_, at) => at % 2), ...found.filter((_, at) => !(at % 2))];
    expect(factorBy(Int32Array.from(other))).toBeGreaterThan(own);
  });

  it.runIf(existsSync(THREADS_OF_PROCESS))('ends with its second thread', async () => {
    const before = readdirSync(THREADS_OF_PROCESS).length;
    const engine = testEngine();
    const { keys } = await bendKeys(engine, bar(40, 250));
    const sequence = await engine.createSequence(keys);
    for (let i = 0; i < 16; ++i) await frameAt(sequence, 0.3);
    expect(readdirSync(THREADS_OF_PROCESS).length).toBeGreaterThanOrEqual(before + 2);
    engine.dispose();
    await expect.poll(() => readdirSync(THREADS_OF_PROCESS).length, { timeout: 10_000 }).toBeLessThanOrEqual(before);
  });

  it('whose second thread fails during a frame fails once, and then uses one thread with the same bits', async () => {
    const large = bar(40, 250);
    const [one, two] = await Promise.all(
      [testEngine({ threadsUrl: null }), testEngine({ workerUrl: faultyWorker })].map(async (engine) =>
        engine.createSequence((await bendKeys(engine, large)).keys),
      ),
    );
    const expected = bytes(await frameAt(one!, 0.3));
    // The second thread fails in its first frame, so frames are made until it has taken part.
    let outcome: unknown = null;
    for (let i = 0; i < 1000 && !(outcome instanceof Error); ++i) {
      outcome = await frameAt(two!, 0.3).catch((error: unknown) => error);
      if (!(outcome instanceof Error)) expect(bytes(outcome as Frame).equals(expected)).toBe(true);
    }
    const error = await failureOf(Promise.reject(outcome));
    expect(error.code).toBe('crashed');
    expect(error.message).toMatch(/second thread.*restarts/);
    for (let i = 0; i < 20; ++i) expect(bytes(await frameAt(two!, 0.3)).equals(expected)).toBe(true);
    expect((await two!.stats()).threads).toBe(1);
  });

  it('uses one thread if the threaded module is not available', async () => {
    const engine = testEngine({ threadsUrl: new URL('./no-such-module.wasm', import.meta.url) });
    const { keys } = await bendKeys(engine, bar(40, 250));
    const sequence = await engine.createSequence(keys);
    expect((await frameAt(sequence, 0.3)).positions).toHaveLength(3 * keys.info.report.vertices);
    expect((await sequence.stats()).threads).toBe(1);
  });
});

function bytes({ positions, normals }: { positions: Float32Array; normals: Float32Array }): Buffer {
  return Buffer.concat(
    [positions, normals].map((array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength)),
  );
}
