import { describe, expect, it } from 'vitest';
import { angleOf, patchCurves } from '../../web/app/analysis/patch-curves.ts';

/** A stretch, and rotations about x by these angles in degrees. */
const row = (stretch: number, ...angles: number[]): number[] => [
  stretch,
  ...angles.flatMap((angle) => [Math.cos((angle * Math.PI) / 360), Math.sin((angle * Math.PI) / 360), 0, 0]),
];

describe('a patch over time', () => {
  it('has a vector of degrees relative to each neighbour, the largest rotation first', () => {
    const numbers = [...row(1, 0, 0), ...row(1.1, 10, -30), ...row(1.2, 20, -60)];
    const { neighbours, stretch } = patchCurves({ neighbours: [4, 7], numbers, natural: numbers }, numbers, 0);
    expect(stretch).toEqual([1, 1.1, 1.2]);
    expect(neighbours.map(({ patch }) => patch)).toEqual([7, 4]);
    expect(neighbours[0]!.turn.map(([x]) => Math.round(x))).toEqual([0, -30, -60]);
    expect(neighbours[1]!.turn.map(angleOf).map(Math.round)).toEqual([0, 10, 20]);
  });

  it('continues past half turns and full turns, on both sides of the reference', () => {
    const angles = [-500, -380, -250, -120, 0, 120, 250, 380, 500];
    const numbers = angles.flatMap((angle) => row(1, angle));
    const { neighbours } = patchCurves({ neighbours: [1], numbers, natural: numbers }, numbers, 4);
    expect(neighbours[0]!.turn.map(([x]) => Math.round(x))).toEqual(angles);
  });

  it('can be without neighbours', () => {
    expect(patchCurves({ neighbours: [], numbers: [1, 2], natural: [1, 2] }, [1, 2], 0)).toEqual({
      neighbours: [],
      stretch: [1, 2],
    });
  });
});
