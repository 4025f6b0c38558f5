/** `study`: tables about a ghost mesh, methods and the paper's costs, on samples of the page. */
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import { studyTimes } from '../../web/study/ghost-study.ts';
import { folderOf, runCli } from './support/cli.ts';
import { testEngine } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { rigFile } from './support/rig.ts';
import { bar, bent, foam } from './support/shapes.ts';

const engine = testEngine();

async function sample(name: string): Promise<{ name: string; bytes: Uint8Array }> {
  return { name, bytes: await readFile(path.resolve(import.meta.dirname, '../../public/samples', name)) };
}

interface Table {
  comments: string[];
  rows: Record<string, string>[];
}

function read(text: string): Table {
  const lines = text.trimEnd().split('\n');
  const comments = lines.filter((line) => line.startsWith('#'));
  const [columns, ...rows] = lines.slice(comments.length).map((line) => line.split(','));
  expect(comments.length).toBeGreaterThan(columns!.length);
  for (const name of columns!) expect(comments.some((line) => line.startsWith(`# ${name}: `))).toBe(true);
  return { comments, rows: rows.map((row) => Object.fromEntries(columns!.map((name, i) => [name, row[i]!]))) };
}

async function study(folder: string, ...words: string[]): Promise<Table> {
  const { code, stdout, stderr } = await runCli(folder, 'study', ...words);
  expect([code, stderr]).toEqual([0, '']);
  return read(stdout);
}

const KEY_TIMES = ['--key-times', '0,0.5,1'];

async function importCactus(): Promise<Keys> {
  return engine.importKeyframes([await sample('cactus.glb')], { keyTimes: [0, 0.5, 1] });
}

describe('study ghost', () => {
  it('gives the error as the paper defines it, and a reason for sizes that the shape does not have', async () => {
    const folder = await folderOf([await sample('cactus.glb')]);
    const words = ['ghost', 'cactus.glb', ...KEY_TIMES, '--sizes', '500,40000'];
    const { rows } = await study(folder, ...words);
    expect(rows.map((row) => [row['wanted faces'], row['transfer']])).toEqual([
      ...[
        ['20568', 'none'],
        ['500', 'exact'],
        ['500', 'paper'],
      ],
      ['40000', ''],
    ]);
    expect(rows[3]!['note']).toBe('the shape has only 20568 faces');
    expect(rows[3]!['KG error']).toBe('');

    const keys = await importCactus();
    const [full, ghost] = [
      await engine.createSequence(keys),
      await engine.createSequence(keys, { ghostFaces: 500, transfer: 'paper' }),
    ];
    let [off, spread] = [0, 0];
    for (const t of studyTimes(0, 1)) {
      const [[a], [b]] = [await full.evaluateMany([t]), await ghost.evaluateMany([t])];
      const n = a!.positions.length / 3;
      const centre = [0, 0, 0];
      a!.positions.forEach((value, i) => (centre[i % 3]! += value / n));
      a!.positions.forEach((value, i) => {
        off += (value - b!.positions[i]!) ** 2;
        spread += (value - centre[i % 3]!) ** 2;
      });
    }
    expect(Number(rows[2]!['KG error']) / (100 * Math.sqrt(off / spread))).toBeCloseTo(1, 3);
    for (const row of rows.slice(0, 3)) expect(Number(row['frame time'])).toBeGreaterThan(0);

    const written = await runCli(folder, 'study', ...words, '--output', 'ghost.json');
    expect([written.code, written.stdout]).toEqual([0, 'ghost.json: 4 rows\n']);
    const json = JSON.parse(await readFile(path.join(folder, 'ghost.json'), 'utf8')) as {
      columns: object;
      rows: Record<string, unknown>[];
    };
    expect(json.rows[3]).toMatchObject({ 'wanted faces': 40000, 'KG error': null });
    expect(Object.keys(json.rows[0]!)).toEqual(Object.keys(json.columns));
  });
});

