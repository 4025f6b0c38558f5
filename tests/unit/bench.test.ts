import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { WebIO } from '@gltf-transform/core';
import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { benchArguments } from '../../wasm/toolchain/bench-arguments.mjs';
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import type { Frame, ImportOptions, SequenceStats } from '../../web/engine/api/types.ts';
import { sharingVertices } from '../bench/old-layout.ts';
import { withProgram } from '../bench/line-protocol.ts';
import { meshGlb } from '../engine/support/glb.ts';
import { bar, bent } from '../engine/support/shapes.ts';
import { errorsOf } from '../bench/errors.ts';
import { msText } from '../bench/format.ts';
import { fromFramesMs, stagesMs } from '../bench/frames.ts';
import { compareKeys, ratioOf, type KeysRun } from '../bench/key-counts.ts';
import { ghostFrames, stagesOf } from '../bench/ghost-frames.ts';
import type { Run } from '../bench/measure.ts';
import { table1, timesFaster } from '../bench/paper.ts';
import { quantile, spread } from '../bench/quantile.ts';
import { boundMs, frameOverSolve, ofRounds, solveOverBound } from '../bench/ratios.ts';
import { report } from '../bench/report.ts';
import { isInside, SWEEP, sweptParts, type Swept } from '../bench/sweep.ts';
import { aligned, Sliding, walkedOn } from '../bench/truth.ts';
import { errorTable, frameTable, keysTable, type Result } from '../bench/tables.ts';
import { keysTarget, targetsOf, verdict } from '../bench/targets.ts';

