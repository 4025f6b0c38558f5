/** Rotation of the twisted bar: the sum over its patches, against its vertices. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { turnAlong } from '../../web/study/turn-along.ts';
import { frameAt, testEngine } from './support/engines.ts';

const engine = testEngine();
const DEGREES = 180 / Math.PI;

/** Two vertices at an end of the longest axis, far apart across it, and the two other axes. */
function acrossEnd(positions: Float32Array, sign: 1 | -1): { from: number; to: number; axes: [number, number] } {
  const vertices = [...Array(positions.length / 3).keys()];
  const at = (vertex: number, axis: number): number => positions[3 * vertex + axis]!;
  const most = (values: number[]): number => values.reduce((a, b) => Math.max(a, b), -Infinity);
  const span = (axis: number): number =>
    most(vertices.map((vertex) => at(vertex, axis))) + most(vertices.map((vertex) => -at(vertex, axis)));
  const long = [0, 1, 2].reduce((a, b) => (span(b) > span(a) ? b : a));
  const axes = [0, 1, 2].filter((axis) => axis !== long) as [number, number];
  const end = most(vertices.map((vertex) => sign * at(vertex, long)));
  const there = vertices.filter((vertex) => sign * at(vertex, long) > end - 0.01 * span(long));
  const by = (vertex: number): number => axes.reduce((sum, axis) => sum + at(vertex, axis), 0);
  const from = there.reduce((a, b) => (by(b) < by(a) ? b : a));
  return { from, to: there.reduce((a, b) => (by(b) > by(a) ? b : a)), axes };
}

it('the rotations between neighbouring patches of the twisted bar are small and add up to that of its ends', async () => {
  const bytes = await readFile(new URL('../../public/samples/twisted-bar.glb', import.meta.url));
  const keys = await engine.importKeyframes([{ name: 'twisted-bar.glb', bytes }]);
  const sequence = await engine.createSequence(keys);
  const [first, last] = sequence.range;
  const times = [first, (first + last) / 2, last];
  const { patches } = await sequence.stats();
  const turn = (await turnAlong(patches, times.length, (patch) => sequence.patchCurve(patch, times)))!;
  expect(turn.largest).toBeLessThan(45);

  const start = (await frameAt(sequence, first)).positions;
  const across = [acrossEnd(start, -1), acrossEnd(start, 1)];
  const angleOf = (at: Float32Array): number => {
    const [low, high] = across.map(({ from, to, axes: [u, v] }) =>
      Math.atan2(at[3 * to + v]! - at[3 * from + v]!, at[3 * to + u]! - at[3 * from + u]!),
    );
    return high! - low!;
  };
  let [before, turned] = [angleOf(start), 0];
  const measured: number[] = [];
  for (let step = 1; step <= 24; step += 1) {
    const angle = angleOf((await frameAt(sequence, first + (step / 24) * (last - first))).positions);
    turned += Math.atan2(Math.sin(angle - before), Math.cos(angle - before));
    before = angle;
    measured.push(Math.abs(turned) * DEGREES);
  }
  expect(measured[23]).toBeGreaterThan(170);
  // Patches are measured from centre to centre, which is slightly less than end to end. The path through them is not
  // straight, which adds a little.
  for (const [said, seen] of [
    [turn.total[1]!, measured[11]!],
    [turn.total[2]!, measured[23]!],
  ] as const) {
    expect(Math.abs(said)).toBeGreaterThan(0.93 * seen);
    expect(Math.abs(said)).toBeLessThan(1.02 * seen);
  }
  sequence.dispose();
});