describe('study spaces', () => {
  it('gives the differences of edge lengths and volumes from the splines of the keys', async () => {
    const folder = await folderOf([await sample('cactus.glb')]);
    const { rows } = await study(folder, 'spaces', 'cactus.glb', ...KEY_TIMES, '--methods', 'lri,linear');
    expect(rows.map((row) => row['method'])).toEqual(['lri', 'linear']);
    const keys = await importCactus();
    const { faces } = keys.info;
    const edges = new Map<string, [number, number]>();
    for (let f = 0; f < faces.length; f += 3)
      for (const [a, b] of [
        [faces[f]!, faces[f + 1]!],
        [faces[f + 1]!, faces[f + 2]!],
        [faces[f + 2]!, faces[f]!],
      ] as const)
        edges.set([a, b].sort((x, y) => x - y).join(), [a, b]);
    const lengths = (p: Float32Array): number[] =>
      [...edges.values()].map(([a, b]) => Math.hypot(...[0, 1, 2].map((k) => p[3 * a + k]! - p[3 * b + k]!)));
    const [y0, y1, y2] = [0, 1, 2].map((key) => lengths(keys.positions(key))) as [number[], number[], number[]];
    /** The natural cubic spline of three evenly spaced values, by its second derivative in the middle. */
    const splined = (edge: number, t: number): number => {
      const h = 0.5;
      const middle = (1.5 * (y0[edge]! - 2 * y1[edge]! + y2[edge]!)) / h ** 2;
      const [from, to, x] = t <= h ? [y0[edge]!, y1[edge]!, t] : [y2[edge]!, y1[edge]!, 1 - t];
      return from + ((to - from) * x) / h + (middle / 6) * (x ** 3 / h - x * h);
    };
    for (const [index, method] of (['lri', 'linear'] as const).entries()) {
      const sequence = await engine.createSequence(keys, { method });
      let [sum, count] = [0, 0];
      for (let i = 0; i < 48; i += 1) {
        const t = (i + 0.5) / 48;
        const [frame] = await sequence.evaluateMany([t]);
        lengths(frame!.positions).forEach((length, edge) => {
          sum += (length / splined(edge, t) - 1) ** 2;
          count += 1;
        });
      }
      expect(Number(rows[index]!['edge lengths']) / (100 * Math.sqrt(sum / count)), method).toBeCloseTo(1, 3);
    }
    const [lri, linear] = rows.map((row) => Number(row['volume'])) as [number, number];
    expect(lri).toBeLessThan(1);
    expect(linear).toBeGreaterThan(5);
    for (const row of rows) {
      expect(Number(row['largest bending'])).toBeGreaterThanOrEqual(Number(row['bending']));
      expect(row['KG error']).toBe('');
    }
  });

  it('gives the same errors as measure, and a row with a note for a refused method @all', async () => {
    const folder = await folderOf([await rigFile('rig.glb')]);
    const words = ['rig.glb', '--sample', '0,0.5,1,1.5,2', '--methods', 'lri,lengths', '--against', 'rig.glb'];
    const { rows } = await study(folder, 'spaces', ...words, '--space-samples', '8');
    const { stdout } = await runCli(folder, 'measure', ...words, '--space-samples', '8');
    for (const row of rows) {
      const said = new RegExp(`^# ${row['method']}: KG error ([\\d.]+) %`, 'm').exec(stdout)![1]!;
      expect(Number(row['KG error']) / Number(said)).toBeCloseTo(1, 2);
    }
    const walls = foam(9);
    const files = poseFiles(walls, [walls.positions, bent(walls, 40, 1)]);
    const names = files.map(({ name }) => name);
    const other = await study(await folderOf(files), 'spaces', ...names, '--methods', 'lengths,linear');
    expect(other.rows[0]!['note']).toMatch(/The shape cannot be simplified/);
    expect(other.rows[0]).toMatchObject({ volume: '', 'edge lengths': '', 'frame time': '' });
    expect(Number(other.rows[1]!['edge lengths'])).toBeGreaterThan(0);
  });

  it('has rows for a fitted timing and for frames of another method, and says what made it', async () => {
    const folder = await folderOf([await rigFile('rig.glb')]);
    const from = ['rig.glb', '--sample', '8'];
    const words = ['spaces', ...from, '--against', 'rig.glb', '--methods', 'lri,linear', '--fit-timing', '16'];
    const { comments, rows } = await study(folder, ...words);
    expect(rows.map((row) => [row['method'], row['timing']])).toEqual([
      ['lri', 'off'],
      ['lri', '16'],
      ['linear', 'off'],
    ]);
    const [plain, fitted] = rows.map((row) => Number(row['KG error'])) as [number, number];
    expect(fitted).toBeLessThan(plain);
    for (const [line, holds] of [
      ['# date ', /\d{4}-\d\d-\d\d/],
      ['# machine ', /Node v/],
      ['# options ', /"fit-timing":"16"/],
      ['# timing fitted', /every frame/],
    ] as const)
      expect(comments.find((one) => one.startsWith(line))).toMatch(holds);

    const frames = ['--frames-of', 'own=own', '--against', 'rig.glb', '--methods', 'lri'];
    await runCli(folder, 'complete', ...from, '--frames', '3', '--output', 'own/');
    const wrong = await runCli(folder, 'study', 'spaces', ...from, ...frames);
    const measured = await runCli(folder, 'measure', ...from, '--against', 'rig.glb');
    const times = [...measured.stdout.matchAll(/^([\d.]+),/gm)].map(([, t]) => t!);
    expect([wrong.code, wrong.stderr]).toEqual([
      2,
      expect.stringContaining(`own has 3 frames, but --against has ${times.length}`),
    ]);
    await runCli(folder, 'complete', ...from, '--at', times.join(), '--hold', 'off', '--output', 'own/');
    const table = await study(folder, 'spaces', ...from, ...frames);
    expect(table.rows.map((row) => row['method'])).toEqual(['lri', 'own']);
    const [lri, own] = table.rows as [Record<string, string>, Record<string, string>];
    for (const name of ['KG error', 'largest distance'])
      expect(Number(own[name]) / Number(lri[name])).toBeCloseTo(1, 3);
    expect(own['frame time']).toBe('');
  });
});

