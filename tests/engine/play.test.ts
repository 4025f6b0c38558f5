/** The playground's splines match the core's for coordinates of real keys. */
import { beforeAll, describe, expect, it } from 'vitest';
import type { Keys, Sequence } from '../../web/engine/api/api.ts';
import type { SequenceOptions } from '../../web/engine/api/types.ts';
import { valueAt } from '../../web/play/splines/curve.ts';
import { fitCurve } from '../../web/play/splines/fit.ts';
import type { CurveKind, FitOptions } from '../../web/play/splines/fit.ts';
import { testEngine } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { bar, bent } from './support/shapes.ts';

const engine = testEngine();
const times = [-0.2, 0.35, 0.5, 1.4, 2];
const tension = [0, 0.3, -0.5, 1, 0.2];
const bias = [0.4, -0.7, 0, 0.25, -1];
let keys: Keys;
let sequence: Sequence;

beforeAll(async () => {
  const mesh = bar();
  // Irregular angles, so the shapes are not collinear.
  const poses = [0, 60, -40, 90, 20].map((degrees, i) => bent(mesh, degrees).map((x) => x * (1 + 0.2 * ((i * 3) % 5))));
  keys = await engine.importKeyframes(poseFiles(mesh, poses), { keyTimes: times });
  sequence = await engine.createSequence(keys);
});

/** Times between the keys, beyond both ends, and at the keys. */
const asked = [...Array.from({ length: 120 }, (_, i) => -0.8 + i * 0.031), ...times];

const cases: [string, Partial<SequenceOptions>, CurveKind, Partial<FitOptions>][] = [
  ['natural', { boundary: 'natural' }, 'natural', {}],
  ['Hermite', { boundary: 'hermite', startSpeed: 0.3, endSpeed: -1.5 }, 'hermite', { speeds: [0.3, -1.5] }],
  ['periodic', { boundary: 'periodic' }, 'periodic', {}],
  ['straight', { method: 'geodesic' }, 'linear', {}],
  ...(['natural', 'hermite', 'periodic'] as const).map((ends): (typeof cases)[number] => [
    `${ends} with tension and bias`,
    { boundary: ends, startSpeed: 0.3, endSpeed: 2, tension, bias },
    'shaped',
    { ends, speeds: [0.3, 2], shaping: times.map((_, j) => ({ tension: tension[j]!, bias: bias[j]! })) },
  ]),
];

describe('the playground agrees with the core', () => {
  it.each(cases)('%s, to 1e-12', async (_, motion, kind, options) => {
    const plain = { method: 'lri', boundary: 'natural', startSpeed: 1, endSpeed: 1, tension: [], bias: [] } as const;
    await sequence.update({ ...plain, tension: [], bias: [], ...motion });
    const plane = await sequence.shapePlane(asked);
    const one: FitOptions = { speeds: [1, 1], ends: 'natural', shaping: [], ...options };
    for (const axis of [0, 1]) {
      const values = plane.keys.filter((__, i) => i % 2 === axis);
      const spread = Math.max(...values) - Math.min(...values);
      expect(spread).toBeGreaterThan(0.01);
      const curve = fitCurve(kind, { times, values }, one);
      const off = asked.map((t, i) => Math.abs(valueAt(curve, t) - plane.curve[2 * i + axis]!));
      expect(Math.max(...off) / spread).toBeLessThan(1e-12);
    }
  });
});
