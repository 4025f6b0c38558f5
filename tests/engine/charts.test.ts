/** The analysis panel's plots for real keys with large rotations: no curve jumps, and slivers determine no patch. */
import { describe, expect, it } from 'vitest';
import type { Keys, Sequence } from '../../web/engine/api/api.ts';
import type { ImportOptions, Method } from '../../web/engine/api/types.ts';
import { patchCurves } from '../../web/app/analysis/patch-curves.ts';
import { dataFile, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

const STEPS = 300;
const PARTS = 16;

type Row = readonly number[];

const apart = (a: Row, b: Row): number => Math.hypot(...a.map((value, i) => value - b[i]!));

/** `count` times between two times, both included. */
const between = (from: number, to: number, count: number): number[] =>
  Array.from({ length: count + 1 }, (_, i) => from + ((to - from) * i) / count);

/**
 * The remaining share of a curve's largest step after subdivision: small for a continuous curve, all of it for a jump.
 * 0 without movement.
 */
async function jumpLeft(at: (times: number[]) => Promise<Row[]>, from: number, to: number): Promise<number> {
  const times = between(from, to, STEPS);
  const rows = await at(times);
  expect(rows).toHaveLength(times.length);
  for (const row of rows) for (const value of row) expect(Number.isFinite(value)).toBe(true);
  const steps = rows.slice(1).map((row, i) => apart(row, rows[i]!));
  const largest = Math.max(...steps);
  if (largest < 1e-6) return 0;
  const worst = steps.indexOf(largest);
  const fine = await at(between(times[worst]!, times[worst + 1]!, PARTS));
  return Math.max(...fine.slice(1).map((row, i) => apart(row, fine[i]!))) / largest;
}

const rowsOf = (numbers: readonly number[], width: number): Row[] =>
  Array.from({ length: numbers.length / width }, (_, i) => numbers.slice(width * i, width * (i + 1)));

const lion = Array.from({ length: 9 }, (_, i) => `turns/lion/${i + 1}.obj`);
const cats = [2, 5, 8].map((pose) => `turns/cat/cat${pose}.off`);
const lowpoly = ['01', '13', '25'].map((pose) => `obj/lowpoly-cat/cat_0000${pose}.obj`);

interface Opened {
  keys: Keys;
  sequence: Sequence;
  from: number;
  to: number;
  reference: number;
}

async function opened(names: string[], options: ImportOptions = {}, method: Method = 'lri'): Promise<Opened> {
  const keys = await engine.importKeyframes(names.map(dataFile), options);
  const sequence = await engine.createSequence(keys, { method });
  const [first, last] = sequence.range;
  const margin = 0.4 * (last - first);
  return { keys, sequence, from: first - margin, to: last + margin, reference: first };
}

describe.skipIf(!hasData)('charts of real keys with large turns', () => {
  it.each([
    ['lion, nine keys @all', lion, {}],
    ['cat', cats, {}],
    ['low-poly cat @all', lowpoly, {}],
    ['soldier @all', ['skin/Soldier.glb'], { animation: 1, sample: 6 }],
  ] as const)('%s: faces, patches and the plane go on without a jump', async (_, names, options) => {
    const { sequence, from, to, reference } = await opened([...names], options);
    const patchOf = await sequence.patches();
    const patches = [...new Set(patchOf)].filter((patch) => patch >= 0);
    expect(patches.length).toBeGreaterThan(4);
    const plane = async (times: number[]): Promise<Row[]> => rowsOf((await sequence.shapePlane(times)).curve, 2);
    expect(await jumpLeft(plane, from, to), 'plane').toBeLessThan(4 / PARTS);
    for (const patch of [0, 0.3, 0.6, 0.9].map((share) => patches[Math.floor(share * patches.length)]!)) {
      const turns = async (times: number[]): Promise<Row[]> => {
        // The reference is included, because rotations are counted from it.
        const all = [reference, ...times];
        const curve = await sequence.patchCurve(patch, all);
        const { neighbours, stretch } = patchCurves(curve, curve.numbers, 0);
        return times.map((_, i) => [stretch[i + 1]!, ...neighbours.flatMap(({ turn }) => turn[i + 1]!)]);
      };
      expect(await jumpLeft(turns, from, to), `patch ${patch + 1}`).toBeLessThan(4 / PARTS);
      const face = patchOf.indexOf(patch);
      const own = async (times: number[]): Promise<Row[]> => rowsOf((await sequence.faceCurve(face, times)).numbers, 6);
      expect(await jumpLeft(own, from, to), `face ${face}`).toBeLessThan(4 / PARTS);
    }
  });

  it.each(['lri', 'geodesic', 'linear', 'cubic-vertex', 'rotation-strain', 'rimd'] as const)(
    'lion: the bending of %s is known everywhere',
    async (method) => {
      const { sequence, from, to } = await opened(lion, {}, method);
      const energy = await sequence.bendingEnergy(between(from, to, STEPS));
      for (const value of energy) expect(value).toBeGreaterThanOrEqual(0);
      expect(Math.max(...energy)).toBeGreaterThan(1);
    },
  );
});
