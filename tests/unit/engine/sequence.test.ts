import { describe, expect, it } from 'vitest';
import { EngineError } from '../../../web/engine/api/errors.ts';
import type { MeshReport } from '../../../web/engine/api/types.ts';
import type { FromWorker, Request } from '../../../web/engine/wire/protocol.ts';
import { replyTo, fakeEngine, settled, someFile, type FakeWorker } from './fake-worker.ts';

const failure = (work: Promise<unknown>): Promise<EngineError> =>
  work.then(
    () => {
      throw new Error('no failure');
    },
    (e: EngineError) => e,
  );

/** Measures equal to the requested times. */
const measuredAt = (times: readonly number[], id: number): FromWorker => ({
  type: 'result',
  id,
  value: { volume: [...times], area: [...times], sliding: times.map(() => null) },
});

/** A sequence whose frames wait for the test's reply; `reply` answers other requests first. */
async function heldSequence(reply: (request: Request) => FromWorker | undefined = () => undefined) {
  const { engine, workers } = fakeEngine(
    (request) => reply(request) ?? (request.type === 'evaluate' ? null : replyTo(request)),
  );
  const sequence = await engine.createSequence(await engine.importKeyframes([someFile]));
  const worker = workers[0] as FakeWorker;
  const replyNext = async (): Promise<void> => {
    worker.say(replyTo(worker.requests.at(-1) as Request));
    await settled();
  };
  return { engine, workers, sequence, worker, replyNext };
}

describe('calls whose arrays the caller changes meanwhile', () => {
  it('use the arrays as they were', async () => {
    const { sequence, worker, replyNext } = await heldSequence();
    const times = [1, 2];
    const tension = [0, 0];
    const keyTimes = [0, 1];
    const many = sequence.evaluateMany(times);
    const update = sequence.update({ tension, keyTimes });
    for (const array of [times, tension, keyTimes]) array.fill(9);
    await settled();
    for (let i = 0; i < 4; ++i) await replyNext();
    await Promise.all([many, update]);
    expect(worker.of('evaluate').map(({ t }) => t)).toEqual([1, 2]);
    expect([sequence.options.tension, sequence.keyTimes]).toEqual([
      [0, 0],
      [0, 1],
    ]);
  });
});

describe('evaluate', () => {
  it('keeps one running and one waiting request; replaced requests are null', async () => {
    const { sequence, worker, replyNext } = await heldSequence();
    const frames = [0.1, 0.2, 0.3, 0.4].map((t) => sequence.evaluate(t));
    await settled();
    expect(worker.of('evaluate').map(({ t }) => t)).toEqual([0.1]);
    await replyNext();
    expect(worker.of('evaluate').map(({ t }) => t)).toEqual([0.1, 0.4]);
    await replyNext();
    expect((await Promise.all(frames)).map((frame) => frame?.t ?? null)).toEqual([0.1, null, null, 0.4]);
  });

  it('has priority over the frames of an export, which continue afterwards', async () => {
    const { sequence, worker, replyNext } = await heldSequence();
    const many = sequence.evaluateMany([1, 2, 3]);
    await settled();
    const shown = sequence.evaluate(0.5);
    for (let i = 0; i < 4; ++i) await replyNext();
    expect(worker.of('evaluate').map(({ t }) => t)).toEqual([1, 0.5, 2, 3]);
    expect((await shown)?.t).toBe(0.5);
    expect((await many).map(({ t }) => t)).toEqual([1, 2, 3]);
  });

  it('has priority over measurements, which the worker answers in portions', async () => {
    const { sequence, worker } = await heldSequence((request) =>
      request.type === 'measure' ? measuredAt(request.times.slice(0, 3), request.id) : undefined,
    );
    const fractions: number[] = [];
    const measures = sequence.measures([0, 1, 2, 3, 4, 5, 6], {
      onProgress: ({ fraction }) => fractions.push(fraction ?? NaN),
    });
    const ahead = sequence.evaluateAhead(0.5);
    await settled();
    expect(worker.of('measure')).toEqual([]);
    worker.say(replyTo(worker.requests.at(-1)!));
    expect((await measures).volume).toEqual([0, 1, 2, 3, 4, 5, 6]);
    expect(worker.of('measure').map(({ times }) => times[0])).toEqual([0, 3, 6]);
    expect(fractions).toEqual([3 / 7, 6 / 7, 1]);
    (await ahead).release();
  });

  it('returns released buffers instead of allocating new ones', async () => {
    const { sequence, worker, replyNext } = await heldSequence();
    const first = sequence.evaluate(0);
    await settled();
    await replyNext();
    const frame = await first;
    frame?.release();
    frame?.release();
    const second = sequence.evaluate(1);
    await settled();
    expect(worker.of('evaluate').map(({ buffers }) => buffers !== null)).toEqual([false, true]);
    await replyNext();
    expect((await second)?.positions).toBe(frame?.positions);
    void sequence.evaluate(2);
    await settled();
    expect(worker.of('evaluate').at(-1)?.buffers).toBeNull(); // released twice, but pooled once
  });

  it('refuses a time that is not a number', async () => {
    const { sequence } = await heldSequence();
    expect((await failure(sequence.evaluate(NaN))).code).toBe('invalid-option');
  });
});

