import { describe, expect, it } from 'vitest';
import type { RunningMotion } from '../../web/playback/frame-set.ts';
import { FrameCost } from '../../web/playback/frame-cost.ts';

const running = (shape = {}): RunningMotion[] => [
  { method: 'lri', ghost: 0, sequence: { shape } } as unknown as RunningMotion,
];

describe('the cost of frames', () => {
  it('is unknown before the second frame', () => {
    const [cost, sequences] = [new FrameCost(), running()];
    expect(cost.typical(sequences)).toBe(0);
    cost.note({ sequences, ms: 300 });
    expect(cost.typical(sequences)).toBe(0);
  });

  it('is the median of the last three', () => {
    const [cost, sequences] = [new FrameCost(), running()];
    for (const ms of [1, 300, 90, 80]) cost.note({ sequences, ms });
    expect(cost.typical(sequences)).toBe(90);
  });

  it('is taken from another motion of the same shape and method, and unknown for others', () => {
    const shape = {};
    const [cost, sequences] = [new FrameCost(), running(shape)];
    for (const ms of [20, 30]) cost.note({ sequences, ms });
    expect(cost.typical(running(shape))).toBe(20);
    expect(cost.typical(running())).toBe(0);
  });
});
