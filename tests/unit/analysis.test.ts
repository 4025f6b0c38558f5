import { describe, expect, it, vi } from 'vitest';
import { AnalysisCache } from '../../web/app/analysis/analysis-cache.ts';
import { analysisInput, relativeToFirstKey } from '../../web/app/analysis/analysis.ts';
import { computeShapePlanes, maxSpeeds } from '../../web/app/analysis/shape-plane.ts';
import type { CallOptions } from '../../web/engine/api/api.ts';
import { untilAborted } from '../../web/engine/api/errors.ts';
import type { RunningMotion } from '../../web/playback/frame-set.ts';
import type { Method } from '../../web/engine/api/types.ts';
import { docOfKeys, keyRef } from './documents.ts';

const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));

/** A sequence of constant measures that counts requests. */
function running(method: Method, asked: string[], ghost = 0): RunningMotion {
  const sequence = {
    options: { method, keepLengths: 0 },
    range: [0, 1] as const,
    measures: async (times: number[], call?: CallOptions) => {
      asked.push(method);
      call?.onProgress?.({ stage: 'evaluating', fraction: 0.5 });
      return { volume: times.map(() => 2), area: times.map(() => 3) };
    },
    bendingEnergy: async (times: number[]) => times.map(() => 4),
    shapePlane: async (times: number[]) => ({
      keys: [0, 0, 6, 3],
      tangents: [3, 9],
      curve: times.flatMap((t) => [t, 0]),
      explained: 1,
    }),
  };
  return { method, ghost, sequence } as unknown as RunningMotion;
}

function setUp(...methods: Method[]) {
  const asked: string[] = [];
  const heard: string[] = [];
  const working: (number | null)[] = [];
  const errors: unknown[] = [];
  let shape = {};
  const sequences = methods.map((method) => running(method, asked));
  const cache = new AnalysisCache(
    () => analysisInput(sequences, doc, [0, 1], 1),
    (error) => errors.push(error),
    () => shape,
  );
  cache.observe({
    onChange: (isOther) => heard.push(isOther ? 'other shape' : 'change'),
    onStale: () => heard.push('stale'),
    onWorking: (fraction) => working.push(fraction),
    onFresh: () => heard.push('fresh'),
  });
  const openOther = (): void => {
    shape = {};
    cache.invalidate();
  };
  heard.length = 0;
  return { cache, asked, heard, working, errors, sequences, openOther };
}

describe('the analysis', () => {
  it('has the bending energy of every method and the plane of motions in LRI space', async () => {
    const { cache } = setUp('lri', 'linear');
    const { motions, times } = (await cache.get())!;
    expect(motions.map(({ bending }) => bending.length)).toEqual([times.length, times.length]);
    expect(motions.map(({ plane }) => plane !== null)).toEqual([true, false]);
  });

  it('distinguishes motions of another shape from changes of the same shape', async () => {
    const { cache, heard, openOther } = setUp('lri');
    await cache.get(); // of a shape that was just opened
    heard.length = 0;
    cache.invalidate();
    openOther();
    cache.invalidate();
    expect(heard.filter((one) => one !== 'stale')).toEqual(['change', 'other shape', 'change']);
  });

  it('is computed once for all callers, and again when the motions have changed', async () => {
    const { cache, asked, heard } = setUp('lri');
    const [one, other] = await Promise.all([cache.get(), cache.get()]);
    expect(one).toBe(other);
    expect([asked.length, cache.stale]).toEqual([1, false]);
    cache.invalidate();
    expect(heard).toEqual(['fresh', 'change', 'stale']);
    expect(await cache.get()).not.toBe(one);
    expect(asked).toHaveLength(2);
  });

  it('is passed at once to later observers', async () => {
    const { cache, heard } = setUp('lri');
    const observe = (): void =>
      cache.observe({
        onChange: () => heard.push('change'),
        onStale: () => heard.push('stale'),
        onWorking: () => undefined,
        onFresh: () => heard.push('fresh'),
      });
    observe();
    expect(heard).toEqual(['change']);
    await cache.get();
    heard.length = 0;
    observe();
    expect(heard).toEqual(['fresh']);
  });

  it('is not current if the motions changed meanwhile, and its end is reported', async () => {
    const { cache, heard } = setUp('lri');
    const first = cache.refresh();
    cache.invalidate();
    await first;
    expect(heard).toEqual(['change', 'stale']);
    expect(cache.stale).toBe(true);
  });

  it('reports its progress over all motions, and its end', async () => {
    const { cache, working } = setUp('lri', 'linear');
    await cache.get();
    expect(working).toEqual([0, 0.25, 0.5, null]);
  });

  it('is given up when the motions change, without an error', async () => {
    const { cache, errors, sequences } = setUp('lri');
    const begun = vi.fn();
    Object.assign(sequences[0]!.sequence, {
      measures: (_: number[], { signal }: CallOptions) => untilAborted(signal, new Promise<never>(begun)),
    });
    const first = cache.refresh();
    await vi.waitFor(() => expect(begun).toHaveBeenCalled());
    cache.invalidate();
    expect(await first).toBeNull();
    expect(errors).toEqual([]);
  });

  it('is null if nothing is open, and after a reported failure', async () => {
    expect(await setUp().cache.get()).toBeNull();
    const { cache, errors, sequences } = setUp('lri');
    Object.assign(sequences[0]!.sequence, { measures: () => Promise.reject(new Error('worker ended')) });
    expect(await cache.get()).toBeNull();
    expect(errors).toHaveLength(1);
  });

  it('omits the motion without a ghost mesh next to one with it', () => {
    const both = [running('lri', [], 500), running('lri', []), running('geodesic', [], 500)];
    expect(analysisInput(both, doc, [0, 1], 1).sequences).toEqual([both[0], both[2]]);
  });

  it('is relative to the first key, if that has a value', () => {
    const common = { times: [-1, 0, 1], keyTimes: [0, 1], range: [0, 1] as const, motions: [] };
    expect(relativeToFirstKey([1, 2, 3], common)).toEqual([50, 100, 150]);
    expect(relativeToFirstKey([1, 0, 3], common)).toEqual([NaN, NaN, NaN]);
  });
});