describe('update', () => {
  it('applies to later requests, but not to an export that started before', async () => {
    const { sequence, worker, replyNext } = await heldSequence();
    const many = sequence.evaluateMany([1, 2]);
    await settled();
    await Promise.all([sequence.update({ boundary: 'periodic' }), replyNext()]);
    expect(sequence.options.boundary).toBe('periodic');
    const shown = sequence.evaluate(0.5);
    for (let i = 0; i < 2; ++i) await replyNext();
    await Promise.all([many, shown]);
    const asked = worker.of('evaluate').map(({ t, motion }) => [t, motion.options.boundary, motion.number]);
    expect(asked).toEqual([
      [1, 'natural', 1],
      [2, 'natural', 1],
      [0.5, 'periodic', 2],
    ]);
  });

  it('does not change the motion if it fails', async () => {
    const fails = (request: Request): FromWorker =>
      request.type === 'motion' && request.motion.number > 1
        ? {
            type: 'error',
            id: request.id,
            error: { code: 'times-not-increasing', message: 'no', place: { key: 1 } },
            fatal: false,
          }
        : replyTo(request);
    const { engine, workers } = fakeEngine(fails);
    const sequence = await engine.createSequence(await engine.importKeyframes([someFile]));
    const error = await failure(sequence.update({ keyTimes: [1, 0], startSpeed: 3 }));
    expect([error.code, error.place]).toEqual(['times-not-increasing', { key: 1 }]);
    expect([sequence.keyTimes, sequence.options.startSpeed]).toEqual([[0, 1], 1]);
    await sequence.evaluate(0);
    expect(workers[0]?.of('evaluate')[0]?.motion.number).toBe(1);
  });
});

describe('a worker that dies', () => {
  it('rejects open requests and is replaced, with keys and motion, by the next call', async () => {
    const { sequence, worker, workers } = await heldSequence();
    await sequence.update({ boundary: 'hermite', keyTimes: [0, 3] });
    const lost = sequence.evaluate(0.5);
    await settled();
    worker.die();
    expect((await failure(lost)).code).toBe('crashed');
    expect(worker.terminated).toBe(true);
    const next = sequence.evaluate(0.6);
    await settled();
    const fresh = workers[1] as FakeWorker;
    expect(fresh.of('encode')).toHaveLength(1);
    const [asked] = fresh.of('evaluate');
    expect(asked?.motion).toMatchObject({ options: { boundary: 'hermite' }, keyTimes: [0, 3] });
    fresh.say(replyTo(fresh.requests.at(-1) as Request));
    expect((await next)?.t).toBe(0.6);
    expect(workers).toHaveLength(2);
  });

  it('is replaced after a fatal reply too', async () => {
    let fatal = true;
    const { engine, workers } = fakeEngine((request) => {
      if (request.type !== 'evaluate' || !fatal) return replyTo(request);
      fatal = false;
      return { type: 'error', id: request.id, error: { code: 'out-of-memory', message: 'no', place: {} }, fatal: true };
    });
    const sequence = await engine.createSequence(await engine.importKeyframes([someFile]));
    expect((await failure(sequence.evaluate(0))).code).toBe('out-of-memory');
    expect(workers[0]?.terminated).toBe(true);
    expect((await sequence.evaluate(0))?.t).toBe(0);
  });
});

describe('cancelling', () => {
  it('ends the worker of a new sequence at once and leaves the old one alone', async () => {
    const { engine, workers } = fakeEngine((request) =>
      request.type === 'encode' && workers.length > 1 ? null : replyTo(request),
    );
    const keys = await engine.importKeyframes([someFile]);
    const old = await engine.createSequence(keys);
    const controller = new AbortController();
    const made = failure(engine.createSequence(keys, {}, { signal: controller.signal }));
    await settled();
    controller.abort();
    expect((await made).code).toBe('cancelled');
    expect(workers.map(({ terminated }) => terminated)).toEqual([false, true]);
    expect((await old.evaluate(0))?.t).toBe(0);
  });

  it('works before anything has started', async () => {
    const { engine } = fakeEngine();
    const signal = AbortSignal.abort();
    expect((await failure(engine.importKeyframes([someFile], {}, { signal }))).code).toBe('cancelled');
  });

  it('stops a series of frames while one is being computed', async () => {
    const { sequence, worker } = await heldSequence();
    const controller = new AbortController();
    const many = failure(sequence.evaluateMany([1, 2], { signal: controller.signal }));
    await settled();
    controller.abort();
    expect((await many).code).toBe('cancelled');
    expect(worker.terminated).toBe(false);
  });
});

