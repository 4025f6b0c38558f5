import { describe, expect, it } from 'vitest';
import { SequenceSet } from '../../web/app/session/sequence-set.ts';
import type { SequencePlan } from '../../web/app/session/sequence-plan.ts';
import { sequencePlan } from '../../web/app/session/sequence-plan.ts';
import { motionFor } from '../../web/engine/api/method-options.ts';
import type { Engine, Keys, Motion, MotionChange, Shape } from '../../web/engine/api/api.ts';
import { EngineError } from '../../web/engine/api/errors.ts';
import type { EncodingOptions, Method } from '../../web/engine/api/types.ts';
import { retimeKey, setEncoding, setMotion } from '../../web/model/edits.ts';
import { DEFAULT_VIEW } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));

/** An engine that records requests and encodes on command. */
function fakeEngine() {
  const log: string[] = [];
  const builds: { resolve(): void; reject(error: unknown): void }[] = [];
  let alive = 0;
  const disposable = (): { dispose(): void } => {
    alive += 1;
    let disposed = false;
    return {
      dispose: () => {
        if (!disposed) alive -= 1;
        disposed = true;
      },
    };
  };
  const makeShape = (): Shape =>
    ({
      ...disposable(),
      rename: () => undefined,
      motion: async ({ method, boundary, keyTimes }: MotionChange) => {
        if (keyTimes?.includes(99)) throw new EngineError('invalid-option', 'Refused.');
        log.push(`move ${method} ${boundary} ${keyTimes?.join()}`);
        return disposable() as unknown as Motion;
      },
    }) as unknown as Shape;
  const engine = {
    encode: (_: Keys, { stretch, ghostFaces }: EncodingOptions, { signal }: { signal: AbortSignal }) => {
      log.push(`encode ${stretch}${ghostFaces > 0 ? ` ${ghostFaces}` : ''}`);
      return new Promise<Shape>((resolve, reject) => {
        builds.push({ resolve: () => resolve(makeShape()), reject });
        signal.addEventListener('abort', () => reject(new EngineError('cancelled', 'Cancelled.')));
      });
    },
  } as unknown as Engine;
  const pool = {
    keys: { arrange: () => ({ dispose: () => undefined }), positions: () => new Float32Array(3) } as unknown as Keys,
  };
  return { engine, pool, log, builds, alive: () => alive, encodings: () => log.filter((line) => /^encode/.test(line)) };
}

function setUp() {
  const fake = fakeEngine();
  const ready: SequencePlan[] = [];
  const refused: string[] = [];
  const set = new SequenceSet(fake.engine, fake.pool, {
    onProgress: () => undefined,
    onReady: (plan) => ready.push(plan),
    onRefused: (error) => refused.push((error as Error).message),
  });
  const tick = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));
  const build = async (): Promise<void> => {
    await tick();
    fake.builds.shift()!.resolve();
    await tick();
  };
  return { ...fake, set, ready, refused, tick, build };
}

const differing = { ...DEFAULT_VIEW, ghostDifference: true };

