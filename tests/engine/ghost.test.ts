import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Keys, Sequence } from '../../web/engine/api/api.ts';
import { kgBetween, studyGhosts } from '../../web/study/ghost-study.ts';
import { KgError } from '../../web/engine/timing/kg-error.ts';
import type { InputFile, Progress, SequenceOptions } from '../../web/engine/api/types.ts';
import { bendKeys, bendSequence, failureOf, frameAt, testEngine } from './support/engines.ts';
import { bar, diagonal, largestDistance } from './support/shapes.ts';

const engine = testEngine();
const between = [0.05, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 0.95];

const pick = (positions: Float32Array, vertices: Int32Array): number[] =>
  [...vertices].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);

describe('a ghost mesh', () => {
  it('is described by arrays that are consistent with each other and with the keys', async () => {
    const { sequence, mesh, poses } = await bendSequence(engine, { ghostFaces: 80 });
    const ghost = (await sequence.ghost())!;
    const { ghostFaces, ghostVertices } = await sequence.stats();
    expect([ghost.faces.length, ghost.vertexOf.length]).toEqual([3 * ghostFaces, ghostVertices]);
    expect(ghostFaces).toBeGreaterThan(40);
    expect(ghostFaces).toBeLessThanOrEqual(80);
    expect(new Set(ghost.faces).size).toBe(ghostVertices);
    expect(Math.max(...ghost.faces)).toBe(ghostVertices - 1);
    expect([...ghost.vertexOf].map((v) => ghost.ghostVertexOf[v])).toEqual([...ghost.vertexOf.keys()]);
    expect(ghost.ghostVertexOf).toHaveLength(mesh.positions.length / 3);
    expect(ghost.ghostFaceOf).toHaveLength(mesh.indices.length / 3);
    for (const face of ghost.ghostFaceOf) expect(face >= 0 && face < ghostFaces).toBe(true);
    for (const [key, t] of [0, 0.5, 1].entries()) {
      expect(largestDistance(await sequence.ghostPositions(t), pick(poses[key]!, ghost.vertexOf))).toBeLessThan(
        1e-5 * diagonal(poses[key]!),
      );
    }
    sequence.dispose();
  });

  it('is used by every refit, but not by vertex blends', async () => {
    const { sequence, keys } = await bendSequence(engine, { ghostFaces: 80 });
    const full = await engine.createSequence(keys);
    const at = async (one: Sequence): Promise<Float32Array> => (await frameAt(one, 0.7)).positions;
    const before = await sequence.stats();
    for (const change of [{ boundary: 'hermite' }, { boundary: 'periodic' }, { method: 'geodesic' }] as const) {
      for (const one of [sequence, full]) await one.update(change);
      expect(await at(sequence)).not.toEqual(await at(full));
    }
    for (const one of [sequence, full]) await one.update({ method: 'linear', boundary: 'natural' });
    expect(await at(sequence)).toEqual(await at(full));
    // A recomputation would have taken a different time.
    const { encodeMs, factorMs } = await sequence.stats();
    expect([encodeMs, factorMs]).toEqual([before.encodeMs, before.factorMs]);
    for (const one of [sequence, full]) one.dispose();
  });

  it('can be cancelled within a second while it is made, and leaves the earlier motion unchanged', async () => {
    const { keys } = await bendKeys(engine, bar(30, 300));
    const served = await engine.createSequence(keys);
    const { positions } = await frameAt(served, 0.3);
    const abort = new AbortController();
    let asked = Infinity;
    const made = engine.createSequence(
      keys,
      { ghostFaces: 2000 },
      {
        signal: abort.signal,
        onProgress: ({ stage }) => {
          if (stage !== 'simplifying' || abort.signal.aborted) return;
          asked = performance.now();
          abort.abort();
        },
      },
    );
    expect((await failureOf(made)).code).toBe('cancelled');
    expect(performance.now() - asked).toBeLessThan(1000);
    expect((await frameAt(served, 0.3)).positions).toEqual(positions);
    served.dispose();
  });
});

