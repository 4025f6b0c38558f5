/** The second worker of a large sequence: its shared memory, and its end together with the first worker. */
import { describe, expect, it } from 'vitest';
import type { FromWorker, KeyData, Request } from '../../../web/engine/wire/protocol.ts';
import { awaitedOrder, provideOrder, type SharedOrder } from '../../../web/engine/wire/shared-order.ts';
import { type FakeWorker, fakeEngine, replyTo, settled, someFile } from './fake-worker.ts';

function replyLarge(request: Request): FromWorker {
  const reply = replyTo(request);
  if (request.type === 'import' && reply.type === 'result') (reply.value as KeyData).info.report.vertices = 50_000;
  return reply;
}

/** A large sequence under construction, whose two workers wait for the test. */
async function building() {
  const { engine, workers } = fakeEngine(
    (request) => (request.type === 'order' || request.type === 'motion' ? null : replyLarge(request)),
    async () => null,
  );
  const keys = await engine.importKeyframes([someFile]);
  const controller = new AbortController();
  const sequence = engine.createSequence(keys, {}, { signal: controller.signal });
  const code = sequence.then(
    () => 'made',
    (error: { code: string }) => error.code,
  );
  await settled();
  const [builder, finder] = workers as [FakeWorker, FakeWorker];
  const order = builder.of('motion')[0]!.order!;
  const answer = async (worker: FakeWorker): Promise<void> => {
    worker.say(replyTo(worker.requests.at(-1)!));
    await settled();
  };
  return { engine, workers, finder, builder, order, sequence, code, cancel: () => controller.abort(), answer };
}

/** Whether a new worker would skip the computation. */
function isGivenUp(order: SharedOrder): boolean {
  let begun = false;
  provideOrder(order, () => {
    begun = true;
    return Int32Array.of(0);
  });
  return !begun;
}

describe('the order of elimination of a large sequence', () => {
  it('is written by a separate worker, into memory that the other worker reads', async () => {
    const { workers, finder, builder, order, code, answer } = await building();
    expect(workers).toHaveLength(2);
    expect(finder.of('order')[0]!.order.buffer).toBe(order.buffer);
    provideOrder(finder.of('order')[0]!.order, () => Int32Array.of(0));
    await answer(finder);
    expect([finder.terminated, builder.terminated]).toEqual([true, false]);
    expect(awaitedOrder(order)).toEqual(Int32Array.of(0));
    await answer(builder);
    expect([await code, builder.terminated]).toEqual(['made', false]);
  });

  it('is computed only while the sequence is built', async () => {
    const { finder, builder, order, code, answer } = await building();
    await answer(builder);
    expect([await code, finder.terminated, builder.terminated]).toEqual(['made', true, false]);
    expect(isGivenUp(order)).toBe(true);
  });

  it('ends if the sequence is cancelled, disposed of or fails', async () => {
    const ends = {
      cancelled: ({ cancel }) => cancel(),
      disposed: ({ engine }) => engine.dispose(),
      crashed: ({ builder }) => builder.die(),
    } satisfies Record<string, (one: Awaited<ReturnType<typeof building>>) => void>;
    for (const [how, end] of Object.entries(ends)) {
      const one = await building();
      end(one);
      await settled();
      expect([await one.code, one.finder.terminated, isGivenUp(one.order)], how).toEqual([how, true, true]);
      expect(one.builder.terminated || how === 'crashed', how).toBe(true);
    }
  });

  it('is not used if its worker ends, and the sequence is still built', async () => {
    const { finder, builder, order, code, answer } = await building();
    finder.die();
    await settled();
    expect(isGivenUp(order)).toBe(true);
    await answer(builder);
    expect(await code).toBe('made');
  });

  it('is not used when the sequence is built again, nor for small shapes', async () => {
    const { workers, builder, sequence, answer } = await building();
    await answer(builder);
    builder.die();
    const frame = (await sequence).evaluate(0);
    await settled();
    expect(workers[2]!.of('encode')).toHaveLength(1);
    expect(workers).toHaveLength(3);
    expect(await frame).not.toBeNull();
    const small = fakeEngine(replyTo, async () => null);
    await small.engine.createSequence(await small.engine.importKeyframes([someFile]));
    expect(small.workers.map((worker) => worker.of('motion')[0]?.order)).toEqual([null]);
  });
});
