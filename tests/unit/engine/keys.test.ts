import { describe, expect, it } from 'vitest';
import { EngineError } from '../../../web/engine/api/errors.ts';
import { fakeEngine, someFile } from './fake-worker.ts';

const code = (work: () => unknown): string => {
  try {
    work();
  } catch (error) {
    if (error instanceof EngineError) return error.code;
    throw error;
  }
  return 'no error';
};

describe('keys', () => {
  it('are arranged again without another import, and leave the first ones unchanged', async () => {
    const keys = await fakeEngine().engine.importKeyframes([someFile]);
    const other = keys.arrange([1, 0, 1], [0, 2, 3], ['x', 'y', 'z']);
    expect([other.info.names, other.info.times]).toEqual([
      ['x', 'y', 'z'],
      [0, 2, 3],
    ]);
    expect(keys.arrange([1, 0], [0, 1]).info.names).toEqual(['b', 'a']);
    expect([keys.info.names, keys.info.times]).toEqual([
      ['a', 'b'],
      [0, 1],
    ]);
  });

  it('add a pose in order of time', async () => {
    const keys = await fakeEngine().engine.importKeyframes([someFile]);
    const pose = Float32Array.of(0, 0, 1, 1, 0, 1, 0, 1, 1);
    const added = keys.withPose('between', 0.5, pose);
    expect([added.info.names, added.info.times]).toEqual([
      ['a', 'between', 'b'],
      [0, 0.5, 1],
    ]);
    pose.fill(9);
    expect(added.positions(1)[2]).toBe(1);
    expect(keys.withPose('last', 2, pose).info.times).toEqual([0, 1, 2]);
    expect(keys.withPose('first', -1, pose).info.times).toEqual([-1, 0, 1]);
  });

  it('refuse poses and times that do not fit, with a code', async () => {
    const keys = await fakeEngine().engine.importKeyframes([someFile]);
    expect(code(() => keys.positions(2))).toBe('invalid-option');
    expect(code(() => keys.arrange([0, 2], [0, 1]))).toBe('invalid-option');
    expect(code(() => keys.arrange([0, 1], [0]))).toBe('time-count-mismatch');
    expect(code(() => keys.arrange([0, 1], [1, 1]))).toBe('times-not-increasing');
    expect(code(() => keys.arrange([0, 1], [0, 1], ['a']))).toBe('time-count-mismatch');
    expect(code(() => keys.withPose('same', 1, new Float32Array(9)))).toBe('times-not-increasing');
    expect(code(() => keys.withPose('short', 2, new Float32Array(6)))).toBe('vertex-count-mismatch');
  });

  it('return copies, and changes to them do not affect the keys', async () => {
    const keys = await fakeEngine().engine.importKeyframes([someFile]);
    keys.positions(0).fill(7);
    expect(keys.positions(0)[0]).toBe(0);
  });
});
