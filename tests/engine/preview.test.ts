/** The cheap shape for while a slider moves, through the engine. */
import { describe, expect, it } from 'vitest';
import { bendSequence, frameAt, testEngine } from './support/engines.ts';

const farthest = (a: Float32Array, b: Float32Array): number => a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i]!)), 0);

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
    const [, overtaken, shown] = await Promise.all([sequence.preview(0.1), sequence.preview(0.2), sequence.evaluate(0.3)]);
    expect(overtaken).toBeNull();
    expect(shown?.t).toBe(0.3);
  });

  it('is fetched ahead, too, and taken back on a signal', async () => {
    const { sequence } = await bendSequence(testEngine());
    const cheap = (await sequence.preview(0.4))!;
    const abort = new AbortController();
    const [ahead, , late] = await Promise.allSettled([
      sequence.evaluateAhead(0.4, { preview: true }), sequence.evaluateAhead(0.5),
      sequence.evaluateAhead(0.6, { preview: true, signal: abort.signal }), abort.abort(),
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
});
