import { describe, expect, it } from 'vitest';
import { readArguments } from '../bench/arguments.ts';
import type { Run } from '../bench/measure.ts';
import type { NativeRun } from '../bench/native.ts';
import { quantile, spread } from '../bench/quantile.ts';
import { boundMs, ofRounds, targetsOf, verdict } from '../bench/targets.ts';

describe('the words behind npm run bench --', () => {
  it('say what is measured, on which sizes, and where', () => {
    expect(readArguments([])).toEqual({ what: 'stages', sizes: null, browser: false, save: false });
    expect(readArguments(['64,4000000', '--save', '--browser'])).toEqual({
      what: 'stages', sizes: [{ faces: 64, keys: null }, { faces: 4_000_000, keys: null }], browser: true, save: true,
    });
    expect(readArguments(['threads', '--browser'])).toMatchObject({ what: 'threads', sizes: null, browser: true });
    expect(readArguments(['ghost', '85000:10,1000'])).toMatchObject({ what: 'ghost', sizes: [{ faces: 85_000, keys: 10 }, { faces: 1000, keys: null }] });
    expect(readArguments(['ghost', 'browser', '1000'])).toMatchObject({ what: 'ghost browser', sizes: [{ faces: 1000, keys: null }] });
  });

  it.each([
    'nonsense', '63', '4000001', '1e3', '1000.5', '1000,', '1000 2000', '1000:3', '--fast', 'threads --save', 'threads 1000:3',
    'ghost 1000:1', 'ghost 1000:101', 'ghost --browser', 'ghost browser 1000:3', 'ghost browser nonsense',
  ])('are refused where they make no sense: %s', (words) => {
    expect(readArguments(words.split(' '))).toBeNull();
  });
});

describe('quantiles', () => {
  it('are values that were seen, whatever their order', () => {
    expect(quantile([5, 1, 4, 2, 3])).toBe(3);
    expect(quantile([10, 9])).toBe(10);
    expect(quantile([7], 0.95)).toBe(7);
    expect(quantile([])).toBeNaN();
    expect(spread(Array.from({ length: 100 }, (_, i) => 99 - i))).toEqual({ median: 50, slow: 95 });
  });
});

type Round = Run['exact']['rounds'][number];

const GB = 1e9;

/** A large mesh that meets every target, but for what its rounds say. */
function runWith(rounds: Round[]): Run {
  const even = { median: 1, slow: 1 }, silence = { ms: 0, stage: '' };
  return {
    faces: 1_300_000, vertices: 650_000, importMs: 1, importSilence: silence, led: null, refitGrowth: 1, heapBytes: 1, factorBytes: 0.01 * GB, error: 0,
    builds: {
      weldMs: 1, encodeMs: 1, orderMs: 1, factorMs: 1, arrangeMs: 1, buildMs: 1, silence, heapBytes: 1, heapGrowth: 1, processGrowth: 0,
    },
    exact: { firstMs: 1, spline: even, solve: even, place: even, normals: even, frame: even, rounds },
    cheap: { firstMs: 1, preview: even, agreement: { mean: 0, worst: 0 } },
  };
}

const native: NativeRun = (() => {
  const solver = { orderMs: 100, factorMs: 100, solveMs: 100, error: 0 };
  return { unknowns: 650_000, eigen: solver, single: solver, double: solver };
})();

/** As on a machine that others use: half as fast in two of the rounds, and once while the bandwidth was measured. */
const disturbed: Round[] = [
  { solveMs: 3, frameMs: 6, bandwidth: 10 * GB },
  { solveMs: 6, frameMs: 12, bandwidth: 5 * GB },
  { solveMs: 6, frameMs: 12, bandwidth: 5 * GB },
  { solveMs: 3, frameMs: 6, bandwidth: 5 * GB },
  { solveMs: 3, frameMs: 9, bandwidth: 10 * GB },
];

describe('the targets', () => {
  it('compare what was measured in the same round', () => {
    const run = runWith(disturbed);
    expect(boundMs(run, 10 * GB)).toBe(2);  // twice the factor's 10 MB
    expect(ofRounds(run, ({ solveMs, bandwidth }) => solveMs / boundMs(run, bandwidth))).toBe(1.5);
    const reached = Object.fromEntries(targetsOf(run, native).map(({ what, value }) => [what, value]));
    expect(reached['solve / read bound']).toBe(1.5);
    expect(reached['frame / solve']).toBe(2);
  });

  it('name in one sentence what was missed', () => {
    const good = targetsOf(runWith(disturbed), native);
    expect(verdict(good)).toBe(`All ${good.length} targets were met.`);
    const slow = targetsOf(runWith(disturbed.map((round) => ({ ...round, frameMs: 3 * round.solveMs }))), native);
    expect(verdict(slow)).toBe(`1 of ${slow.length} targets MISSED: frame / solve at 1300000 faces (3.00, at most 2.50).`);
    const behind = targetsOf(runWith(disturbed), { ...native, eigen: { ...native.eigen, solveMs: 7.4 } });
    expect(verdict(behind)).toContain("MISSED: Eigen's solve / ours at 1300000 faces (7.40, at least 7.50).");
  });
});
