/**
 * The playground's splines compared with independent formulas; tests/engine/play.test.ts compares them with the core.
 */
import { describe, expect, it } from 'vitest';
import { inInterval, totalBending, valueAt } from '../../../web/play/splines/curve.ts';
import type { Curve } from '../../../web/play/splines/curve.ts';
import { fitCurve, weightCurves } from '../../../web/play/splines/fit.ts';
import type { CurveKind, FitOptions } from '../../../web/play/splines/fit.ts';
import { curveThrough, minimiseBending, minSamples } from '../../../web/play/splines/minimise-bending.ts';
import { slopeSystem } from '../../../web/play/splines/slopes.ts';
import { solveDense, solveTridiagonal } from '../../../web/play/splines/solve.ts';

const times = [-1, 0.2, 0.5, 2, 4];
const values = [0.3, -1, 2, 0.7, 1.1];
const data = { times, values };
const none: FitOptions = { speeds: [1, 1], ends: 'natural', shaping: [] };
const smooth: CurveKind[] = ['natural', 'hermite', 'periodic'];
const all: CurveKind[] = [...smooth, 'linear', 'catmull-rom', 'shaped'];

/** Jumps of a derivative at each inner knot. */
const jumps = (curve: Curve, derivative: 1 | 2): number[] =>
  curve.times.slice(1, -1).map((t, i) => {
    const [before, after] = [inInterval(curve, i, t, derivative), inInterval(curve, i + 1, t, derivative)];
    return Math.abs(after - before);
  });

describe('the curves', () => {
  it.each(all)('%s: pass through every key', (kind) => {
    const curve = fitCurve(kind, data, none);
    times.forEach((t, j) => expect(valueAt(curve, t)).toBeCloseTo(values[j]!, 12));
  });

  it.each(smooth)('%s: slope and second derivative are continuous at the keys', (kind) => {
    const curve = fitCurve(kind, data, none);
    for (const derivative of [1, 2] as const)
      for (const jump of jumps(curve, derivative)) expect(jump).toBeLessThan(1e-11);
  });

  it('Catmull-Rom and tension have a continuous slope, but not second derivative', () => {
    const shaping = times.map((_, j) => ({ tension: j === 2 ? 0.5 : 0, bias: 0 }));
    for (const curve of [fitCurve('catmull-rom', data, none), fitCurve('shaped', data, { ...none, shaping })]) {
      for (const jump of jumps(curve, 1)) expect(jump).toBeLessThan(1e-11);
      expect(Math.max(...jumps(curve, 2))).toBeGreaterThan(1);
    }
  });

  it('natural ends do not bend, Hermite ends have the given speeds, a loop closes smoothly', () => {
    const natural = fitCurve('natural', data, none);
    for (const bend of [valueAt(natural, -1, 2), inInterval(natural, 3, 4, 2)]) expect(bend).toBeCloseTo(0, 12);
    const eased = fitCurve('hermite', data, { ...none, speeds: [0, 2] });
    expect(valueAt(eased, -1, 1)).toBeCloseTo(0, 12);
    expect(valueAt(eased, 5, 1)).toBeCloseTo((2 * (1.1 - 0.7)) / 2, 12);
    const loop = fitCurve('periodic', data, none);
    const [start, end] = [loop.times[0]!, loop.times.at(-1)!];
    for (const derivative of [0, 1, 2] as const)
      expect(inInterval(loop, loop.times.length - 2, end, derivative)).toBeCloseTo(
        inInterval(loop, 0, start, derivative),
        11,
      );
    expect(valueAt(loop, start + 0.3 + 2 * (end - start))).toBeCloseTo(valueAt(loop, start + 0.3), 12);
  });

  it('are straight beyond the keys', () => {
    const natural = fitCurve('natural', data, none);
    expect(valueAt(natural, 6) - valueAt(natural, 5)).toBeCloseTo(valueAt(natural, 4, 1), 12);
    expect(valueAt(natural, 6, 2)).toBe(0);
  });

  it.each(all)('%s: the weights add up to 1 and give the curve', (kind) => {
    const shaping = times.map((_, j) => ({ tension: j / 10, bias: 0.3 - j / 5 }));
    const options: FitOptions = { speeds: [0.4, -1], ends: 'hermite', shaping };
    const curve = fitCurve(kind, data, options);
    const weights = weightCurves(kind, times, options);
    for (let t = -2; t < 6; t += 0.17) {
      const at = weights.map((weight) => valueAt(weight, t));
      expect(at.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 11);
      expect(at.reduce((sum, weight, k) => sum + weight * values[k]!, 0)).toBeCloseTo(valueAt(curve, t), 11);
    }
  });
});

