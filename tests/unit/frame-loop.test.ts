import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { RunningSequence } from '../../web/app/session/sequence-set.ts';
import { Demand } from '../../web/playback/demand.ts';
import { PreviewPolicy, readMoving, type Moving } from '../../web/playback/preview-policy.ts';
import { FrameLoop } from '../../web/playback/frame-loop.ts';
import type { AheadOptions } from '../../web/engine/api/api.ts';
import type { Frame, Method, PreviewError } from '../../web/engine/api/types.ts';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

interface Open {
  t: number;
  preview: boolean;
  resolve(frame: Frame | null): void;
  reject(error: unknown): void;
}

/** Milliseconds of an exact frame and of a cheap one. */
function setUp({
  count = 1,
  exactMs = 1,
  cheapMs = 1,
  method = 'lri' as Method,
  moving = 'measured' as Moving,
  off = (_t: number): PreviewError => ({ mean: 0, largest: 0 }),
} = {}) {
  const open: Open[] = [];
  const shown: string[] = [];
  const errors: unknown[] = [];
  const measured: number[] = [];
  const screen = { easing: false, slow: false, yields: false, drawn: [] as (() => void)[] };
  let released = 0;
  let frames = 0;
  const frame = (t: number, preview: boolean): Frame => {
    frames += 1;
    const ms = preview ? cheapMs : exactMs;
    return {
      t,
      positions: new Float32Array(),
      normals: new Float32Array(),
      ms,
      threads: 1,
      indefiniteFaces: 0,
      release: () => {
        released += 1;
      },
    };
  };
  const asked = (t: number, preview: boolean, signal?: AbortSignal): Promise<Frame | null> =>
    new Promise((resolve, reject) => {
      const one: Open = { t, preview, resolve, reject };
      open.push(one);
      signal?.addEventListener('abort', () => {
        if (open.includes(one)) open.splice(open.indexOf(one), 1);
        reject(new Error('taken back'));
      });
    });
  const running = (): RunningSequence =>
    ({
      method,
      sequence: {
        keyTimes: [0, 0.5, 1],
        range: [0, 1],
        options: { boundary: 'natural' },
        previewError: async (t: number) => {
          measured.push(t);
          return off(t);
        },
        evaluate: (t: number) => asked(t, false),
        preview: (t: number) => asked(t, true),
        evaluateAhead: (t: number, { preview = false, signal }: AheadOptions) => asked(t, preview, signal),
      },
    }) as unknown as RunningSequence;
  let sequences: readonly RunningSequence[] = Array.from({ length: count }, running);
  const loop = new FrameLoop(
    {
      show: ({ t, preview }, eased) => {
        shown.push(`${preview ? 'preview ' : ''}${t}${eased ? ' eased' : ''}`);
        screen.easing = eased;
      },
      // An eased shape is drawn when the test says so, as is every one on a slow screen.
      drawn: () =>
        screen.easing || screen.slow ? new Promise((resolve) => screen.drawn.push(resolve)) : Promise.resolve(),
      yields: () => screen.yields,
      onError: (error) => errors.push(error),
    },
    new Demand(() => sequences, new PreviewPolicy(moving)),
  );
  const pass = async (ms = 0): Promise<void> => {
    await vi.advanceTimersByTimeAsync(ms);
  };
  const reply = async (): Promise<void> => {
    const next = open.shift()!;
    next.resolve(frame(next.t, next.preview));
    await pass();
  };
  /** Exact shapes have been asked for and answered: their time is known. */
  const learn = async (): Promise<void> => {
    for (const t of [0.91, 0.92]) {
      void loop.request(t);
      await pass();
      for (let index = 0; index < count; index += 1) await reply();
    }
    shown.length = 0;
  };
  /** And, in a moment of rest, what cheap ones take and are off. */
  const ready = async (): Promise<void> => {
    await learn();
    await pass(400);
    while (open.length > 0) await reply();
    shown.length = 0;
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
    measured,
    screen,
    pass,
    reply,
    learn,
    ready,
    draw,
    wanted: () => open.map(({ t, preview }) => `${preview ? 'preview ' : ''}${t}`),
    balance: () => frames - released,
    exchange: () => {
      sequences = [running()];
    },
    refit: () => {
      sequences = [...sequences];
    },
  };
}

