/** What is shown of a large motion while it is made, through the engine. */
import { describe, expect, it } from 'vitest';
import type { Engine, SketchFrame } from '../../web/engine/api/api.ts';
import type { SequenceOptions } from '../../web/engine/api/types.ts';
import { coarseMesh, coarsePositions } from '../../web/engine/caller/coarse-keys.ts';
import { sketchTime } from '../../web/engine/caller/sketch.ts';
import { bendKeys, failureOf, frameAt, testEngine } from './support/engines.ts';
import { bar } from './support/shapes.ts';

const large = bar(40, 250); // 43,202 vertices
const faultyWorker = new URL('./support/faulty-worker.mjs', import.meta.url);

const farthest = (a: Float32Array, b: Float32Array): number =>
  a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i]!)), 0);

/** The sequence, and what was shown before it was there. `speed` 0: of one time alone. */
async function made(engine: Engine, { time = 0, speed = 0, options = {} as Partial<SequenceOptions>, mesh = large }) {
  const { keys } = await bendKeys(engine, mesh);
  const frames: SketchFrame[] = [];
  let done = false;
  const sequence = await engine.createSequence(keys, options, {
    sketch: {
      time,
      speed,
      onFrame(frame) {
        expect(done).toBe(false);
        frames.push(frame);
      },
    },
  });
  done = true;
  return { keys, sequence, frames };
}

describe('a sketch', () => {
  it.each([
    ['one thread', { threadsUrl: null }],
    ['two', {}],
  ])('comes before the sequence, meets its keys and is near to its shapes between them, with %s', async (_, urls) => {
    const engine = testEngine(urls);
    for (const [time, tolerance] of [
      [0, 1e-5],
      [0.5, 1e-5],
      [0.25, 0.005],
      [0.8, 0.005],
    ] as const) {
      const { keys, sequence, frames } = await made(engine, { time });
      expect(frames.length).toBeGreaterThan(0);
      const mesh = coarseMesh([keys.positions(0), keys.positions(2)], keys.info.faces);
      const exact = coarsePositions(mesh, (await frameAt(sequence, time)).positions);
      for (const frame of frames) {
        expect(frame.t).toBeCloseTo(time, 9);
        expect(frame.faces.length).toBeLessThan(keys.info.faces.length / 4);
        expect(frame.faces).toBe(frames[0]!.faces);
        expect(frame.normals).toHaveLength(frame.positions.length);
        expect(farthest(frame.positions, exact)).toBeLessThan(tolerance * keys.info.report.diagonal);
      }
      sequence.dispose();
    }
  });

  it('plays: later shapes are of later times', async () => {
    const { frames } = await made(testEngine(), { speed: 0.5 });
    expect(frames[0]!.t).toBe(0);
    for (const [i, { t }] of frames.entries()) if (i > 0) expect(t).toBeGreaterThan(frames[i - 1]!.t);
  });

  it('leaves the sequence as it is without one, bit for bit', async () => {
    const engine = testEngine();
    const { keys, sequence } = await made(engine, { speed: 1 });
    const plain = await engine.createSequence(keys);
    const [one, two] = [await frameAt(sequence, 0.3), await frameAt(plain, 0.3)];
    expect(Buffer.compare(Buffer.from(one.positions.buffer), Buffer.from(two.positions.buffer))).toBe(0);
    expect(Buffer.compare(Buffer.from(one.normals.buffer), Buffer.from(two.normals.buffer))).toBe(0);
  });

  it('is not made of small shapes', async () => {
    expect((await made(testEngine(), { mesh: bar() })).frames).toEqual([]);
  });

  it.each<[string, Partial<SequenceOptions>]>([
    ['linear blends', { method: 'linear' }],
    ['a loop that stays in place', { boundary: 'periodic', inPlace: true }],
    ['a ghost mesh', { ghostFaces: 2000 }],
    [
      'pins and turns of a component',
      { pins: [{ vertex: 43_000, radius: 0.1 }], turns: [{ key: 1, turns: 1, component: 0 }] },
    ],
    ['tangents', { boundary: 'hermite', startTangent: large.positions }],
  ])('is made with %s', async (_, options) => {
    expect((await made(testEngine(), { options })).frames.length).toBeGreaterThan(0);
  });

  it.each(['encoding', 'factorising'])('is over with a build that is cancelled while %s', async (at) => {
    const engine = testEngine();
    const { keys } = await bendKeys(engine, large);
    const controller = new AbortController();
    let after = 0;
    const error = await failureOf(
      engine.createSequence(
        keys,
        {},
        {
          signal: controller.signal,
          onProgress: ({ stage }) => {
            if (stage === at) controller.abort();
          },
          sketch: { time: 0, speed: 1, onFrame: () => (after += controller.signal.aborted ? 1 : 0) },
        },
      ),
    );
    expect(error.code).toBe('cancelled');
    await new Promise((wake) => setTimeout(wake, 100));
    expect(after).toBe(0);
    expect(await engine.createSequence((await bendKeys(engine)).keys)).toBeTruthy();
  });

  it('goes on while the order is waited for, and ends with the worker that finds it', async () => {
    const engine = testEngine({ workerUrl: faultyWorker });
    const { frames, sequence } = await made(engine, { speed: 0.1, options: { patches: 201 } });
    // The other worker does nothing for three seconds, then exits.
    expect(frames.at(-1)!.t - frames[0]!.t).toBeGreaterThan(0.1);
    expect((await frameAt(sequence, 0.5)).positions).toHaveLength(large.positions.length);
  });

  it('refuses what is none', async () => {
    const engine = testEngine();
    const { keys } = await bendKeys(engine);
    for (const sketch of [
      null,
      { time: 0, speed: -1, onFrame() {} },
      { time: NaN, speed: 1, onFrame() {} },
      { time: 0, speed: 1 },
    ])
      expect((await failureOf(engine.createSequence(keys, {}, { sketch: sketch as never }))).code).toBe(
        'invalid-option',
      );
  });
});

describe('the time of a sketch', () => {
  it('runs from the first key to the last, and on from the first or back', () => {
    const plan = { time: 1.5, speed: 2, bounce: false };
    const at = (seconds: number, bounce: boolean): number => sketchTime({ ...plan, bounce }, [1, 3], seconds);
    expect([0, 0.5, 1, 2].map((s) => at(s, false))).toEqual([1.5, 2.5, 1.5, 1.5]);
    expect([0, 0.5, 1, 2].map((s) => at(s, true))).toEqual([1.5, 2.5, 2.5, 1.5]);
  });
});