describe('sequence sets', () => {
  it('are not encoded again for other times and boundaries', async () => {
    const { set, log, build, ready } = setUp();
    set.want(sequencePlan(doc));
    await build();
    set.want(sequencePlan(setMotion(doc, { boundary: 'periodic' })));
    await set.idle();
    set.want(sequencePlan(retimeKey(doc, 1, 3)));
    await set.idle();
    expect(log).toEqual(['encode linear', 'move lri natural 0,1', 'move lri periodic 0,1', 'move lri natural 0,3']);
    expect(ready).toHaveLength(3);
  });

  it('are encoded again for another encoding, and dispose of the old shape afterwards', async () => {
    const { set, encodings, build, alive, tick } = setUp();
    set.want(sequencePlan(doc));
    await build();
    const before = set.all;
    set.want(sequencePlan(setEncoding(doc, { stretch: 'log' })));
    await tick();
    expect(set.all).toBe(before);
    expect(alive()).toBe(2);
    await build();
    await set.idle();
    expect(encodings()).toEqual(['encode linear', 'encode log']);
    expect(set.all).not.toBe(before);
    expect(alive()).toBe(2);
  });

  it('use the same shape for a compared method, and keep the first motion', async () => {
    const { set, log, build, alive } = setUp();
    set.want(sequencePlan(doc));
    await build();
    const first = set.all[0];
    set.want(sequencePlan(doc, { ...DEFAULT_VIEW, compare: ['linear'] }));
    await set.idle();
    expect(set.all[0]!.sequence).toBe(first!.sequence);
    expect(set.all.map(({ method }) => method)).toEqual(['lri', 'linear']);
    expect(log).toEqual(['encode linear', 'move lri natural 0,1', 'move linear natural 0,1']);
    set.want(sequencePlan(doc));
    await set.idle();
    expect(alive()).toBe(2);
  });

  it('add the motion without a ghost mesh, and keep the other motions', async () => {
    const { set, encodings, build, alive } = setUp();
    const led = setEncoding(doc, { ghostFaces: 2000 });
    set.want(sequencePlan(doc));
    await build();
    const [full] = set.all;
    set.want(sequencePlan(led, differing));
    await build();
    await set.idle();
    expect(set.all.map(({ method, ghost }) => [method, ghost])).toEqual([
      ['lri', 2000],
      ['lri', 0],
    ]);
    expect(set.all[1]!.sequence).toBe(full!.sequence);
    set.want(sequencePlan(setEncoding(led, { transfer: 'paper' }), { ...differing, compare: ['geodesic'] }));
    await build();
    await set.idle();
    expect(set.all.map(({ method, ghost }) => [method, ghost])).toEqual([
      ['lri', 2000],
      ['lri', 0],
      ['geodesic', 2000],
    ]);
    expect(set.all[1]!.sequence).toBe(full!.sequence);
    set.want(sequencePlan(doc, differing));
    await set.idle();
    expect(set.all.map(({ sequence }) => sequence)).toEqual([full!.sequence]);
    expect(alive()).toBe(2);
    // The geodesic is another motion of the shape with the ghost.
    expect(encodings()).toEqual(['encode linear', 'encode linear 2000', 'encode linear 2000']);
  });

  it('add ghost meshes of other sizes, and the full solve last', () => {
    const led = setEncoding(doc, { ghostFaces: 300 });
    const { variants } = sequencePlan(led, { ...DEFAULT_VIEW, ghostSizes: true, compare: ['linear'] });
    expect(variants.map(({ method, ghost }) => [method, ghost])).toEqual([
      ['lri', 300],
      ['lri', 600],
      ['lri', 1200],
      ['lri', 0],
      ['linear', 300],
    ]);
    expect(sequencePlan(doc, { ...DEFAULT_VIEW, ghostSizes: true }).variants).toHaveLength(1);
  });

  it('have no difference from a ghost mesh for vertex blends', () => {
    const led = setEncoding(setMotion(doc, { method: 'linear' }), { ghostFaces: 2000 });
    expect(sequencePlan(led, { ...differing, compare: ['lri'] }).variants.map(({ method }) => method)).toEqual([
      'linear',
      'lri',
    ]);
  });

  it('use only supported options of a method', () => {
    const pins = [{ vertex: 3, radius: 0.1 }];
    const plan = sequencePlan(setMotion(doc, { hold: 'on', pins, boundary: 'hermite' }));
    plan.motion.turns = [{ key: 2, turns: 1 }];
    const asked = (method: Method): unknown[] => {
      const { hold, pins: held, turns, boundary } = motionFor(plan.motion, { method });
      return [hold, held.length, turns.length, boundary];
    };
    expect(asked('lri')).toEqual(['on', 1, 1, 'hermite']);
    expect(asked('geodesic')).toEqual(['off', 0, 1, 'natural']);
    expect(asked('rotation-strain')).toEqual(['off', 0, 0, 'hermite']);
    plan.motion.tension = [0.5, 0.5, 0.5];
    expect(asked('lengths')).toEqual(['off', 0, 0, 'natural']);
    expect(motionFor(plan.motion, { method: 'lengths' }).tension).toEqual([]);
    // This method needs the stretches of the shape's own faces, which the paper's transfer lacks.
    for (const [transfer, ghost] of [
      ['paper', 0],
      ['exact', 2000],
    ] as const) {
      const led = setEncoding(doc, { ghostFaces: 2000, transfer });
      const { variants } = sequencePlan(led, { ...DEFAULT_VIEW, compare: ['rotation-strain'] });
      expect(variants.map((variant) => variant.ghost)).toEqual([2000, ghost]);
    }
  });

  it('cancel a build that is no longer needed', async () => {
    const { set, encodings, build, refused, builds, tick, alive } = setUp();
    set.want(sequencePlan(doc));
    await tick();
    set.want(sequencePlan(setEncoding(doc, { stretch: 'log' })));
    await tick();
    expect(builds).toHaveLength(2);
    builds.shift();
    await build();
    await set.idle();
    expect(encodings()).toEqual(['encode linear', 'encode log']);
    expect(refused).toEqual([]);
    expect(alive()).toBe(2);
  });

  it('apply key times that changed during a build afterwards', async () => {
    const { set, log, build } = setUp();
    set.want(sequencePlan(doc));
    set.want(sequencePlan(retimeKey(doc, 1, 2)));
    await build();
    await set.idle();
    expect(log[0]).toBe('encode linear');
    expect(set.plan?.times).toEqual([0, 2]);
  });

  it('keep the earlier motions if a build is cancelled or refused', async () => {
    const { set, build, refused, builds, tick } = setUp();
    set.want(sequencePlan(doc));
    await build();
    const before = set.all;
    const plan = set.plan;
    set.want(sequencePlan(setEncoding(doc, { patches: 9 })));
    await tick();
    set.cancel();
    await set.idle();
    expect(set.all).toBe(before);
    expect(refused).toEqual([]);
    set.want(sequencePlan(setEncoding(doc, { patches: 10 })));
    await tick();
    builds.at(-1)!.reject(new EngineError('out-of-memory', 'Too large.'));
    await set.idle();
    expect(refused).toEqual(['Too large.']);
    expect(set.all).toBe(before);
    expect(set.plan).toBe(plan);
  });

  it('report a refused motion and accept other requests afterwards', async () => {
    const { set, build, refused } = setUp();
    set.want(sequencePlan(doc));
    await build();
    set.want(sequencePlan(retimeKey(doc, 1, 99)));
    await set.idle();
    expect(refused).toEqual(['Refused.']);
    set.want(sequencePlan(retimeKey(doc, 1, 5)));
    await set.idle();
    expect(set.plan?.times).toEqual([0, 5]);
  });

  it('leave nothing behind', async () => {
    const { set, build, alive } = setUp();
    set.want(sequencePlan(doc, { ...DEFAULT_VIEW, compare: ['linear'] }));
    await build();
    await set.idle();
    expect(alive()).toBe(3);
    set.dispose();
    expect(alive()).toBe(0);
  });
});
