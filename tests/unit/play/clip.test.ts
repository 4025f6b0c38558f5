/** Drawn lines are no longer than plots, however far a curve extends. */
import { expect, it } from 'vitest';
import { FARTHEST, clipped } from '../../../web/play/figures/clip.ts';

const within = (points: readonly (readonly [number, number])[]): boolean =>
  points.every((point) => point.every((x) => Number.isNaN(x) || Math.abs(x) <= FARTHEST * (1 + 1e-12)));

it('near parts are unchanged', () => {
  const near = [
    [0, 0],
    [100, -300],
    [FARTHEST, FARTHEST],
  ] as const;
  expect(clipped(near)).toEqual(near);
});

it('a line that leaves continues in its direction up to the limit', () => {
  const [from, to] = clipped([
    [100, 100],
    [200, 1e9],
  ]);
  expect(from).toEqual([100, 100]);
  expect(to![1]).toBeCloseTo(FARTHEST);
  expect((to![1] - 100) / (to![0] - 100)).toBeCloseTo((1e9 - 100) / 100, -3);
});

it('a line that returns has a gap, and one that stays outside is removed', () => {
  const back = clipped([
    [0, 0],
    [1, 1e6],
    [2, 1e6],
    [3, 0],
  ]);
  expect(back.filter(([x]) => Number.isNaN(x))).toHaveLength(1);
  expect([back[0], back.at(-1), within(back)]).toEqual([[0, 0], [3, 0], true]);
  expect(
    clipped([
      [0, 1e7],
      [9, 2e7],
      [10, 1e7],
    ]),
  ).toEqual([]);
});

it('for any numbers, nothing is beyond the limit', () => {
  const numbers = [0, 1, -7, 4999, 5001, -1e6, 1e12, 1e30, -1e300];
  for (const a of numbers)
    for (const b of numbers)
      for (const c of numbers)
        expect(
          within(
            clipped([
              [a, b],
              [b, c],
              [c, a],
            ]),
          ),
        ).toBe(true);
});