describe('the KG error', () => {
  it('matches its definition', () => {
    const error = new KgError();
    error.add(Float32Array.of(0, 0, 0, 2, 0, 0), Float32Array.of(0, 0.5, 0, 2, 0, 0));
    expect(error.percent).toBeCloseTo((100 * 0.5) / Math.SQRT2, 10);
    error.add(Float32Array.of(5, 5, 5, 5, 5, 9), Float32Array.of(5, 5, 5, 5, 5, 9));
    expect(error.percent).toBeCloseTo((100 * 0.5) / Math.sqrt(10), 10);
  });

  it('is 0 of a motion against itself', async () => {
    const { sequence } = await bendSequence(engine);
    expect(await kgBetween(sequence, sequence, between)).toBe(0);
    sequence.dispose();
  });
});

describe('a study of ghosts', () => {
  it('has every size below that of the shape, with both transfers', async () => {
    const { keys } = await bendKeys(engine);
    const fractions: number[] = [];
    const study = await studyGhosts(
      engine,
      keys,
      {},
      { times: between, sizes: [60, 120, 500], onProgress: ({ fraction }) => fractions.push(fraction) },
    );
    expect(study.faces).toBe(336);
    expect(study.rows.map(({ wanted, transfer }) => [wanted, transfer])).toEqual([
      [60, 'exact'],
      [60, 'paper'],
      [120, 'exact'],
      [120, 'paper'],
    ]);
    for (const { wanted, faces, kg, ms } of study.rows) {
      expect(faces).toBeLessThanOrEqual(wanted);
      expect(kg).toBeGreaterThan(0);
      expect(kg).toBeLessThan(10);
      expect(ms).toBeGreaterThan(0);
    }
    expect(study.rows[2]!.kg).toBeLessThan(study.rows[3]!.kg);
    expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
    expect(fractions.at(-1)).toBe(1);
  });

  it('can be cancelled', async () => {
    const { keys } = await bendKeys(engine);
    const abort = new AbortController();
    const onProgress = ({ fraction }: Progress): void => {
      if (fraction > 0.4) abort.abort();
    };
    const work = studyGhosts(engine, keys, {}, { times: between, sizes: [60, 120], signal: abort.signal, onProgress });
    expect((await failureOf(work)).code).toBe('cancelled');
  });
});

/** KG error limits in percent for exact and paper transfer, and at the keys for exact transfer. */
async function check(keys: Keys, options: Partial<SequenceOptions>): Promise<void> {
  const { times } = keys.info;
  const at = between.map((share) => times[0]! + share * (times.at(-1)! - times[0]!));
  const full = await engine.createSequence(keys, options);
  for (const [transfer, limit] of [
    ['exact', 1],
    ['paper', 5],
  ] as const) {
    const sequence = await engine.createSequence(keys, { ...options, ghostFaces: 2000, transfer });
    expect(sequence.warnings.map(({ code }) => code)).not.toContain('ghost-off');
    expect(await kgBetween(full, sequence, at), transfer).toBeLessThanOrEqual(limit);
    for (const [key, t] of transfer === 'exact' ? times.entries() : []) {
      const pose = keys.positions(key);
      expect(largestDistance((await frameAt(sequence, t)).positions, pose)).toBeLessThan(1e-5 * diagonal(pose));
    }
    sequence.dispose();
  }
  full.dispose();
}

const samples = new URL('../../public/samples/', import.meta.url);
interface SampleEntry {
  id: string;
  files: string[];
  times: number[];
  boundary: SequenceOptions['boundary'];
}

describe('2,000 ghost faces', () => {
  const list = JSON.parse(readFileSync(new URL('samples.json', samples), 'utf8')) as SampleEntry[];

  it.each(list.map((sample) => [sample.id, sample] as const))(
    'keep close to the motion without them on the sample %s',
    async (_, { files, times, boundary }) => {
      const inputs = files.map((name): InputFile => ({ name, bytes: readFileSync(new URL(name, samples)) }));
      const keys = await engine.importKeyframes(inputs, { keyTimes: times });
      if (keys.info.report.faces > 2000) await check(keys, { boundary });
    },
  );
});