describe('shape planes', () => {
  it('have no motion with fitted shapes, which the published one replaces', async () => {
    const kept = running('lri', []);
    const fitted = { ...kept, sequence: { ...kept.sequence, options: { method: 'lri', keepLengths: 1 } } };
    const published = { ...running('lri', []), plain: true as const };
    const input = { keyTimes: [0, 1], range: [0, 1] as const, towards: null };
    const shown = async (...sequences: unknown[]): Promise<number> =>
      (await computeShapePlanes({ ...input, sequences: sequences as RunningMotion[] })).planes.length;
    expect(await shown(fitted)).toBe(0);
    expect(await shown(fitted, published)).toBe(1);
    // Beside a motion that holds parts, the published one has the same curve.
    expect(await shown(kept, published)).toBe(1);
  });

  it('are those of LRI space, with handles a third of the way to the shape that gives the direction', async () => {
    const sequences = [running('lri', []), running('linear', [])];
    const input = {
      sequences,
      keyTimes: [0, 1],
      range: [0, 1] as const,
      towards: { start: 'neighbour', end: 'shape' },
    } as const;
    const { planes, tangents } = await computeShapePlanes(input);
    expect(planes.map(({ method }) => method)).toEqual(['lri']);
    expect(tangents).toEqual({
      start: { handle: [2, 1], shape: null },
      end: { handle: [-1, 2], shape: [3, 9] },
    });
    const both = { start: 'shape', end: 'shape' } as const;
    const early = (await computeShapePlanes({ ...input, towards: both })).tangents!;
    expect([early.start.shape, early.end.shape]).toEqual([[3, 9], null]);
    expect(early.end.handle.every(Number.isFinite)).toBe(true);
    expect((await computeShapePlanes({ ...input, towards: null })).tangents).toBeNull();
  });

  it('determine the offered speeds from the distances of the tangent poses to their keys', async () => {
    const plane = { ...(await running('lri', []).sequence.shapePlane([])), tangents: [1.2, 0.6, 3, 9] };
    const towards = { start: 'shape', end: 'shape' } as const;
    expect(maxSpeeds(plane, towards)).toEqual({ start: 20, end: 4 });
    expect(maxSpeeds(plane, { start: 'neighbour', end: 'shape' })).toEqual({ start: 4, end: 5 });
    expect(maxSpeeds({ ...plane, tangents: [] }, towards)).toEqual({ start: 4, end: 4 });
    expect(maxSpeeds(plane, null)).toEqual({ start: 4, end: 4 });
  });
});
