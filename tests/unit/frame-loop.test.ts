import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { RunningMotion } from '../../web/playback/frame-set.ts';
import { Demand } from '../../web/playback/demand.ts';
import { FrameLoop } from '../../web/playback/frame-loop.ts';
import type { AheadOptions } from '../../web/engine/api/api.ts';
import type { Frame } from '../../web/engine/api/types.ts';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

interface Open {
  t: number;
  resolve(frame: Frame | null): void;
  reject(error: unknown): void;
}

function setUp({ count = 1 } = {}) {
  const open: Open[] = [];
  const shown: string[] = [];
  const errors: unknown[] = [];
  const screen = { slow: false, yields: false, drawn: [] as (() => void)[] };
  let released = 0;
  let frames = 0;
  const frame = (t: number): Frame => {
    frames += 1;
    return {
      t,
      positions: new Float32Array(),
      normals: new Float32Array(),
      ms: 1,
      threads: 1,
      indefiniteFaces: 0,
      release: () => {
        released += 1;
      },
    };
  };
  const asked = (t: number, signal?: AbortSignal): Promise<Frame | null> =>
    new Promise((resolve, reject) => {
      const one: Open = { t, resolve, reject };
      open.push(one);
      signal?.addEventListener('abort', () => {
        if (open.includes(one)) open.splice(open.indexOf(one), 1);
        reject(new Error('taken back'));
      });
    });
  const running = (): RunningMotion =>
    ({
      method: 'lri',
      sequence: {
        evaluate: (t: number) => asked(t),
        evaluateAhead: (t: number, { signal }: AheadOptions) => asked(t, signal),
      },
    }) as unknown as RunningMotion;
  let sequences: readonly RunningMotion[] = Array.from({ length: count }, running);
  const loop = new FrameLoop(
    {
      show: ({ t }) => void shown.push(`${t}`),
      // On a slow screen, the test decides when a shape has been drawn.
      drawn: () => (screen.slow ? new Promise((resolve) => screen.drawn.push(resolve)) : Promise.resolve()),
      yields: () => screen.yields,
      onError: (error) => errors.push(error),
    },
    new Demand(() => sequences),
  );
  const pass = async (ms = 0): Promise<void> => {
    await vi.advanceTimersByTimeAsync(ms);
  };
  const reply = async (): Promise<void> => {
    const next = open.shift()!;
    next.resolve(frame(next.t));
    await pass();
  };
  const draw = async (): Promise<void> => {
    for (const resolve of screen.drawn.splice(0)) resolve();
    await pass();
  };
  return {
    loop,
    open,
    shown,
    errors,
    screen,
    pass,
    reply,
    draw,
    wanted: () => open.map(({ t }) => `${t}`),
    balance: () => frames - released,
    exchange: () => {
      sequences = [running()];
    },
  };
}

describe('the frame loop', () => {
  it('requests one time at a time and skips replaced ones', async () => {
    const { loop, shown, reply, balance, pass, wanted } = setUp();
    const all = [0.1, 0.2, 0.3].map((t) => loop.request(t));
    await pass();
    expect(wanted()).toEqual(['0.3']);
    const newer = loop.request(0.4);
    await reply();
    await Promise.all(all);
    expect(wanted()).toEqual(['0.4']);
    await reply();
    await newer;
    expect(shown).toEqual(['0.3', '0.4']);
    expect(balance()).toBe(0);
    expect(loop.busy).toBe(false);
  });

  it('shows all sequences together', async () => {
    const { loop, shown, reply, pass } = setUp({ count: 2 });
    const done = loop.request(0.5);
    await pass();
    await reply();
    expect(shown).toEqual([]);
    await reply();
    await done;
    expect(shown).toEqual(['0.5']);
  });

  it('requests frames from the new sequence if it was replaced meanwhile', async () => {
    const { loop, shown, reply, exchange, balance, pass, wanted } = setUp();
    const done = loop.request(0.5);
    await pass();
    exchange();
    await reply();
    expect(shown).toEqual([]);
    expect(wanted()).toEqual(['0.5']);
    await reply();
    await done;
    expect(shown).toEqual(['0.5']);
    expect(balance()).toBe(0);
  });

  it('reports a failure once and continues with the next time', async () => {
    const { loop, open, shown, errors, reply, pass } = setUp();
    const failed = loop.request(0.5);
    await pass();
    open.shift()!.reject(new Error('worker ended'));
    await failed;
    await pass();
    expect(errors).toHaveLength(1);
    const next = loop.request(0.6);
    await pass();
    await reply();
    await next;
    expect(shown).toEqual(['0.6']);
  });

  it('starts a waiting request as soon as a frame is done', async () => {
    const { loop, shown, reply, pass } = setUp();
    const both = loop.request(0.1).then(() => loop.request(0.2));
    await pass();
    await reply();
    await reply();
    await both;
    expect(shown).toEqual(['0.1', '0.2']);
    expect(loop.busy).toBe(false);
  });

  it('stops without sequences', async () => {
    const { loop } = setUp({ count: 0 });
    await loop.request(0.5);
    expect(loop.busy).toBe(false);
  });
});

