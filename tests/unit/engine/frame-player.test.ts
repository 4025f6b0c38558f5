import { describe, expect, it } from 'vitest';
import { FramePlayer } from '../../../web/engine/api/frame-player.ts';
import type { Frame } from '../../../web/engine/api/types.ts';
import { settled } from './fake-worker.ts';

interface Requested {
  t: number;
  reply(): Promise<void>;
  fail(): Promise<void>;
}

/** A sequence whose frames arrive on command; counts frames that were not released. */
function heldSequence(ms = 1) {
  const asked: Requested[] = [];
  const counts = { out: 0 };
  const evaluateAhead = (t: number): Promise<Frame> =>
    new Promise((resolve, reject) => {
      const none = new Float32Array(0);
      const frame: Frame = {
        t,
        positions: none,
        normals: none,
        ms,
        threads: 1,
        indefiniteFaces: 0,
        release: () => void --counts.out,
      };
      asked.push({
        t,
        reply: async () => {
          ++counts.out;
          resolve(frame);
          await settled();
        },
        fail: async () => {
          reject(new Error('gone'));
          await settled();
        },
      });
    });
  return { sequence: { evaluateAhead }, asked, counts };
}

const settings = { timeOf: (tick: number) => tick / 10, tickSeconds: () => 1 / 60, ahead: 3 };

describe('the frame player', () => {
  it('requests a bounded number of ticks ahead and delivers each when it is due', async () => {
    const { sequence, asked, counts } = heldSequence();
    const player = new FramePlayer(sequence, settings);
    expect(player.take(0)).toBeNull();
    expect(asked.map(({ t }) => t)).toEqual([0, 0.1, 0.2]);
    for (const one of asked.slice()) await one.reply();
    expect(asked).toHaveLength(3);
    for (const tick of [0, 1, 2]) {
      const frame = player.take(tick);
      expect(frame?.t).toBe(tick / 10);
      frame?.release();
    }
    expect(asked.map(({ t }) => t)).toEqual([0, 0.1, 0.2, 0.3, 0.4, 0.5]);
    expect(counts.out).toBe(0);
  });

  it('skips late frames and releases them', async () => {
    const { sequence, asked, counts } = heldSequence();
    const player = new FramePlayer(sequence, settings);
    player.take(0);
    for (const one of asked.slice()) await one.reply();
    expect(player.take(7)?.t).toBe(0.2);
    expect(counts.out).toBe(1);
    expect(asked.at(-1)?.t).toBeGreaterThan(0.7);
  });

  it('requests ticks further apart if frames take longer than a tick', async () => {
    const { sequence, asked } = heldSequence(40); // 2.4 ticks
    const player = new FramePlayer(sequence, settings);
    player.take(0);
    for (const one of asked.slice()) await one.reply();
    player.take(4);
    expect(asked.slice(3).map(({ t }) => Math.round(10 * t))).toEqual([7, 10, 13]);
  });

  it('requests about as many frames as are drawn if drawing is slow, and more otherwise', async () => {
    const { sequence, asked } = heldSequence();
    const player = new FramePlayer(sequence, settings);
    let [tick, answered] = [0, 0];
    const drawn = async (times: number, apart: number): Promise<{ asked: number; drawn: number }> => {
      const before = asked.length;
      let seen = 0;
      for (let i = 0; i < times; i++, tick += apart) {
        const frame = player.take(tick);
        frame?.release();
        seen += Number(frame !== null);
        while (answered < asked.length) await asked[answered++]!.reply();
      }
      return { asked: asked.length - before, drawn: seen };
    };
    await drawn(20, 4);
    const slow = await drawn(40, 4);
    expect(slow.drawn).toBeGreaterThan(36);
    expect(slow.asked).toBeLessThan(1.4 * slow.drawn);
    // Each image takes at least a fifth of a second.
    await drawn(20, 16);
    const slowest = await drawn(40, 16);
    expect(slowest.asked).toBeLessThan(2 * slowest.drawn);
    await drawn(80, 1);
    const fast = await drawn(40, 1);
    expect(fast).toEqual({ asked: 40, drawn: 40 });
    // The page was hidden for some time.
    tick += 1000;
    await drawn(40, 1);
    expect(await drawn(40, 1)).toEqual({ asked: 40, drawn: 40 });
  });

  it('requests once for ticks that show the same time', async () => {
    const { sequence, asked } = heldSequence();
    const player = new FramePlayer(sequence, { ...settings, timeOf: (tick) => Math.floor(tick / 4) });
    player.take(0);
    expect(asked.map(({ t }) => t)).toEqual([0, 1, 2]);
    for (const one of asked.slice()) await one.reply();
    expect(player.take(3)?.t).toBe(0);
    expect(player.take(4)?.t).toBe(1);
    expect(asked.map(({ t }) => t)).toEqual([0, 1, 2, 3, 4]);
  });

  it('requests nothing more while the time does not change', () => {
    const { sequence, asked } = heldSequence();
    const player = new FramePlayer(sequence, { ...settings, timeOf: () => 0.5 });
    player.take(0);
    player.take(1);
    expect(asked).toHaveLength(1);
  });

  it('releases all frames when it stops, also frames that arrive later', async () => {
    const { sequence, asked, counts } = heldSequence();
    const player = new FramePlayer(sequence, settings);
    player.take(0);
    await asked[0]?.reply();
    player.stop();
    await asked[1]?.reply();
    expect(counts.out).toBe(0);
    expect(player.take(1)).toBeNull();
    expect(asked).toHaveLength(3);
  });

  it('reports an error once and stops', async () => {
    const { sequence, asked } = heldSequence();
    const errors: unknown[] = [];
    const player = new FramePlayer(sequence, { ...settings, onError: (error) => errors.push(error) });
    player.take(0);
    for (const one of asked.slice()) await one.fail();
    expect(errors).toHaveLength(1);
    player.take(1);
    expect(asked).toHaveLength(3);
  });
});
