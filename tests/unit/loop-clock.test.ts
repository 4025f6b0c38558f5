import { describe, expect, it } from 'vitest';
import { tick } from '../../web/playback/loop-clock.ts';
import type { ClockInput } from '../../web/playback/loop-clock.ts';

const base: ClockInput = { time: 0, direction: 1, step: 0.1, range: [0, 1], loop: 'bounce', periodic: false };

describe('the clock', () => {
  it('advances by its step', () => {
    expect(tick({ ...base, time: 0.3 })).toMatchObject({ direction: 1, playing: true });
    expect(tick({ ...base, time: 0.3 }).time).toBeCloseTo(0.4, 12);
  });

  it('reverses at both ends and keeps the rest of the step', () => {
    const end = tick({ ...base, time: 0.96 });
    expect(end.time).toBeCloseTo(0.94, 12);
    expect(end.direction).toBe(-1);
    const start = tick({ ...base, time: 0.03, direction: -1 });
    expect(start.time).toBeCloseTo(0.07, 12);
    expect(start.direction).toBe(1);
  });

  it('stops exactly at the end if it plays once', () => {
    expect(tick({ ...base, time: 0.95, loop: 'once' })).toEqual({ time: 1, direction: 1, playing: false });
  });

  it('starts over in a loop', () => {
    const next = tick({ ...base, time: 0.95, loop: 'loop' });
    expect(next.time).toBeCloseTo(0.05, 12);
    expect(next.playing).toBe(true);
  });

  it('loops a closed motion for every setting except playing once', () => {
    expect(tick({ ...base, time: 0.95, periodic: true }).time).toBeCloseTo(0.05, 12);
    expect(tick({ ...base, time: 0.95, periodic: true, loop: 'once' }).playing).toBe(false);
  });

  it('enters the range from outside without a jump', () => {
    expect(tick({ ...base, time: -0.35 }).time).toBeCloseTo(-0.25, 12);
    const over = tick({ ...base, time: 1.35 });
    expect(over.time).toBeCloseTo(1.25, 12);
    expect(over.direction).toBe(-1);
  });

  it('never leaves the range if a step is longer than it', () => {
    for (const loop of ['bounce', 'loop', 'once'] as const) {
      const { time } = tick({ ...base, time: 0.5, step: 7.3, loop });
      expect(time).toBeGreaterThanOrEqual(0);
      expect(time).toBeLessThanOrEqual(1);
    }
  });

  it('does not advance without a range', () => {
    expect(tick({ ...base, range: [1, 1], time: 1 }).playing).toBe(false);
  });
});
