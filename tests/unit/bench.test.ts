import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { benchArguments } from '../../wasm/toolchain/bench-arguments.mjs';
import { withProgram } from '../bench/answers.ts';
import type { Run } from '../bench/measure.ts';
import { quantile, spread } from '../bench/quantile.ts';
import { boundMs, ofRounds, targetsOf, verdict } from '../bench/targets.ts';

describe('the words behind npm run bench --', () => {
  it('say what is measured, on which sizes, and where', () => {
    expect(benchArguments([])).toEqual({ what: 'stages', sizes: null, browser: false, save: false });
    expect(benchArguments(['64,4000000', '--save', '--browser'])).toEqual({
      what: 'stages', sizes: [{ faces: 64, keys: null }, { faces: 4_000_000, keys: null }], browser: true, save: true,
    });
    expect(benchArguments(['threads', '--browser'])).toMatchObject({ what: 'threads', sizes: null, browser: true });
    expect(benchArguments(['ghost', '85000:10,1000'])).toMatchObject({ what: 'ghost', sizes: [{ faces: 85_000, keys: 10 }, { faces: 1000, keys: null }] });
    expect(benchArguments(['ghost', 'browser', '1000'])).toMatchObject({ what: 'ghost browser', sizes: [{ faces: 1000, keys: null }] });
  });

  it.each([
    'nonsense', '63', '4000001', '1e3', '1000.5', '1000,', '1000 2000', '1000:3', '--fast', 'threads --save', 'threads 1000:3',
    'ghost 1000:1', 'ghost 1000:101', 'ghost --browser', 'ghost browser 1000:3', 'ghost browser nonsense',
  ])('are refused where they make no sense: %s', (words) => {
    expect(() => benchArguments(words.split(' '))).toThrow('usage: npm run bench');
  });

  it('are read before anything is looked for or made', () => {
    const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-bare-'));
    try {
      cpSync(fileURLToPath(new URL('../../wasm/toolchain', import.meta.url)), path.join(folder, 'wasm/toolchain'), { recursive: true });
      const env = { ...process.env, SHAPESPLINE_NO_INSTALL: '1' };
      const { status, stderr } = spawnSync(process.execPath, [path.join(folder, 'wasm/toolchain/run.mjs'), 'bench', 'nonsense'], { encoding: 'utf8', env });
      expect(stderr).toMatch(/^usage: npm run bench/);
      expect(status).toBe(1);
      expect(readdirSync(folder)).toEqual(['wasm']);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
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

/** What Eigen took in one round. */
const eigen = (factorMs: number, solveMs: number): Round['eigen'] => ({ factorMs, solveMs, error: 0 });

/** As on a machine that others use: half as fast in two of the rounds, once while the bandwidth was measured, and once while Eigen
    worked. */
const disturbed: Round[] = [
  { factorMs: 10, solveMs: 3, frameMs: 6, eigen: eigen(200, 60), bandwidth: 10 * GB },
  { factorMs: 20, solveMs: 6, frameMs: 12, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { factorMs: 20, solveMs: 6, frameMs: 12, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { factorMs: 10, solveMs: 3, frameMs: 6, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { factorMs: 10, solveMs: 3, frameMs: 9, eigen: eigen(200, 60), bandwidth: 10 * GB },
];

describe('the targets', () => {
  it('compare what was measured in the same round', () => {
    const run = runWith(disturbed);
    expect(boundMs(run, 10 * GB)).toBe(2);  // twice the factor's 10 MB
    expect(ofRounds(run, ({ solveMs, bandwidth }) => solveMs / boundMs(run, bandwidth))).toBe(1.5);
    const reached = Object.fromEntries(targetsOf(run).map(({ what, value }) => [what, value]));
    expect(reached['solve / read bound']).toBe(1.5);
    expect(reached['frame / solve']).toBe(2);
    expect(reached["Eigen's solve / ours"]).toBe(20);
    expect(reached["Eigen's factorisation / ours"]).toBe(20);
  });

  it('name in one sentence what was missed', () => {
    const good = targetsOf(runWith(disturbed));
    expect(verdict(good)).toBe(`All ${good.length} targets were met.`);
    const slow = targetsOf(runWith(disturbed.map((round) => ({ ...round, frameMs: 3 * round.solveMs }))));
    expect(verdict(slow)).toBe(`1 of ${slow.length} targets MISSED: frame / solve at 1300000 faces (3.00, at most 2.50).`);
    const behind = targetsOf(runWith(disturbed.map((round) => ({ ...round, eigen: eigen(20 * round.factorMs, 7.4 * round.solveMs) }))));
    expect(verdict(behind)).toContain("MISSED: Eigen's solve / ours at 1300000 faces (7.40, at least 7.50).");
  });
});

describe('a program that answers', () => {
  /** It numbers its answers and ends itself instead of giving the third one. */
  const NUMBERS = `
    let k = 0;
    console.log('{"asked":false}');
    process.stdin.on('data', () => ++k < 3 ? console.log(JSON.stringify({ k })) : process.exit());`;

  it('says something unasked and then one thing for each question', async () => {
    const said = await withProgram(process.execPath, ['-e', NUMBERS], async ({ next, ask }) => [await next(), await ask(), await ask()]);
    expect(said).toEqual([{ asked: false }, { k: 1 }, { k: 2 }]);
  });

  it('fails instead of keeping one waiting where it has ended, also before it was asked', async () => {
    const asked: unknown[] = [];
    await expect(withProgram(process.execPath, ['-e', NUMBERS], async ({ ask }) => {
      for (let i = 0; i < 5; ++i) asked.push(await ask());
    })).rejects.toThrow('ended without an answer');
    expect(asked).toEqual([{ asked: false }, { k: 1 }, { k: 2 }]);
    await expect(withProgram(process.execPath, ['-e', ''], async ({ next, ask }) => {
      await next().catch(() => undefined);
      return ask();
    })).rejects.toThrow('ended without an answer');
  });
});
