/** The cheap shape for while a slider moves, through the engine. */
import { describe, expect, it } from 'vitest';
import { bendSequence, failureOf, frameAt, testEngine } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { bar, bent, diagonal } from './support/shapes.ts';

const farthest = (a: Float32Array, b: Float32Array): number =>
  a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i]!)), 0);

describe('preview', () => {
  it('is close to the exact shape, meets the keys, and evaluate stays what it was', async () => {
    const { keys, sequence } = await bendSequence(testEngine());
    const { diagonal } = keys.info.report;
    const exact = await frameAt(sequence, 0.4);
    const cheap = (await sequence.preview(0.4))!;
    expect(cheap.t).toBe(0.4);
    expect(cheap.normals).toHaveLength(exact.normals.length);
    expect(farthest(exact.positions, cheap.positions)).toBeLessThan(0.005 * diagonal);
    expect((await frameAt(sequence, 0.4)).positions).toEqual(exact.positions);
    const first = (await sequence.preview(sequence.range[0]))!;
    expect(farthest(first.positions, keys.positions(0))).toBeLessThan(1e-5 * diagonal);
  });

  it('gives way to a newer request', async () => {
    const { sequence } = await bendSequence(testEngine());
    const [, overtaken, shown] = await Promise.all([
      sequence.preview(0.1),
      sequence.preview(0.2),
      sequence.evaluate(0.3),
    ]);
    expect(overtaken).toBeNull();
    expect(shown?.t).toBe(0.3);
  });

  it('is fetched ahead, too, and taken back on a signal', async () => {
    const { sequence } = await bendSequence(testEngine());
    const cheap = (await sequence.preview(0.4))!;
    const abort = new AbortController();
    const [ahead, , late] = await Promise.allSettled([
      sequence.evaluateAhead(0.4, { preview: true }),
      sequence.evaluateAhead(0.5),
      sequence.evaluateAhead(0.6, { preview: true, signal: abort.signal }),
      abort.abort(),
    ]);
    expect(ahead).toMatchObject({ status: 'fulfilled', value: { t: 0.4, positions: cheap.positions } });
    expect(late).toMatchObject({ status: 'rejected', reason: { code: 'cancelled' } });
  });

  it('of an exact sequence follows it, too', async () => {
    const { sequence } = await bendSequence(testEngine(), { precision: 'exact' });
    const { sequence: full } = await bendSequence(testEngine(), { precision: 'double' });
    const wanted = await frameAt(full, 0.7);
    expect(farthest((await frameAt(sequence, 0.7)).positions, wanted.positions)).toBeLessThan(1e-6);
    expect(await sequence.preview(0.7)).not.toBeNull();
  });

  it('is measured: nothing at a key, what its vertices are off elsewhere, more where the keys turn farther', async () => {
    const engine = testEngine();
    const mesh = bar();
    // tests/e2e/scrub drags over the same.
    const keys = await engine.importKeyframes(
      poseFiles(
        mesh,
        [0, 420, 430].map((degrees) => bent(mesh, degrees)),
      ),
      { keyTimes: [0, 0.5, 1] },
    );
    const sequence = await engine.createSequence(keys);
    for (const t of sequence.keyTimes) expect((await sequence.previewError(t)).largest).toBeLessThan(1e-5);

    const error = await sequence.previewError(0.3);
    const exact = await frameAt(sequence, 0.3);
    const cheap = (await sequence.preview(0.3))!;
    const distances = Array.from(
      { length: exact.positions.length / 3 },
      (_, v) =>
        Math.hypot(...[0, 1, 2].map((k) => exact.positions[3 * v + k]! - cheap.positions[3 * v + k]!)) /
        diagonal(keys.positions(0)),
    );
    expect(error.largest).toBeCloseTo(Math.max(...distances), 6);
    expect(error.mean).toBeCloseTo(distances.reduce((sum, d) => sum + d, 0) / distances.length, 6);

    expect((await sequence.previewError(0.25)).mean).toBeGreaterThan(0.0015);
    for (const t of [0.625, 0.75, 0.875]) expect((await sequence.previewError(t)).mean).toBeLessThan(0.0008);
    expect((await failureOf(sequence.previewError(NaN))).code).toBe('invalid-option');
  });

  it('of a motion without LRI coordinates is the shape itself', async () => {
    const { sequence } = await bendSequence(testEngine(), { method: 'cubic-vertex' });
    expect(await sequence.previewError(0.3)).toEqual({ mean: 0, largest: 0 });
  });
});