describe('the frame loop', () => {
  it('asks for one moment at a time and skips those that were overtaken', async () => {
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

  it('asks the successor when the sequence is exchanged meanwhile', async () => {
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

  it('reports a failure once and goes on with the next moment', async () => {
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

  it('takes up what is asked for the moment that a frame is done', async () => {
    const { loop, shown, reply, pass } = setUp();
    const both = loop.request(0.1).then(() => loop.request(0.2));
    await pass();
    await reply();
    await reply();
    await both;
    expect(shown).toEqual(['0.1', '0.2']);
    expect(loop.busy).toBe(false);
  });

  it('ends without sequences', async () => {
    const { loop } = setUp({ count: 0 });
    await loop.request(0.5);
    expect(loop.busy).toBe(false);
  });
});

describe('while the time moves', () => {
  const slow = { exactMs: 90, cheapMs: 25 };

  it.each([
    ['small shapes are exact, and asked for once', { exactMs: 29 }],
    [
      'large shapes are exact where the address asks for it, and no cheap one is made',
      { ...slow, moving: 'exact' as const },
    ],
  ])('%s', async (_, settings) => {
    const { loop, shown, learn, reply, pass, wanted } = setUp(settings);
    await learn();
    loop.follow(0.5);
    await pass();
    await reply();
    await pass(1000);
    expect(shown).toEqual(['0.5']);
    expect(wanted()).toEqual([]);
    expect(loop.busy).toBe(false);
  });

  it('small shapes are previews, too, where the address asks for it, and exact when they rest', async () => {
    const { loop, shown, reply, pass, draw } = setUp({ moving: 'preview' });
    loop.follow(0.5);
    await pass();
    await reply();
    expect(shown).toEqual(['preview 0.5']);
    await pass(100);
    await reply();
    await draw();
    expect(shown).toEqual(['preview 0.5', '0.5 eased']);
    expect(loop.busy).toBe(false);
  });

  it('methods that blend positions are exact whatever the address asks for', async () => {
    const { loop, shown, reply, pass } = setUp({ moving: 'preview', method: 'linear' });
    loop.follow(0.5);
    await pass();
    await reply();
    expect(shown).toEqual(['0.5']);
  });

  it('the address says how shapes are drawn while they move, and nonsense in it changes nothing', () => {
    expect(['', '?moving=preview', '?a=b&moving=exact', '?moving=fast', '?moving'].map(readMoving)).toEqual([
      'measured',
      'preview',
      'exact',
      'measured',
      'measured',
    ]);
  });

  it('large shapes are previews, the newest one at a time', async () => {
    const { loop, shown, ready, reply, pass, wanted, balance } = setUp(slow);
    await ready();
    loop.follow(0.1);
    await pass();
    for (const t of [0.2, 0.3, 0.4]) loop.follow(t);
    expect(wanted()).toEqual(['preview 0.1']);
    await reply();
    expect(wanted()).toEqual(['preview 0.4']);
    await reply();
    expect(shown).toEqual(['preview 0.1', 'preview 0.4']);
    expect(loop.shown).toMatchObject({ t: 0.4, preview: true });
    expect(loop.busy).toBe(true);
    expect(balance()).toBe(0);
  });

  it('the exact shape is eased in when no newer moment has come for a while', async () => {
    const { loop, shown, ready, reply, pass, wanted, draw } = setUp(slow);
    await ready();
    loop.follow(0.4);
    const idle = vi.fn();
    void loop.idle().then(idle);
    await pass();
    await reply();
    await pass(70);
    expect(wanted()).toEqual([]);
    await pass(20);
    expect(wanted()).toEqual(['0.4']);
    await reply();
    expect(shown).toEqual(['preview 0.4', '0.4 eased']);
    expect(idle).not.toHaveBeenCalled();
    await draw();
    expect(idle).toHaveBeenCalled();
    expect(loop.busy).toBe(false);
    await pass(1000);
    expect(wanted()).toEqual([]);
  });

  it('on a slow screen not before there was a chance to hear of a newer moment', async () => {
    const { loop, screen, ready, reply, pass, wanted, draw } = setUp(slow);
    await ready();
    screen.slow = true;
    loop.follow(0.4);
    await pass();
    await reply();
    await pass(50);
    await draw();
    await pass(50);
    expect(wanted()).toEqual([]);
    await pass(40);
    expect(wanted()).toEqual(['0.4']);
  });

  it('and at once when the pointer is lifted', async () => {
    const { loop, ready, reply, pass, wanted } = setUp(slow);
    await ready();
    loop.follow(0.4);
    await pass();
    await reply();
    loop.settle();
    await pass();
    expect(wanted()).toEqual(['0.4']);
  });

  it('a request is answered exactly, in the middle of a drag too', async () => {
    const { loop, shown, ready, reply, pass, wanted } = setUp(slow);
    await ready();
    loop.follow(0.4);
    await pass();
    const done = vi.fn();
    void loop.request(0.6).then(done);
    await reply();
    expect(done).not.toHaveBeenCalled();
    expect(wanted()).toEqual(['0.6']);
    await reply();
    expect(done).toHaveBeenCalled();
    // Another moment is no reason to ease.
    expect(shown).toEqual(['preview 0.4', '0.6']);
  });

  it('a drag that goes on while the exact shape is computed or eased is followed at once', async () => {
    const { loop, shown, ready, reply, pass, wanted, draw, balance } = setUp(slow);
    await ready();
    loop.follow(0.4);
    await pass();
    await reply();
    await pass(90);
    loop.follow(0.5);
    await reply();
    expect(shown).toEqual(['preview 0.4']);
    expect(wanted()).toEqual(['preview 0.5']);
    await reply();
    await pass(90);
    await reply();
    expect(shown.at(-1)).toBe('0.5 eased');
    loop.follow(0.6);
    await pass();
    expect(wanted()).toEqual(['preview 0.6']);
    await reply();
    expect(shown.at(-1)).toBe('preview 0.6');
    loop.settle();
    await pass();
    await reply();
    await draw();
    expect(loop.busy).toBe(false);
    expect(balance()).toBe(0);
  });

  it('all sequences are previews together', async () => {
    const { loop, shown, ready, reply, pass, wanted } = setUp({ ...slow, count: 2 });
    await ready();
    loop.follow(0.4);
    await pass();
    expect(wanted()).toEqual(['preview 0.4', 'preview 0.4']);
    await reply();
    expect(shown).toEqual([]);
    await reply();
    expect(shown).toEqual(['preview 0.4']);
  });

  it('blends of vertices have no cheaper shape', async () => {
    const { loop, learn, pass, wanted } = setUp({ ...slow, method: 'linear' });
    await learn();
    loop.follow(0.4);
    await pass();
    expect(wanted()).toEqual(['0.4']);
  });

  it('a cheap shape that is hardly cheaper is made before it is needed, and then left', async () => {
    const { loop, shown, learn, reply, pass, wanted, balance } = setUp({ exactMs: 50, cheapMs: 45 });
    await learn();
    await pass(400);
    expect(wanted()).toEqual(['preview 0.92']);
    await reply();
    await reply();
    expect(wanted()).toEqual([]);
    expect(shown).toEqual([]);
    loop.follow(0.4);
    await pass();
    expect(wanted()).toEqual(['0.4']);
    await reply();
    expect(balance()).toBe(0);
  });

  it('one slow frame does not make a large shape: the first of a sequence is always slow', async () => {
    const { loop, reply, pass, wanted } = setUp(slow);
    void loop.request(0.3);
    await pass();
    await reply();
    loop.follow(0.4);
    await pass();
    expect(wanted()).toEqual(['0.4']);
    await reply();
    loop.follow(0.5);
    await pass();
    await reply();
    await pass(500);
    expect(wanted()).toEqual(['preview 0.5']);
  });

  it('other sequences are measured anew', async () => {
    const { loop, ready, pass, wanted, exchange } = setUp(slow);
    await ready();
    exchange();
    loop.follow(0.4);
    await pass();
    expect(wanted()).toEqual(['0.4']);
  });
});

describe('a cheap shape that is not close', () => {
  const slow = { exactMs: 90, cheapMs: 25 };
  /** Close up to the second key. */
  const off = (t: number): PreviewError => ({ mean: 0.0005, largest: t > 0.5 && t <= 1 ? 0.006 : 0.004 });

  it('is not drawn where it was measured to be off', async () => {
    const { loop, ready, reply, pass, wanted } = setUp({ ...slow, off });
    await ready();
    for (const [t, words] of [
      [0.3, 'preview 0.3'],
      [0.7, '0.7'],
      [1.2, 'preview 1.2'],
    ] as const) {
      loop.follow(t);
      await pass();
      expect(wanted()).toEqual([words]);
      await reply();
      loop.settle();
      await pass();
      while (wanted().length > 0) await reply();
    }
  });

  it('is not drawn before that is known, and not measured while anything is asked for', async () => {
    const { loop, measured, learn, reply, pass, wanted, refit } = setUp(slow);
    await learn();
    await pass(400);
    await reply();
    loop.follow(0.3);
    await pass();
    await reply();
    expect(measured).toEqual([]);
    expect(wanted()).toEqual(['0.3']);
    await reply();
    await pass(400);
    expect(measured.slice(0, 3)).toEqual([0.25, 0.125, 0.375]);
    loop.follow(0.3);
    await pass();
    expect(wanted()).toEqual(['preview 0.3']);
    await reply();
    // Another motion of the same sequence.
    refit();
    loop.follow(0.2);
    await pass();
    expect(wanted()).toEqual(['0.2']);
  });

  it('decides for all sequences', async () => {
    let calls = 0;
    const { loop, ready, pass, wanted } = setUp({
      ...slow,
      count: 2,
      off: () => ({ mean: 0, largest: calls++ % 2 === 0 ? 0 : 1 }),
    });
    await ready();
    loop.follow(0.3);
    await pass();
    expect(wanted()).toEqual(['0.3', '0.3']);
  });

  it('is drawn where the address asks for it, and nothing is measured then', async () => {
    const { loop, measured, ready, pass, wanted } = setUp({ ...slow, moving: 'preview', off });
    await ready();
    loop.follow(0.7);
    await pass();
    expect(wanted()).toEqual(['preview 0.7']);
    expect(measured).toEqual([]);
  });

  it('of a small shape is drawn where the address asks for what is close', async () => {
    const { loop, ready, reply, pass, wanted } = setUp({ moving: 'close', off });
    await ready();
    loop.follow(0.7);
    await pass();
    expect(wanted()).toEqual(['0.7']);
    await reply();
    loop.follow(0.3);
    await pass();
    expect(wanted()).toEqual(['preview 0.3']);
  });

  it('is found out while the motion plays, which never rests', async () => {
    const { loop, open, measured, ready, refit, reply, pass, wanted } = setUp({ ...slow, off });
    await ready();
    refit();
    measured.length = 0;
    const time = { tick: 0, timeOf: (tick: number) => 0.3 + tick / 1000, tickSeconds: () => 1 / 60 };
    loop.play(time);
    await pass();
    expect(wanted()[0]).toBe('0.3');
    expect(measured).toEqual([0.25, 0.125, 0.375]);
    while (open.length > 0) await reply();
    time.tick = 20;
    loop.advance();
    await pass();
    expect(wanted()[0]).toMatch(/^preview /);
    loop.pause();
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
      // With the drawing half a second goes by from round to round.
      time.tick += 30;
      await pass(500 - drawingMs);
    }
    // What is asked for is not held up.
    void loop.request(0.7);
    await pass();
    while (wanted().length > 0) await reply();
    expect(shown.at(-1)).toBe('0.7');
    loop.pause();
    await draw();
  });

  it('a scrub takes back what was asked for ahead', async () => {
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

  it('large shapes are previews, and exact when it pauses', async () => {
    const { loop, shown, ready, reply, pass, wanted } = setUp({ exactMs: 90, cheapMs: 25 });
    await ready();
    const time = clock();
    loop.play(time);
    await pass();
    expect(wanted()[0]).toBe('preview 0');
    await reply();
    loop.advance();
    await pass();
    expect(shown).toEqual(['preview 0']);
    loop.pause();
    loop.follow(0.05);
    await pass();
    await reply();
    await pass(90);
    await reply();
    expect(shown).toEqual(['preview 0', 'preview 0.05', '0.05 eased']);
  });

  it('goes on after a failure', async () => {
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

  it('what was computed for another motion is not shown', async () => {
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

  it('nor what sequences gave that were exchanged since', async () => {
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

  it('what is asked for meanwhile is shown exactly, and what plays goes on from there', async () => {
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