describe('methods that fit shapes', () => {
  const words = ['--methods', 'lri,lengths,shell', '--space-samples', '8'];
  /** Keys of a bar. The vertices of the wild ones lie anywhere, which no fit can reach. */
  const posesOf = async (...wild: readonly boolean[]): Promise<[folder: string, names: string[]]> => {
    const mesh = bar(2, 6);
    const files = poseFiles(
      mesh,
      wild.map((isWild, i) => {
        const pose = bent(mesh, [0, 30, 10, 50][i % 4]!);
        return isWild ? pose.map((_, v) => Math.sin((i > 1 ? 5.55 : 7.77) * v * v)) : pose;
      }),
    );
    return [await folderOf(files), files.map(({ name }) => name)];
  };

  it('have a row of the intervals with fits only, which is empty without any, and a warning', async () => {
    const spaces = async ([folder, names]: [string, string[]], ...more: string[]) => {
      const { code, stdout, stderr } = await runCli(folder, 'study', 'spaces', ...names, ...words, ...more);
      expect(code).toBe(0);
      const table = stdout.split('\n').filter((line) => !line.startsWith('#'));
      const [columns = [], ...rows] = table.map((line) => line.split(/,(?! )/));
      return { stderr, rows: rows.map((row) => Object.fromEntries(columns.map((name, i) => [name, row[i] ?? '']))) };
    };
    const failing = await posesOf(false, true);
    const [folder, names] = failing;
    expect((await runCli(folder, 'complete', ...names, '--output', 'truth.glb', '--frames', '9')).code).toBe(0);
    const none = await spaces(failing, '--against', 'truth.glb');
    expect(none.rows.slice(0, 3).map((row) => row['intervals fitted'])).toEqual(['', '0', '0']);
    for (const name of ['volume', 'area', 'edge lengths', 'bending', 'KG error', 'frame time'])
      expect([none.rows[1]![name], none.rows[2]![name]], name).toEqual(['', '']);
    expect(none.stderr).toMatch(/warning: lengths: Between keys 1 and 2, no shapes were found/);
    expect(none.stderr).toMatch(/warning: shell: Between keys 1 and 2/);
    const some = await spaces(await posesOf(false, false, false, true));
    expect(some.rows[2]).toMatchObject({ 'intervals fitted': '2', note: 'no fitted shapes between keys 3 and 4' });
    expect(Number(some.rows[2]!['edge lengths'])).toBeGreaterThan(0);
    const all = await spaces(await posesOf(false, false, false, false));
    expect(all.rows.slice(0, 3).map((row) => row['intervals fitted'])).toEqual(['', '3', '3']);
    expect(all.stderr).not.toMatch(/Between/);
  });

  it('have no numbers in study ghost where they show another method', async () => {
    const ghost = ['--sizes', '26', '--method', 'shell', '--space-samples', '8'];
    const rowsOf = ({ stdout }: { stdout: string }): string[] =>
      stdout.split('\n').filter((line) => /^\d+,\d+,(none|exact|paper),/.test(line));
    const [folder, names] = await posesOf(false, true);
    const none = await runCli(folder, 'study', 'ghost', ...names, ...ghost);
    expect(rowsOf(none)).toHaveLength(3);
    for (const row of rowsOf(none)) expect(row).toMatch(/,,,[\d.]+,no fitted shapes between keys 1 and 2$/);
    expect(none.stderr).toMatch(/warning: Between keys 1 and 2.*\n.*warning: 26 faces: Between keys 1 and 2/);
    const [other, some] = await posesOf(false, false, false, true);
    for (const row of rowsOf(await runCli(other, 'study', 'ghost', ...some, ...ghost)))
      expect(row).toMatch(/(,[\de.-]+){3},no fitted shapes between keys 3 and 4$/);
  });

  it('are counted in study tables: at least two intervals between two keys', async () => {
    const [folder, names] = await posesOf(...Array.from({ length: 12 }, () => false));
    const { stdout } = await runCli(folder, 'study', 'tables', ...names);
    expect(stdout).toMatch(/^2,here,shape,\d+,20,.*\[2\] on \d+ faces at 23 times$/m);
  });

  it('have no times in study tables if no interval was fitted', async () => {
    const [folder, names] = await posesOf(false, true);
    const { stdout } = await runCli(folder, 'study', 'tables', ...names);
    expect(stdout).toMatch(/^2,here,shape,\d+,20,0.05,,,,.*,\[2\]: no fitted shapes between keys 1 and 2$/m);
  });

  it('have no cells in measure where they show another method', async () => {
    const [folder, names] = await posesOf(false, false, false, true);
    const times = ['--at', '0.25,0.75,1.5,2.5'];
    const { stdout, stderr } = await runCli(folder, 'measure', ...names, ...words, ...times, '--shell-bending');
    expect(stderr).toMatch(/warning: shell: Between keys 3 and 4/);
    const [columns = [], ...rows] = stdout
      .trimEnd()
      .split('\n')
      .filter((line) => !line.startsWith('#'))
      .map((line) => line.split(','));
    for (const name of ['volume', 'area', 'bending energy', 'bending by edge lengths and angles'])
      for (const method of ['lri', 'lengths', 'shell']) {
        const cells = rows.map((row) => row[columns.indexOf(`${method} ${name}`)] !== '');
        expect(cells, `${method} ${name}`).toEqual([true, true, true, method !== 'shell']);
      }
  });
});

