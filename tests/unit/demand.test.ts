import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Demand } from '../../web/playback/demand.ts';
import type { Wanted } from '../../web/playback/demand.ts';
import type { FrameSet } from '../../web/playback/frame-set.ts';
import { PreviewPolicy } from '../../web/playback/preview-policy.ts';
import type { RunningSequence } from '../../web/app/session/sequence-set.ts';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

const sequence = { keyTimes: [0, 1], range: [0, 1], options: { boundary: 'natural' } };
const running = (): RunningSequence => ({ method: 'lri', sequence }) as unknown as RunningSequence;

/** Previews are drawn for everything that moves. */
function setUp() {
  let sequences: readonly RunningSequence[] = [running()];
  const off: { blend: readonly number[] | null } = { blend: null };
  const demand = new Demand(
    () => sequences,
    new PreviewPolicy('preview'),
    () => off.blend,
  );
  const frames = (t: number, preview: boolean): FrameSet => ({
    t,
    blend: null,
    frames: [],
    sequences,
    preview,
    ms: 1,
    release: () => undefined,
  });
  /** Does what is to be done next. */
  const serve = (): FrameSet | null => {
    const next = demand.next();
    if (!next || 'restsIn' in next) return null;
    const set = frames(next.wanted.t, next.preview);
    demand.noteShown(set);
    demand.close(next.wanted, next.preview);
    return set;
  };
  const words = (): string => {
    const next = demand.next();
    if (!next) return 'nothing';
    return 'restsIn' in next ? `rest ${next.restsIn}` : `${next.preview ? 'preview' : 'exact'} ${next.wanted.t}`;
  };
  return {
    demand,
    off,
    frames,
    serve,
    words,
    exchange: () => {
      sequences = [running()];
    },
  };
}

describe('the demand for times', () => {
  it('is for nothing at first, and for nothing when an exact frame was shown', () => {
    const { demand, serve, words } = setUp();
    expect([words(), demand.open]).toEqual(['nothing', false]);
    demand.want(0.5);
    expect([words(), demand.open]).toEqual(['exact 0.5', true]);
    serve();
    expect([words(), demand.open]).toEqual(['nothing', false]);
    expect(demand.shown).toMatchObject({ t: 0.5, preview: false });
  });

  it('is for the newest time alone', () => {
    const { demand, words } = setUp();
    demand.want(0.1);
    const overtaken: Wanted = demand.wanted;
    demand.want(0.2);
    expect(words()).toBe('exact 0.2');
    expect([demand.isNewest(overtaken), demand.isNewest(demand.wanted)]).toEqual([false, true]);
    demand.close(overtaken, false);
    expect(words()).toBe('exact 0.2');
  });

  it('is for a preview while the time moves, and for the exact frame when it rests', () => {
    const { demand, serve, words } = setUp();
    demand.follow(0.3);
    expect(words()).toBe('preview 0.3');
    serve();
    expect([words(), demand.open]).toEqual(['rest 80', true]);
    vi.advanceTimersByTime(80);
    expect(words()).toBe('exact 0.3');
    serve();
    expect(words()).toBe('nothing');
  });

  it('does not wait for rest when the pointer is lifted, once', () => {
    const { demand, serve, words } = setUp();
    demand.follow(0.3);
    serve();
    expect(demand.settle()).toBe(true);
    expect(words()).toBe('exact 0.3');
    expect(demand.settle()).toBe(false);
  });

  it('counts the rest from when a preview was drawn, unless another time is wanted', () => {
    const { demand, serve, words } = setUp();
    demand.follow(0.3);
    const { wanted } = demand;
    serve();
    vi.advanceTimersByTime(50);
    demand.noteDrawn(wanted);
    expect(words()).toBe('rest 80');
    demand.want(0.4);
    demand.noteDrawn(wanted);
    expect(words()).toBe('exact 0.4');
  });

  it('eases only the exact frame of a preview that is shown, made by the same sequences', () => {
    const { demand, serve, frames, exchange } = setUp();
    expect(demand.eases(frames(0.3, false))).toBe(false);
    demand.follow(0.3);
    serve();
    expect(demand.eases(frames(0.3, false))).toBe(true);
    expect([demand.eases(frames(0.3, true)), demand.eases(frames(0.4, false))]).toEqual([false, false]);
    exchange();
    expect(demand.eases(frames(0.3, false))).toBe(false);
  });

  it('has no use for frames of sequences that were exchanged', () => {
    const { demand, frames, exchange } = setUp();
    const set = frames(0.5, false);
    expect(demand.isCurrent(set)).toBe(true);
    exchange();
    expect(demand.isCurrent(set)).toBe(false);
  });

  it('is for a blend as long as there is one: exact at once, as blends have no previews', () => {
    const { demand, off, serve, words } = setUp();
    off.blend = [0.5, 0.5];
    demand.follow(0.4);
    expect([words(), demand.wanted.blend]).toEqual(['exact 0.4', off.blend]);
    serve();
    expect(words()).toBe('nothing');
    off.blend = null;
    demand.follow(0.4);
    expect([words(), demand.wanted.blend]).toEqual(['preview 0.4', null]);
  });
});
