import { expect, it } from 'vitest';
import type { PatchCurve } from '../../web/engine/api/types.ts';
import { turnAlong } from '../../web/study/turn-along.ts';

/** Patches side by side, numbered along the row, each rotated about x by this many degrees relative to the previous. */
function row(patches: number, degrees: readonly number[]): (patch: number) => Promise<PatchCurve> {
  const turn = (angle: number): number[] => {
    const half = (angle * Math.PI) / 360;
    return [Math.cos(half), Math.sin(half), 0, 0];
  };
  return async (patch) => {
    const neighbours = [patch - 1, patch + 1].filter((one) => one >= 0 && one < patches);
    const numbers = degrees.flatMap((angle) => [1, ...neighbours.flatMap((one) => turn(one > patch ? angle : -angle))]);
    return { neighbours, numbers, natural: numbers };
  };
}

it('rotations add up from one end to the other, beyond a full turn', async () => {
  const turn = (await turnAlong(10, 2, row(10, [30, 60])))!;
  expect(turn.patches).toBe(10);
  expect(turn.total[0]).toBeCloseTo(270, 9);
  expect(turn.total[1]).toBeCloseTo(540, 9);
  expect(turn.largest).toBeCloseTo(60, 9);
});

it('the sum is zero without neighbours', async () => {
  expect(await turnAlong(1, 1, row(1, [0]))).toBeNull();
});
