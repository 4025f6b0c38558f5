import { describe, expect, it } from 'vitest';
import type { Lane } from '../../web/app/lanes.ts';
import { Pump } from '../../web/app/pump.ts';
import type { Frame } from '../../web/engine/types.ts';

function setUp(count = 1) {
  const open: { t: number; resolve(frame: Frame | null): void; reject(error: unknown): void }[] = [];
  const shown: number[] = [];
  const errors: unknown[] = [];
  let released = 0;
  let frames = 0;
  const frame = (t: number): Frame => {
    frames += 1;
    return { t, positions: new Float32Array(), normals: new Float32Array(), ms: 1, lostDefiniteness: 0, release: () => { released += 1; } };
  };
  const lane = (): Lane => ({
    method: 'lri',
    sequence: { evaluate: (t: number) => new Promise((resolve, reject) => open.push({ t, resolve, reject })) },
  } as unknown as Lane);
  let lanes: readonly Lane[] = Array.from({ length: count }, lane);
  const pump = new Pump({
    lanes: () => lanes, show: (t) => { shown.push(t); }, drawn: async () => undefined, onError: (error) => errors.push(error),
  });
  const tick = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));
  const answer = async (): Promise<void> => { const next = open.shift()!; next.resolve(frame(next.t)); await tick(); };
  return { pump, open, shown, errors, tick, answer, frame, balance: () => frames - released, exchange: () => { lanes = [lane()]; } };
}

describe('the pump', () => {
  it('asks for one moment at a time and skips those that were overtaken', async () => {
    const { pump, open, shown, answer, balance, tick } = setUp();
    const all = [0.1, 0.2, 0.3].map((t) => pump.request(t));
    await tick();
    expect(open.map(({ t }) => t)).toEqual([0.3]);
    const newer = pump.request(0.4);
    await answer();
    await Promise.all(all);
    expect(open.map(({ t }) => t)).toEqual([0.4]);
    await answer();
    await newer;
    expect(shown).toEqual([0.3, 0.4]);
    expect(balance()).toBe(0);
    expect(pump.busy).toBe(false);
  });

  it('shows all lanes together', async () => {
    const { pump, shown, answer, tick } = setUp(2);
    const done = pump.request(0.5);
    await tick();
    await answer();
    expect(shown).toEqual([]);
    await answer();
    await done;
    expect(shown).toEqual([0.5]);
  });

  it('asks the successor when the sequence is exchanged meanwhile', async () => {
    const { pump, open, shown, answer, exchange, balance, tick } = setUp();
    const done = pump.request(0.5);
    await tick();
    exchange();
    await answer();
    expect(shown).toEqual([]);
    expect(open.map(({ t }) => t)).toEqual([0.5]);
    await answer();
    await done;
    expect(shown).toEqual([0.5]);
    expect(balance()).toBe(0);
  });

  it('reports a failure once and goes on with the next moment', async () => {
    const { pump, open, shown, errors, answer, tick } = setUp();
    const failed = pump.request(0.5);
    await tick();
    open.shift()!.reject(new Error('worker ended'));
    await failed;
    await tick();
    expect(errors).toHaveLength(1);
    const next = pump.request(0.6);
    await tick();
    await answer();
    await next;
    expect(shown).toEqual([0.6]);
  });

  it('takes up what is asked for the moment that a frame is done', async () => {
    const { pump, shown, answer, tick } = setUp();
    const both = pump.request(0.1).then(() => pump.request(0.2));
    await tick();
    await answer();
    await answer();
    await both;
    expect(shown).toEqual([0.1, 0.2]);
    expect(pump.busy).toBe(false);
  });

  it('ends without lanes', async () => {
    const { pump } = setUp(0);
    await pump.request(0.5);
    expect(pump.busy).toBe(false);
  });
});
