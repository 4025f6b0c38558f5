import { expect, it } from 'vitest';
import { sizeRows } from '../../web/app/panels/ghost-study-result.ts';
import type { GhostRow } from '../../web/study/ghost-study.ts';

it('a comparison has a row for each size, and one without a ghost mesh', () => {
  const row = (wanted: number, transfer: GhostRow['transfer'], kg: number): GhostRow =>
    ({ wanted, faces: wanted, transfer, kg, ms: kg + 1, buildMs: 1 }) as GhostRow;
  const rows = [row(500, 'exact', 1), row(500, 'paper', 2), row(1000, 'exact', 3), row(1000, 'paper', 4)];
  const found = sizeRows({ faces: 5000, ms: 9, buildMs: 1, fits: { warnings: [], note: '' }, rows });
  expect(found.map(({ size }) => size)).toEqual([500, 1000, null]);
  expect(found.map(({ measured }) => [measured.exact.kg, measured.paper.kg])).toEqual([
    [1, 2],
    [3, 4],
    [0, 0],
  ]);
  expect(found.at(-1)!.measured.paper.ms).toBe(9);
});
