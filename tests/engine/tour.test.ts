/** The steps of the tour show the described effects. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { TOUR } from '../../web/app/guide/tour.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import { make } from '../../web/sculpt/make.ts';
import { frameAt, testEngine } from './support/engines.ts';

const engine = testEngine();
/** Number of vertices of one shape to find in the other. */
const PROBES = 300;

/** Distance of the surfaces in percent of the diagonal, independent of their vertex order. */
function apart(a: Float32Array, b: Float32Array, diagonal: number): number {
  const step = 3 * Math.ceil(a.length / 3 / PROBES);
  let most = 0;
  for (let i = 0; i < a.length; i += step) {
    let least = Infinity;
    for (let j = 0; j < b.length; j += 3)
      least = Math.min(least, Math.hypot(a[i]! - b[j]!, a[i + 1]! - b[j + 1]!, a[i + 2]! - b[j + 2]!));
    most = Math.max(most, least);
  }
  return (100 * most) / diagonal;
}

it('the full turn added in the fourth step changes the shape between the keys', async () => {
  const { sample, keys } = readPermalink(TOUR[3]!.state)!;
  const file = new URL(`../../public/samples/${sample}.glb`, import.meta.url);
  const bytes = await make(sample, 1).then(
    (made) => made.bytes,
    () => readFile(file),
  );
  const poses = await engine.importKeyframes([{ name: `${sample}.glb`, bytes }]);
  const chosen = poses.arrange(
    keys!.map(([pose]) => pose),
    keys!.map(([, time]) => time),
  );
  const [plain, turned] = await Promise.all([
    engine.createSequence(chosen),
    engine.createSequence(chosen, { turns: [{ key: 1, turns: 1 }] }),
  ]);
  const [one, other] = [(await frameAt(plain, 0.25)).positions, (await frameAt(turned, 0.25)).positions];
  expect(apart(one, other, poses.info.report.diagonal)).toBeGreaterThan(1.5);
});