describe('the words behind npm run bench --', () => {
  it('say what is measured, on which sizes, and where', () => {
    expect(benchArguments([])).toEqual({ what: 'stages', sizes: null, files: [], browser: false, save: false });
    expect(benchArguments(['64,4000000', '--save', '--browser'])).toEqual({
      what: 'stages',
      sizes: [
        { faces: 64, keys: null },
        { faces: 4_000_000, keys: null },
      ],
      files: [],
      browser: true,
      save: true,
    });
    expect(benchArguments(['threads', '--browser'])).toMatchObject({ what: 'threads', sizes: null, browser: true });
    expect(benchArguments(['exports', '2000', '--save'])).toEqual({
      what: 'exports',
      sizes: [{ faces: 2000, keys: null }],
      files: [],
      browser: false,
      save: true,
    });
    expect(benchArguments(['ghost', '85000:10,1000'])).toMatchObject({
      what: 'ghost',
      sizes: [
        { faces: 85_000, keys: 10 },
        { faces: 1000, keys: null },
      ],
    });
    expect(benchArguments(['embed', '1000'])).toMatchObject({ what: 'embed', sizes: [{ faces: 1000 }] });
    expect(() => benchArguments(['embed', '--browser'])).toThrow();
    expect(benchArguments(['inputs'])).toMatchObject({ what: 'inputs', files: [], save: false });
    expect(benchArguments(['inputs', '7'])).toMatchObject({ what: 'inputs', files: ['7'] });
    expect(() => benchArguments(['inputs', 'all'])).toThrow();
    expect(benchArguments(['start'])).toMatchObject({ what: 'start', sizes: null, save: false });
    expect(() => benchArguments(['start', '1000'])).toThrow();
    expect(benchArguments(['drop', '1000'])).toMatchObject({ what: 'drop', sizes: [{ faces: 1000 }] });
    expect(benchArguments(['hold', 'walk.glb', 'run.glb', '--save'])).toEqual({
      what: 'hold',
      sizes: null,
      files: ['walk.glb', 'run.glb'],
      browser: false,
      save: true,
    });
    expect(() => benchArguments(['hold'])).toThrow();
    expect(() => benchArguments(['hold', 'walk.glb', '--browser'])).toThrow();
    expect(benchArguments(['ghost', 'browser', '1000'])).toMatchObject({
      what: 'ghost browser',
      sizes: [{ faces: 1000, keys: null }],
    });
  });

  it.each([
    'nonsense',
    '63',
    '4000001',
    '1e3',
    '1000.5',
    '1000,',
    '1000 2000',
    '1000:3',
    '--fast',
    'threads --save',
    'threads 1000:3',
    'ghost 1000:1',
    'ghost 1000:101',
    'ghost --browser',
    'exports --browser',
    'exports 1000:3',
    'ghost browser 1000:3',
    'ghost browser nonsense',
  ])('are refused where they make no sense: %s', (words) => {
    expect(() => benchArguments(words.split(' '))).toThrow('usage: npm run bench');
  });

  it('are read before anything is looked for or made', () => {
    const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-bare-'));
    try {
      cpSync(fileURLToPath(new URL('../../wasm/toolchain', import.meta.url)), path.join(folder, 'wasm/toolchain'), {
        recursive: true,
      });
      const env = { ...process.env, SHAPESPLINE_NO_INSTALL: '1' };
      const { status, stderr } = spawnSync(
        process.execPath,
        [path.join(folder, 'wasm/toolchain/run.mjs'), 'bench', 'nonsense'],
        { encoding: 'utf8', env },
      );
      expect(stderr).toMatch(/^usage: npm run bench/);
      expect(status).toBe(1);
      expect(readdirSync(folder)).toEqual(['wasm']);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  });
});

describe('the old layout of an animation', () => {
  it('has all primitives share one vertex buffer with its targets, and the faces of the mesh in their order', async () => {
    const mesh = bar(2, 5);
    const bytes = sharingVertices(meshGlb(mesh, mesh.positions, [bent(mesh, 40)]), 3);
    const { issues } = await validateBytes(bytes);
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    const root = (await new WebIO().readBinary(bytes as Uint8Array<ArrayBuffer>)).getRoot();
    const primitives = root.listMeshes()[0]!.listPrimitives();
    expect(primitives).toHaveLength(3);
    expect(new Set(primitives.map((one) => one.getAttribute('POSITION')))).toHaveProperty('size', 1);
    expect(new Set(primitives.map((one) => one.listTargets()[0]!.getAttribute('POSITION')))).toHaveProperty('size', 1);
    expect(new Set(primitives.map((one) => one.getMaterial()))).toHaveProperty('size', 3);
    expect(primitives.flatMap((one) => [...(one.getIndices()!.getArray() as Uint32Array)])).toEqual([...mesh.indices]);
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

const nowhere: Swept = { mean: 0, largestMean: 0, worst: 0, at: 0 };

/** A large mesh that meets every target, but for what its rounds and errors say. */
function runWith(rounds: Round[], errors: Partial<Run['errors']> = {}): Run {
  const even = { median: 1, slow: 1 },
    silence = { ms: 0, stage: '' },
    off = { inside: nowhere, margins: nowhere };
  return {
    faces: 1_300_000,
    vertices: 650_000,
    importMs: 1,
    importSilence: silence,
    withGhost: null,
    refitGrowth: 1,
    heapBytes: 1,
    factorBytes: 0.01 * GB,
    errors: { double: off, preview: off, ghost: null, ...errors },
    builds: {
      weldMs: 1,
      joinMs: 1,
      encodeMs: 1,
      orderMs: 1,
      factorMs: 1,
      arrangeMs: 1,
      finishMs: 1,
      restMs: 1,
      buildMs: 1,
      silence,
      heapBytes: 1,
      peakOverKept: 1,
      heapGrowth: 1,
      processGrowth: 0,
    },
    exact: {
      firstMs: 1,
      frames: even,
      faces: even,
      solve: even,
      place: even,
      normals: even,
      stages: even,
      frame: even,
      rounds,
    },
    cheap: { firstMs: 1, preview: even },
  };
}

const resultOf = (run: Run, family: Result['family'] = 'smooth'): Result => {
  const solver = { orderMs: 1, factorMs: 1, solveMs: 1, error: 0 };
  return { family, run, native: { unknowns: 1, single: solver, double: solver } };
};

/** Cells of a Markdown table's rows, by title; of two columns with one title the last. */
function cellsOf(text: string): Record<string, string>[] {
  const [titles, , ...rows] = text.split('\n').map((line) =>
    line
      .split('|')
      .slice(1, -1)
      .map((cell) => cell.trim()),
  );
  return rows.map((row) => Object.fromEntries(row.map((cell, k) => [titles![k]!, cell])));
}

/** What Eigen took in one round. */
const eigen = (factorMs: number, solveMs: number): Round['eigen'] => ({ orderMs: 200, factorMs, solveMs, error: 0 });

/**
 * As on a machine that others use: half as fast in two of the rounds, once while the bandwidth was measured, and once
 * while Eigen worked.
 */
const disturbed: Round[] = [
  { untilFrameMs: 99, factorMs: 10, solveMs: 3, frameMs: 6, eigen: eigen(200, 60), bandwidth: 10 * GB },
  { untilFrameMs: 199, factorMs: 20, solveMs: 6, frameMs: 12, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { untilFrameMs: 199, factorMs: 20, solveMs: 6, frameMs: 12, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { untilFrameMs: 99, factorMs: 10, solveMs: 3, frameMs: 6, eigen: eigen(400, 120), bandwidth: 5 * GB },
  { untilFrameMs: 99, factorMs: 10, solveMs: 3, frameMs: 9, eigen: eigen(200, 60), bandwidth: 10 * GB },
];

const MESH = '1300000 faces';
const reachedBy = (run: Run): Record<string, number> =>
  Object.fromEntries(targetsOf(MESH, run).map(({ what, value }) => [what, value]));

describe('the targets', () => {
  it('compare what was measured in the same round', () => {
    const run = runWith(disturbed);
    expect(boundMs(run, 10 * GB)).toBe(2); // twice the factor's 10 MB
    expect(ofRounds(run, solveOverBound)).toBe(1.5);
    const reached = reachedBy(run);
    expect(reached['solve / read bound']).toBe(1.5);
    expect(reached['frame / solve']).toBe(2);
    expect(reached["bytes to first frame / Eigen's analysis"]).toBe(0.5); // reading is a millisecond
    expect(reached["Eigen's solve / ours"]).toBe(20);
    expect(reached["Eigen's factorisation / ours"]).toBe(20);
  });

  it('are the ratios that the table of frames shows', () => {
    const run = runWith(disturbed);
    // The medians of frames and solves over all rounds are others: 9 and 3.
    const exact = { ...run.exact, frame: { median: 9, slow: 9 }, solve: { median: 3, slow: 3 } };
    const [row] = cellsOf(frameTable([resultOf({ ...run, exact })]));
    expect(row!['frame / solve']).toBe('2.00 (2.00 to 3.00)');
    expect(Number.parseFloat(row!['frame / solve']!)).toBe(ofRounds(run, frameOverSolve));
    expect(Number.parseFloat(row!['solve / read bound']!)).toBe(reachedBy(run)['solve / read bound']);
  });

  it('hold the errors of the whole sweep, the margins to limits of their own', () => {
    const run = runWith(disturbed, {
      double: { inside: { ...nowhere, worst: 2e-6 }, margins: { ...nowhere, worst: 8e-6 } },
      preview: {
        inside: { mean: 1e-4, largestMean: 9e-4, worst: 4e-3, at: 0.3 },
        margins: { mean: 1e-3, largestMean: 8e-3, worst: 4e-2, at: 1.4 },
      },
    });
    const missed = targetsOf(MESH, run).filter(({ met }) => !met);
    expect(missed).toEqual([]);
    const reached = reachedBy(run);
    expect(reached['error, 1e-5 of the diagonal']).toBeCloseTo(0.8);
    expect(reached['preview in the mean, % of the diagonal']).toBeCloseTo(0.09);
    expect(reached['preview in the margins at worst, %']).toBeCloseTo(4);
    const worse = runWith(disturbed, {
      preview: { inside: { ...nowhere, largestMean: 0.0011 }, margins: { ...nowhere, worst: 0.051 } },
    });
    expect(
      targetsOf(MESH, worse)
        .filter(({ met }) => !met)
        .map(({ what }) => what),
    ).toEqual(['preview in the mean, % of the diagonal', 'preview in the margins at worst, %']);
  });

  it('name in one sentence what was missed', () => {
    const good = targetsOf(MESH, runWith(disturbed));
    expect(verdict(good)).toBe(`All ${good.length} targets were met.`);
    const slow = targetsOf(MESH, runWith(disturbed.map((round) => ({ ...round, frameMs: 3 * round.solveMs }))));
    expect(verdict(slow)).toBe(
      `1 of ${slow.length} targets MISSED: frame / solve at 1300000 faces (3.00, at most 2.50).`,
    );
    const behind = targetsOf(
      MESH,
      runWith(disturbed.map((round) => ({ ...round, eigen: eigen(20 * round.factorMs, 7.4 * round.solveMs) }))),
    );
    expect(verdict(behind)).toContain("MISSED: Eigen's solve / ours at 1300000 faces (7.40, at least 7.50).");
  });
});

describe('errors', () => {
  it('are measured between the keys and in both margins, as far as the slider goes, and at no key', () => {
    expect(Math.min(...SWEEP)).toBe(-0.4);
    expect(Math.max(...SWEEP)).toBe(1.4);
    expect([...SWEEP].sort((a, b) => a - b)).toEqual(SWEEP);
    expect(SWEEP.filter(isInside).length).toBeGreaterThan(10);
    for (const key of [0, 0.5, 1]) expect(Math.min(...SWEEP.map((t) => Math.abs(t - key)))).toBeGreaterThan(0.01);
  });

  it('have their mean, their largest mean and their worst, with its time', () => {
    const { inside, margins } = sweptParts([
      { t: -0.2, mean: 5, worst: 9 },
      { t: 0.25, mean: 1, worst: 8 },
      { t: 0.5, mean: 3, worst: 4 },
      { t: 1.4, mean: 1, worst: 2 },
    ]);
    expect(inside).toEqual({ mean: 2, largestMean: 3, worst: 8, at: 0.25 });
    expect(margins).toEqual({ mean: 3, largestMean: 5, worst: 9, at: -0.2 });
  });

  it('stand in the table for each way, in percent', () => {
    const off = { mean: 0.01, largestMean: 0.02, worst: 0.03, at: 0.25 };
    const rows = cellsOf(
      errorTable([resultOf(runWith(disturbed, { ghost: { inside: nowhere, margins: off } }), 'parts')]),
    );
    expect(rows.map((row) => row['the exact frame and'])).toEqual(['double', 'preview', 'led by a ghost']);
    expect(rows[2]).toMatchObject({
      mesh: '1300000 faces in parts',
      'in the margins: mean': '1.00',
      'of one shape': '2.00',
      worst: '3.00',
      'at t': '0.25',
    });
  });
});

describe('times', () => {
  it('below what clocks can tell are said to be below it', () => {
    expect([0, 0.0099, 0.01, 12.34, Number.NaN].map(msText)).toEqual(['< 0.01', '< 0.01', '0.010', '12.3', '-']);
    expect(timesFaster(20, 4)).toBe('5.00');
    expect(timesFaster(20, 0)).toBe('> 2000');
  });

  it('of a shape that follows a ghost are those of the stages after its frames', () => {
    const stats = { framesMs: 1, facesMs: 2, solveMs: 4, placeMs: 8, normalsMs: 16, ghostMs: 32 } as SequenceStats;
    expect(stagesMs(stats)).toBe(31);
    expect(fromFramesMs(stats)).toBe(30);
  });

  it("stand beside the paper's, of one shape, in milliseconds", () => {
    const run = runWith(disturbed);
    const withGhost = { ghostFaces: 2000, buildMs: 1, irMs: 24, tsMs: 48, shapes: 12 };
    const rows = cellsOf(table1([{ ...run, withGhost }])!);
    expect(rows.map((row) => row['Armadillo (1.3M)'])).toEqual([
      '39.0',
      '2.00',
      '2862',
      '4.00',
      '2901',
      '6.00',
      '484',
      '37200',
      '1.00',
      '37200',
    ]);
  });
});

/**
 * A sequence whose shape at t is one vertex at x = t, and two that give the box a diagonal of 1; each stage takes a
 * millisecond more.
 */
class FakeSequence {
  readonly range = [0, 1] as const;
  disposed = false;
  stats_ = {
    framesMs: 1,
    facesMs: 2,
    solveMs: 3,
    placeMs: 4,
    normalsMs: 5,
    ghostMs: 0,
    heapBytes: 1,
    ghostFaces: 7,
  } as SequenceStats;
  readonly ms: number;
  readonly off: number;

  constructor(ms: number, off = 0) {
    this.ms = ms;
    this.off = off;
  }

  shape(x: number): Frame {
    const positions = new Float32Array([x, 0, 0, 0, 0, 0, 0.6, 0.8, 0]);
    return { positions, ms: this.ms, release: () => undefined } as unknown as Frame;
  }

  evaluate(t: number): Promise<Frame> {
    return Promise.resolve(this.shape(0.5 + this.off * t));
  }

  preview(t: number): Promise<Frame> {
    return Promise.resolve(this.shape(0.5 + (t < 0 || t > 1 ? 0.03 : 0.003)));
  }

  ghostPositions(): Promise<Float32Array> {
    this.stats_ = { ...this.stats_, ghostMs: 6 };
    return Promise.resolve(new Float32Array());
  }

  stats(): Promise<SequenceStats> {
    return Promise.resolve(this.stats_);
  }

  dispose(): void {
    this.disposed = true;
  }
}

const asSequence = (fake: FakeSequence): Sequence => fake as unknown as Sequence;

describe('a sequence', () => {
  it('is compared with double, with its preview and with the one that a ghost leads, at every time', async () => {
    const asked: number[] = [];
    const reference = (k: number): Promise<Float64Array> => {
      asked.push(k);
      return Promise.resolve(new Float64Array([0.5 + (SWEEP[k] === 1.4 ? 0.06 : 0), 0, 0, 0, 0, 0, 0.6, 0.8, 0]));
    };
    const exact = asSequence(new FakeSequence(1)),
      withGhost = asSequence(new FakeSequence(1, 0.09));
    const { double, preview, ghost } = await errorsOf(exact, withGhost, reference);
    expect(asked).toEqual(SWEEP.map((_, k) => k));
    expect(double.inside.worst).toBeCloseTo(0, 6);
    expect([double.margins.worst, double.margins.at]).toEqual([expect.closeTo(0.06, 5), 1.4]);
    expect([preview.inside.worst, preview.inside.mean]).toEqual([expect.closeTo(0.003, 6), expect.closeTo(0.001, 6)]);
    expect(preview.margins.largestMean).toBeCloseTo(0.01, 6);
    expect([ghost!.margins.worst, ghost!.margins.at]).toEqual([expect.closeTo(0.09 * 1.4, 5), 1.4]);
    expect((await errorsOf(asSequence(new FakeSequence(1)), null, reference)).ghost).toBeNull();
  });

  it('that a ghost leads takes what its own clocks say, for all shapes', async () => {
    const withGhost = { sequence: asSequence(new FakeSequence(100)), buildMs: 9 };
    expect(await ghostFrames(withGhost, 12)).toEqual({ ghostFaces: 7, buildMs: 9, irMs: 12 * 6, tsMs: 12 * 14 });
    expect(await stagesOf(withGhost.sequence, 12)).toBe(12 * 15);
  });

  it('with many keys is measured in turn with the one with few, and both are let go', async () => {
    const fakes = [new FakeSequence(2), new FakeSequence(5)];
    const engine = {
      // As the engine does: of many keys it takes eight, unless it is told how many.
      importKeyframes: (
        [{ bytes }]: [{ bytes: Uint8Array }],
        { sample = bytes.length > 32 ? 8 : bytes.length }: ImportOptions = {},
      ) =>
        Promise.resolve({
          info: { times: Array.from({ length: Math.min(Number(sample), bytes.length) }), report: { faces: 10_000 } },
          dispose: () => undefined,
        }),
      createSequence: (keys: { info: { times: unknown[] } }) =>
        Promise.resolve(fakes[keys.info.times.length === 3 ? 0 : 1]),
    } as unknown as Engine;
    const run = await compareKeys(engine, new Uint8Array(3), new Uint8Array(100), 100);
    expect(run).toMatchObject({ faces: 10_000, ratio: 2.5, few: { keys: 3, frame: { median: 2 } } });
    expect(run.many).toMatchObject({ keys: 100, frame: { median: 5 }, frames: { median: 1 }, faces: { median: 2 } });
    expect(fakes.map(({ disposed }) => disposed)).toEqual([true, true]);
    await expect(compareKeys(engine, new Uint8Array(3), new Uint8Array(50), 100)).rejects.toThrow(
      '100 keys were written, but 50 read',
    );
  });
});

const keysRun = (keys: number, ratio: number): KeysRun => {
  const even = { median: 1, slow: 1 };
  const cost = { keys: 3, buildMs: 1, frame: even, frames: even, faces: even, heapBytes: 2 ** 20 };
  return { faces: 10_000, few: cost, many: { ...cost, keys }, ratio };
};

describe('more keys', () => {
  it('are compared with few round by round', () => {
    // A machine that slows down, and was disturbed in the second round.
    expect(
      ratioOf(
        [
          [1, 2, 1],
          [2, 2, 4],
          [4, 4, 4],
        ],
        [
          [3, 3, 3],
          [10, 10, 10],
          [12, 12, 12],
        ],
      ),
    ).toBe(3);
  });

  it('may not cost as many times more as there are', () => {
    expect(keysTarget(keysRun(8, 2.6))).toMatchObject({ what: 'frame with 8 keys / with 3', limit: 8 / 3, met: true });
    expect(keysTarget(keysRun(8, 2.7)).met).toBe(false);
  });

  it('have one row for few and one for each of the others', () => {
    const rows = cellsOf(keysTable([keysRun(8, 1.5), keysRun(25, 3), { ...keysRun(8, 2), faces: 80_000 }]));
    expect(rows.map((row) => [row['keys'], row['frame / with few'], row['keys / few']])).toEqual([
      ['3', '1.00', '1.00'],
      ['8', '1.50', '2.67'],
      ['25', '3.00', '8.33'],
      ['3', '1.00', '1.00'],
      ['8', '2.00', '2.67'],
    ]);
  });
});

describe('the report', () => {
  it('names both machines beside each comparison with the paper, and takes that from the smooth mesh', () => {
    const where = 'Node v20, 2 x Some Processor';
    const smooth = { ...runWith(disturbed), faces: 10_000 };
    const parts = { ...smooth, exact: { ...smooth.exact, stages: { median: 77, slow: 77 } } };
    const times = { ir: 1, ts: 1, o: 1 };
    const row = { model: 'Cactus', faces: 10_000, shapes: 20, fraction: 0.05, other: times, paper: times };
    const motion = {
      row,
      run: { withGhost: { ghostFaces: 500, buildMs: 1, irMs: 1, tsMs: 1 }, buildMs: 1, wholeMs: 1 },
    };
    const { text, verdict: sentence } = report({
      where,
      sizes: [resultOf(parts, 'parts'), resultOf(smooth)],
      motions: [motion],
      resolutions: [],
      keys: [keysRun(8, 9)],
    });
    const [table1Text, table2Text] = ['Table 1', 'Table 2'].map(
      (title) => text.split(`paper's ${title}`)[1]!.split('##')[0]!,
    );
    for (const section of [table1Text, table2Text]) {
      expect(section).toContain(where);
      expect(section).toContain('Intel Core i7-3770 at 3.40 GHz');
    }
    expect(table1Text).not.toContain('77.0');
    expect(text).toContain('10000 faces in parts');
    expect(sentence).toContain('frame with 8 keys / with 3 at 10000 faces (9.00, at most 2.67)');
  });
});

describe('a program that replies', () => {
  /** It numbers its replies and ends itself instead of giving the third one. */
  const NUMBERS = `
    let k = 0;
    console.log('{"asked":false}');
    process.stdin.on('data', () => ++k < 3 ? console.log(JSON.stringify({ k })) : process.exit());`;

  it('says something unasked and then one thing for each question', async () => {
    const said = await withProgram(process.execPath, ['-e', NUMBERS], async ({ next, ask }) => [
      await next(),
      await ask(),
      await ask(),
    ]);
    expect(said).toEqual([{ asked: false }, { k: 1 }, { k: 2 }]);
  });

  it('fails instead of keeping one waiting where it has ended, also before it was asked', async () => {
    const asked: unknown[] = [];
    await expect(
      withProgram(process.execPath, ['-e', NUMBERS], async ({ ask }) => {
        for (let i = 0; i < 5; ++i) asked.push(await ask());
      }),
    ).rejects.toThrow('ended without a reply');
    expect(asked).toEqual([{ asked: false }, { k: 1 }, { k: 2 }]);
    await expect(
      withProgram(process.execPath, ['-e', ''], async ({ next, ask }) => {
        await next().catch(() => undefined);
        return ask();
      }),
    ).rejects.toThrow('ended without a reply');
  });
});

describe('a motion beside a captured one', () => {
  const shape = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3);

  it('is laid over it, turned and moved as a whole', () => {
    // A quarter turn about z, which takes x to y, and a step.
    const turned = shape.map((_, i) => [5 - shape[i + 1]!, shape[i - 1]! - 1, shape[i]! + 2][i % 3]!);
    aligned(shape, turned).forEach((value, i) => {
      expect(value).toBeCloseTo(turned[i]!, 5);
    });
    expect(
      aligned(
        shape,
        shape.map((value) => 2 * value),
      ),
    ).not.toEqual(shape);
  });

  it('slides as far as what rests in the captured one is from where it truly is', () => {
    const moved = (x: number, which: number): Float32Array => shape.map((value, i) => value + (i === which ? x : 0));
    const sliding = new Sliding(10);
    expect(sliding.percent).toBeNaN();
    sliding.add(shape, shape, true);
    // The first vertex goes away in truth, so that three of them rest; one of these slides by 1, 10 % of the diagonal.
    sliding.add(moved(1, 0), moved(1, 3), false);
    sliding.add(moved(1, 0), moved(1, 0), true);
    expect(sliding.percent).toBeCloseTo(10 * Math.sqrt(1 / 3), 5);
  });

  it('walks on where what is on the ground stays, and nowhere without steps', () => {
    // A head, and a foot that slides back by 1 a frame along x and z.
    const frames = Array.from({ length: 8 }, (_, i) => Float32Array.of(0, 10, 0, -i, 0, -i, -i, 0.1, -i));
    const onward = walkedOn(frames, 10)!;
    expect(Array.from(onward[7]!)).toEqual([7, 10, 7, 0, 0, 0, 0, expect.closeTo(0.1, 5), 0]);
    expect(walkedOn(frames.slice(0, 3), 10)).toBeNull();
  });
});
