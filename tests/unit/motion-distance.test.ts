import { expect, it } from 'vitest';
import { motionDistances } from '../../web/app/analysis/motion-distance.ts';
import type { AnalysisInput } from '../../web/app/analysis/analysis.ts';
import type { Method } from '../../web/engine/api/types.ts';

let held = 0;

/** A triangle of diagonal 1 whose height is `off` times t. */
function running(method: Method, off: number): AnalysisInput['sequences'][number] {
  const evaluateMany = async (times: number[]) =>
    times.map((t) => {
      held += 1;
      const release = (): void => {
        held -= 1;
      };
      return { positions: triangle(off * t), release };
    });
  return { method, ghost: 0, sequence: { evaluateMany } } as unknown as AnalysisInput['sequences'][number];
}

const triangle = (z: number): Float32Array => Float32Array.of(0, 0, z, 0.6, 0, z, 0, 0.8, z);
const input = (...sequences: AnalysisInput['sequences']): AnalysisInput => ({
  ...{ sequences, keyTimes: [0, 1], range: [0, 1], towards: null, reference: 0, ms: 1 },
});

it('distances from the first motion, in percent of the diagonal, with the KG error', async () => {
  const found = (await motionDistances(input(running('lri', 0), running('linear', 0.1), running('geodesic', 0)), {
    original: null,
    diagonal: 1,
  }))!;
  expect(found.from).toBe('lri');
  expect(found.motions.map(({ method }) => method)).toEqual(['linear', 'geodesic']);
  found.times.forEach((t, i) => expect(found.motions[0]!.mean[i]).toBeCloseTo(10 * Math.abs(t), 4));
  // Points at distance sqrt(2/3) sqrt(0.36 + 0.64) from their centroid: |difference| is 0.1 |t| sqrt(3).
  const meanSquare = found.times.reduce((sum, t) => sum + t * t, 0) / found.times.length;
  expect(found.motions[0]!.kg).toBeCloseTo(100 * Math.sqrt((3 * 0.01 * meanSquare) / (2 / 3)), 3);
  expect(found.motions[1]!.kg).toBe(0);
  expect(held).toBe(0);
});

it('every motion is compared with the animation, between the keys only; a single motion is not compared', async () => {
  const alone = input(running('lri', 0.1));
  expect(await motionDistances(alone, { original: null, diagonal: 1 })).toBeNull();
  const original = (t: number) => ({ positions: triangle(0.2 * t) });
  const found = (await motionDistances(alone, { original, diagonal: 2 }))!;
  expect(found.from).toBeNull();
  expect([Math.min(...found.times), Math.max(...found.times)]).toEqual([0, 1]);
  expect(found.motions[0]!.largest[found.times.indexOf(1)]).toBeCloseTo(5, 4);
  expect(held).toBe(0);
});