describe('study tables', () => {
  it("gives the paper's costs next to measured costs for a cactus @all", async () => {
    const folder = await folderOf([await sample('cactus.glb')]);
    const { rows } = await study(folder, 'tables', 'cactus.glb', ...KEY_TIMES);
    expect(rows.map((row) => [row['table'], row['source'], row['shapes'], row['full'] !== ''].join())).toEqual([
      ...['1,paper,1,true', '1,here,1,true', '2,paper,20,true', '2,paper,170,true'],
      ...['2,here,20,true', '2,here,170,true'],
    ]);
    expect(rows[3]).toMatchObject({ '[2] full': '762', full: '23.9', ghost: '0.31' });
    const [, one, , , some] = rows.map((row) => Number(row['full']));
    expect(some! / (20 * one!)).toBeCloseTo(1, 2);
    for (const row of rows.slice(4)) expect(Number(row['[2] ghost'])).toBeGreaterThan(0.1);
    for (const row of rows) expect([Number(row['ghost']) > 0, row['transfer'] !== '']).toEqual([true, true]);
    expect(rows[5]!['note']).toContain('101 times');
  });

  it('gives no numbers of the paper for other shapes, and states why a ghost mesh is missing', async () => {
    const mesh = bar();
    const files = poseFiles(mesh, [mesh.positions, bent(mesh, 60)]);
    const folder = await folderOf(files);
    const { rows } = await study(folder, 'tables', ...files.map(({ name }) => name));
    expect(rows.map((row) => row['source'])).toEqual(['here', 'here']);
    expect(rows[0]).toMatchObject({ ghost: '', transfer: '' });
  });

  it('is one of three studies', async () => {
    const folder = await folderOf([]);
    expect(await runCli(folder, 'study')).toMatchObject({ code: 2, stdout: '' });
    const { code, stderr } = await runCli(folder, 'study', 'cost', 'a.glb');
    expect(code).toBe(2);
    expect(stderr).toMatch(/study ghost, study spaces, study tables/);
    expect((await runCli(folder, 'study', 'spaces')).code).toBe(2);
    expect((await runCli(folder, 'study', 'ghost', 'a.glb', '--sizes', '2')).stderr).toMatch(/--sizes/);
    expect((await runCli(folder, 'study', '--help')).code).toBe(0);
  });
});
