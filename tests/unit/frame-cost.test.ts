import { describe, expect, it } from 'vitest';
import { FrameCost } from '../../web/playback/frame-cost.ts';

function costOf(exact: number[], previews: number[] = []): FrameCost {
  const cost = new FrameCost();
  for (const ms of exact) cost.note({ preview: false, ms });
  for (const ms of previews) cost.note({ preview: true, ms });
  return cost;
}

describe('the cost of frames', () => {
  it('is not known before there were some', () => {
    const cost = costOf([300]);
    expect([cost.knowsExact, cost.typical(false), cost.least(true), cost.hasPreviews]).toEqual([false, 0, 0, false]);
  });

  it('is told by the last three', () => {
    const cost = costOf([1, 300, 90, 80]);
    expect([cost.knowsExact, cost.least(false), cost.typical(false)]).toEqual([true, 80, 90]);
  });

  it('leaves out the first preview, which makes what all need', () => {
    expect(costOf([], [500]).hasPreviews).toBe(true);
    expect(costOf([], [500]).least(true)).toBe(0);
    expect(costOf([], [500, 20, 30]).least(true)).toBe(20);
    expect(costOf([], [500, 20, 30]).typical(true)).toBe(20);
  });
});
