import { describe, expect, it } from 'vitest';
import { Demand } from '../../web/playback/demand.ts';
import type { FrameSet, RunningMotion } from '../../web/playback/frame-set.ts';

function setUp() {
  let sequences: readonly RunningMotion[] = [];
  const off: { blend: readonly number[] | null } = { blend: null };
  const demand = new Demand(
    () => sequences,
    () => off.blend,
  );
  const frames = (t: number): FrameSet => ({
    t,
    blend: null,
    frames: [],
    sequences,
    ms: 1,
    release: () => undefined,
  });
  return {
    demand,
    off,
    frames,
    exchange: () => {
      sequences = [];
    },
  };
}

describe('the demand for times', () => {
  it('is empty at first, and after the frame is shown', () => {
    const { demand, frames } = setUp();
    expect(demand.open).toBe(false);
    demand.want(0.5);
    expect([demand.wanted.t, demand.open]).toEqual([0.5, true]);
    demand.noteShown(frames(0.5));
    demand.close(demand.wanted);
    expect([demand.open, demand.shown.t]).toEqual([false, 0.5]);
  });

  it('is for the newest time only', () => {
    const { demand } = setUp();
    demand.want(0.1);
    const overtaken = demand.wanted;
    demand.want(0.2);
    demand.close(overtaken);
    expect([demand.wanted.t, demand.open]).toEqual([0.2, true]);
  });

  it('ignores frames of replaced sequences', () => {
    const { demand, frames, exchange } = setUp();
    const set = frames(0.5);
    expect(demand.isCurrent(set)).toBe(true);
    exchange();
    expect(demand.isCurrent(set)).toBe(false);
  });

  it('is for the blend while there is one', () => {
    const { demand, off } = setUp();
    off.blend = [0.5, 0.5];
    demand.want(0.4);
    expect(demand.wanted.blend).toBe(off.blend);
    off.blend = null;
    demand.want(0.4);
    expect(demand.wanted.blend).toBeNull();
  });
});