describe('while the time moves', () => {
  it('the newest time is shown as soon as the previous one is drawn', async () => {
    const { loop, shown, reply, pass, wanted, balance } = setUp();
    loop.follow(0.1);
    await pass();
    for (const t of [0.2, 0.3, 0.4]) loop.follow(t);
    expect(wanted()).toEqual(['0.1']);
    await reply();
    expect(wanted()).toEqual(['0.4']);
    await reply();
    expect(shown).toEqual(['0.1', '0.4']);
    expect(loop.shown.t).toBe(0.4);
    expect(loop.busy).toBe(false);
    expect(balance()).toBe(0);
  });
});

describe('while the motion plays', () => {
  const clock = () => ({ tick: 0, timeOf: (tick: number) => tick / 10, tickSeconds: () => 1 / 60 });

  it('shapes are computed ahead and shown when they are due', async () => {
    const { loop, shown, reply, pass, wanted, balance } = setUp();
    const time = clock();
    loop.play(time);
    await pass();
    expect(wanted()).toEqual(['0', '0.1', '0.2', '0.3']);
    for (let k = 0; k < 4; k += 1) await reply();
    expect(shown).toEqual([]);
    loop.advance();
    await pass();
    expect(shown).toEqual(['0']);
    time.tick = 2;
    loop.advance();
    await pass();
    expect(shown).toEqual(['0', '0.2']);
    expect(wanted()).toEqual(['0.4', '0.5', '0.6']);
    loop.pause();
    await pass();
    expect(balance()).toBe(0);
  });

  it.each([
    ['leaves a slow machine to other work for four times as long as it was drawn', 200, [1, 1, 2]],
    ['goes on beside other work where drawing is quick', 20, [1, 2, 3]],
  ])('%s', async (_, drawingMs, counts) => {
    const { loop, shown, screen, reply, pass, draw, wanted } = setUp();
    Object.assign(screen, { slow: true, yields: true });
    const time = clock();
    loop.play(time);
    await pass();
    for (let round = 0; round < counts.length; round += 1) {
      while (wanted().length > 0) await reply();
      loop.advance();
      await pass(drawingMs);
      await draw();
      expect(shown).toHaveLength(counts[round]!);
      // Each round, including drawing, takes half a second.
      time.tick += 30;
      await pass(500 - drawingMs);
    }
    // Requested frames are not delayed.
    void loop.request(0.7);
    await pass();
    while (wanted().length > 0) await reply();
    expect(shown.at(-1)).toBe('0.7');
    loop.pause();
    await draw();
  });

  it('scrubbing cancels requests made ahead', async () => {
    const { loop, open, shown, errors, reply, pass } = setUp();
    loop.play(clock());
    await pass();
    expect(open).toHaveLength(4);
    loop.pause();
    loop.follow(0.7);
    await pass();
    expect(open).toHaveLength(1);
    await reply();
    expect(shown).toEqual(['0.7']);
    expect(errors).toEqual([]);
  });

  it('continues after a failure', async () => {
    const { loop, open, errors, pass, wanted } = setUp();
    loop.play(clock());
    await pass();
    for (const one of open.splice(0)) one.reject(new Error('worker ended'));
    await pass();
    expect(errors).toHaveLength(1);
    loop.advance();
    await pass();
    expect(wanted()).toEqual(['0', '0.1', '0.2', '0.3']);
  });

  it('frames of another motion are not shown', async () => {
    const { loop, shown, reply, pass, wanted, balance } = setUp();
    loop.play(clock());
    await pass();
    for (let k = 0; k < 4; k += 1) await reply();
    loop.follow(0);
    await pass();
    expect(shown).toEqual([]);
    expect(wanted()).toEqual(['0', '0.1', '0.2', '0.3']);
    expect(balance()).toBe(0);
  });

  it('frames of replaced sequences are not shown', async () => {
    const { loop, shown, reply, exchange, pass, wanted, balance } = setUp();
    loop.play(clock());
    await pass();
    for (let k = 0; k < 4; k += 1) await reply();
    exchange();
    loop.advance();
    await pass();
    expect(shown).toEqual([]);
    loop.advance();
    await pass();
    expect(wanted()).toEqual(['0', '0.1', '0.2', '0.3']);
    await reply();
    loop.advance();
    await pass();
    expect(shown).toEqual(['0']);
    loop.pause();
    await pass();
    expect(balance()).toBe(0);
  });

  it('a requested time is shown exactly, and playback continues from there', async () => {
    const { loop, shown, reply, pass, wanted } = setUp();
    loop.play(clock());
    await pass();
    for (let k = 0; k < 4; k += 1) await reply();
    void loop.request(0.7);
    await pass();
    expect(wanted()).toEqual(['0.7']);
    await reply();
    expect(shown).toEqual(['0.7']);
    expect(wanted()).toEqual(['0', '0.1', '0.2', '0.3']);
  });
});