describe('the system', () => {
  it('of open ends is tridiagonal, and both solvers agree', () => {
    for (const ends of ['natural', 'hermite'] as const) {
      const system = slopeSystem(data, ends, [1, 1]);
      system.matrix.forEach((row, i) =>
        row.forEach((entry, j) => expect(entry === 0, `${i}, ${j}`).toBe(isApart(i, j, ends))),
      );
      const dense = solveDense(system);
      solveTridiagonal(system).forEach((slope, i) => expect(slope).toBeCloseTo(dense[i]!, 12));
    }
  });

  it('of a loop has two entries in the corners', () => {
    const { matrix } = slopeSystem(data, 'periodic', [1, 1]);
    expect(matrix[0]![4]).toBeGreaterThan(0);
    expect(matrix[4]![0]).toBe(matrix[0]![4]);
  });
});

/** Entries that must be zero in a row of the system: away from the diagonals, and next to a given slope's entry. */
function isApart(i: number, j: number, ends: 'natural' | 'hermite'): boolean {
  const atEnd = i === 0 || i === times.length - 1;
  return Math.abs(i - j) > 1 || (ends === 'hermite' && atEnd && i !== j);
}

describe('bending', () => {
  it('is the integral of the squared second derivative', () => {
    const curve = fitCurve('hermite', data, { ...none, speeds: [0, 3] });
    const steps = 4000;
    let sum = 0;
    for (let i = 0; i < 4; i += 1) {
      const [from, h] = [times[i]!, times[i + 1]! - times[i]!];
      for (let s = 0; s < steps; s += 1)
        sum += (inInterval(curve, i, from + (h * (s + 0.5)) / steps, 2) ** 2 * h) / steps;
    }
    expect(totalBending(curve) / sum).toBeCloseTo(1, 6);
  });

  it('is least for the natural spline, and infinite with a corner', () => {
    const least = totalBending(fitCurve('natural', data, none), 4);
    for (const kind of ['hermite', 'periodic', 'catmull-rom'] as const)
      expect(totalBending(fitCurve(kind, data, none), 4)).toBeGreaterThan(least);
    expect(totalBending(fitCurve('linear', data, none))).toBe(Infinity);
    expect(totalBending(fitCurve('linear', { times, values: times }, none))).toBe(0);
  });

  it('minimised by brute force approaches the natural spline, with the square of the step', () => {
    const curve = fitCurve('natural', data, none);
    const error = (samples: number): number => {
      const sampled = minimiseBending(data, samples);
      expect(sampled.times.at(-1)).toBeCloseTo(4, 12);
      return Math.max(...sampled.values.map((value, i) => Math.abs(value - valueAt(curve, sampled.times[i]!))));
    };
    expect(minSamples(times)).toBe(18);
    expect(minSamples([0, 1, 2, 3, 4])).toBe(5);
    expect(error(240)).toBeLessThan(error(60) / 6);
    expect(error(60)).toBeLessThan(0.06);
  });

  it('of the curve through K samples is never less than that of the natural spline, and approaches it', () => {
    for (const keys of [data, { times: [0, 1, 2, 3, 4], values }]) {
      const least = totalBending(fitCurve('natural', keys, none));
      const more = (samples: number): number => {
        const curve = curveThrough(minimiseBending(keys, samples), keys);
        keys.times.forEach((t, j) => expect(valueAt(curve, t)).toBeCloseTo(keys.values[j]!, 9));
        return totalBending(curve) / least - 1;
      };
      for (let samples = minSamples(keys.times); samples <= 60; samples += 1)
        expect(more(samples), `${samples} samples`).toBeGreaterThan(-1e-9);
      expect(more(120)).toBeLessThan(0.002);
    }
  });

  it('of K samples is least: moving any sample without a key increases it', () => {
    const even = { times: [0, 1, 2, 3, 4], values };
    const { values: path } = minimiseBending(even, 17);
    const energy = (of: readonly number[]): number =>
      of.slice(2).reduce((sum, value, i) => sum + (value - 2 * of[i + 1]! + of[i]!) ** 2, 0) / 0.25 ** 3;
    path.forEach((_, moved) => {
      if (moved % 4 === 0) return;
      for (const by of [-0.01, 0.01]) {
        expect(energy(path.map((value, i) => (i === moved ? value + by : value)))).toBeGreaterThan(energy(path));
      }
    });
  });
});
