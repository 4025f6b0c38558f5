import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Player } from '../../web/playback/player.ts';
import type { PlayerView } from '../../web/playback/player.ts';

/** A screen that refreshes on command. */
let now = 0;
let callbacks: (() => void)[] = [];

beforeEach(() => {
  now = 0;
  callbacks = [];
  vi.stubGlobal('requestAnimationFrame', (callback: () => void) => callbacks.push(callback));
  vi.stubGlobal('cancelAnimationFrame', () => {
    callbacks = [];
  });
  vi.spyOn(performance, 'now').mockImplementation(() => now);
});

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

function start(
  change: Partial<PlayerView['play']>,
  time = 0,
  periodic = false,
): { view: PlayerView; times: number[]; ticks: number[]; player: Player; run(ms: number): void } {
  const view: PlayerView = {
    time,
    range: [0, 1],
    periodic,
    play: { playing: true, speed: 1, loop: 'loop', between: null, fps: null, ...change },
  };
  const times: number[] = [];
  const ticks: number[] = [];
  const player: Player = new Player(
    () => view,
    (next, playing) => {
      view.time = next;
      view.play = { ...view.play, playing };
      times.push(next);
    },
    () => ticks.push(player.tick),
  );
  player.start();
  const run = (ms: number): void => {
    for (const end = now + ms; now < end; ) {
      now += 10;
      const due = callbacks;
      callbacks = [];
      for (const callback of due) callback();
    }
  };
  return { view, times, ticks, player, run };
}

describe('playing', () => {
  it('advances with the screen', () => {
    const { times, run } = start({});
    run(300);
    expect(times).toHaveLength(30);
    expect(times.at(-1)).toBeCloseTo(0.3, 9);
  });

  it('shows whole frames only, each for its duration', () => {
    const { times, run } = start({ fps: 10 });
    run(1000);
    expect(times).toEqual([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0]);
  });

  it('loops within the chosen range', () => {
    const { times, run } = start({ between: [0.3, 0.5] }, 0.3);
    run(1000);
    expect(Math.min(...times)).toBeGreaterThanOrEqual(0.3);
    expect(Math.max(...times)).toBeLessThanOrEqual(0.5);
    expect(times.filter((t, i) => i > 0 && t < times[i - 1]!)).toHaveLength(5);
  });

  it('starts at the chosen range from a time outside it; the range can extend beyond the keys', () => {
    const { times, run } = start({ between: [1.1, 1.3], loop: 'bounce' }, 0.2);
    run(400);
    expect(times[0]).toBe(1.1);
    expect(Math.max(...times)).toBeCloseTo(1.3, 1);
    expect(Math.min(...times)).toBe(1.1);
  });

  it('plays a range of a closed motion like any range', () => {
    const { times, run } = start({ between: [0.3, 0.5], loop: 'bounce' }, 0.3, true);
    run(400);
    expect(times.some((t, i) => i > 0 && t < times[i - 1]! && t > 0.4)).toBe(true);
    expect(Math.max(...times)).toBeLessThanOrEqual(0.5);
  });

  it('stops on the last frame if it plays once, and restarts from there', () => {
    const { view, times, run } = start({ fps: 4, loop: 'once', between: [0.1, 0.9] }, 0.1);
    run(1200);
    expect(view.play.playing).toBe(false);
    expect(times).toEqual([0.25, 0.5, 0.75, 0.75]);
  });

  it('predicts its times: forth and back, and in whole frames', () => {
    const { player, times, run } = start({ loop: 'bounce' });
    run(1500);
    for (const ahead of [1, 7, 90]) {
      const forecast = player.timeOf(player.tick + ahead);
      run(10 * ahead);
      expect(times.at(-1)).toBeCloseTo(forecast, 3);
    }
    const held = start({ fps: 10 });
    held.run(1450);
    expect(held.player.timeOf(held.player.tick)).toBe(0.4);
    expect(held.player.timeOf(held.player.tick + 20)).toBe(0.6);
  });

  it('counts the refreshes of the screen, including those that a busy page missed', () => {
    const { ticks, run } = start({ fps: 1 });
    run(1000);
    expect(ticks).toEqual(Array.from({ length: 100 }, (_, i) => i + 1));
    now += 50;
    run(10);
    expect(ticks.at(-1)).toBe(106);
  });

  it('continues from a time that was set elsewhere', () => {
    const { view, times, run } = start({ fps: 10 });
    run(200);
    view.time = 0.75;
    run(10);
    expect(times.at(-1)).toBe(0.7);
    run(100);
    expect(times.at(-1)).toBe(0.8);
  });
});