describe('progress', () => {
  it('never decreases, for any reports of the worker', async () => {
    const { engine, workers } = fakeEngine((request) => (request.type === 'encode' ? null : replyTo(request)));
    const seen: number[] = [];
    const keys = await engine.importKeyframes([someFile]);
    const made = engine.encode(keys, {}, { onProgress: ({ fraction }) => seen.push(fraction) });
    await settled();
    const worker = workers[0] as FakeWorker;
    const { id } = worker.requests.at(-1) as Request;
    for (const fraction of [0.1, 0.5, 0.3, 1.5]) worker.say({ type: 'progress', id, stage: 'encoding', fraction });
    worker.say(replyTo(worker.requests.at(-1) as Request));
    await made;
    expect(seen).toEqual([0.1, 0.5, 0.5, 1]);
  });
});

describe('a worker for files', () => {
  it('is not kept after an invalid file; after a valid one it reads the next, but never encodes', async () => {
    let good = false;
    const { engine, workers, filesWorkers } = fakeEngine((request) =>
      request.type === 'import' && !good
        ? { type: 'error', id: request.id, error: { code: 'malformed-file', message: 'no', place: {} }, fatal: false }
        : replyTo(request),
    );
    expect((await failure(engine.importKeyframes([someFile]))).code).toBe('malformed-file');
    expect(filesWorkers[0]?.terminated).toBe(true);
    good = true;
    await engine.createSequence(await engine.importKeyframes([someFile]));
    await engine.importKeyframes([someFile]);
    expect([filesWorkers.length, workers.length]).toEqual([2, 1]);
  });

  it('ends after reading large files, because its memory would stay allocated', async () => {
    const { engine, filesWorkers } = fakeEngine();
    await engine.importKeyframes([{ name: 'large.glb', bytes: new Uint8Array(1_000_000) }]);
    expect(filesWorkers.map(({ terminated }) => terminated)).toEqual([true]);
  });

  it('is started again after its module could not be fetched', async () => {
    let fetched = 0;
    const { engine, filesWorkers } = fakeEngine(replyTo, null, async () => {
      fetched += 1;
      if (fetched === 1) throw new EngineError('not-loaded', 'no');
    });
    expect((await failure(engine.importKeyframes([someFile]))).code).toBe('not-loaded');
    for (let i = 0; i < 2; i += 1) await engine.importKeyframes([someFile]);
    expect([fetched, filesWorkers.length]).toEqual([2, 1]);
  });
});

describe('keys of arrays', () => {
  it('are checked by the worker that encodes them, and need no module for files', async () => {
    const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
    const poses = [0, 2].map((time) => ({ name: `at ${time}`, time, positions }));
    const { engine, workers, filesWorkers } = fakeEngine((request) =>
      request.type === 'report'
        ? { type: 'result', id: request.id, value: { report: { vertices: 3, faces: 1 } as MeshReport } }
        : replyTo(request),
    );
    const keys = await engine.createKeys({ faces: Uint32Array.of(0, 1, 2), poses });
    expect([keys.info.names, keys.info.times, keys.info.report.faces]).toEqual([['at 0', 'at 2'], [0, 2], 1]);
    await engine.createSequence(keys);
    expect([workers.length, filesWorkers.length]).toEqual([1, 0]);
    const odd = { faces: Uint32Array.of(0, 1), poses };
    expect((await failure(engine.createKeys(odd))).code).toBe('invalid-option');
  });
});

describe('disposing', () => {
  it('is idempotent, ends the worker, and makes every later call fail', async () => {
    const { engine, sequence, worker } = await heldSequence();
    const open = sequence.evaluate(0);
    const waiting = sequence.evaluate(1);
    await settled();
    sequence.dispose();
    sequence.dispose();
    expect([await open, await waiting]).toEqual([null, null]);
    expect(worker.terminated).toBe(true);
    const calls = [
      sequence.evaluate(0),
      sequence.evaluateMany([0]),
      sequence.update({}),
      sequence.stats(),
      sequence.export(),
    ];
    for (const call of calls) expect((await failure(call)).code).toBe('disposed');
    engine.dispose();
    engine.dispose();
    expect((await failure(engine.importKeyframes([someFile]))).code).toBe('disposed');
  });

  it('of keys does not affect a sequence', async () => {
    const { engine } = fakeEngine();
    const keys = await engine.importKeyframes([someFile]);
    const sequence = await engine.createSequence(keys);
    keys.dispose();
    expect(() => keys.info).toThrow(/disposed/);
    expect((await failure(engine.createSequence(keys))).code).toBe('disposed');
    expect((await sequence.evaluate(0))?.t).toBe(0);
  });
});
