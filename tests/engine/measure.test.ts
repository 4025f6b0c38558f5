/** `measure`: the table of several methods, and their errors against an animation. */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import { folderOf, runCli } from './support/cli.ts';
import { testEngine } from './support/engines.ts';
import { rigFile } from './support/rig.ts';

const engine = testEngine();

const file = 'rig.glb';
const text = (content: string): Uint8Array => new TextEncoder().encode(content);

interface Table {
  comments: string[];
  columns: string[];
  rows: string[][];
}

function read(text: string): Table {
  const lines = text.trimEnd().split('\n');
  const comments = lines.filter((line) => line.startsWith('#'));
  const [columns, ...rows] = lines.slice(comments.length).map((line) => line.split(','));
  return { comments, columns: columns!, rows };
}

const column = ({ columns, rows }: Table, name: string): string[] => {
  expect(columns).toContain(name);
  return rows.map((row) => row[columns.indexOf(name)]!);
};

describe('shapespline measure', () => {
  it('writes the measurements of the engine, and the errors against the animation', { timeout: 60_000 }, async () => {
    const folder = await folderOf([await rigFile(file)]);
    const { code, stdout, stderr } = await runCli(
      folder,
      ...['measure', file, '--sample', '0,0.5,1,1.5,2', '--methods', 'lri,linear,rotation-strain', '--against', file],
      ...['--range=-0.25:2', '--frames', '10'],
    );
    expect([code, stderr]).toEqual([0, '']);
    const table = read(stdout);
    const times = column(table, 'time').map(Number);
    expect(times).toHaveLength(10);
    const keys = await engine.importKeyframes([await rigFile()], { sample: [0, 0.5, 1, 1.5, 2] });
    const sequence = await engine.createSequence(keys);
    const { volume } = await sequence.measures(times);
    column(table, 'lri volume').forEach((cell, index) => expect(Number(cell)).toBeCloseTo(volume[index]!, 5));
    expect(table.columns).not.toContain('linear plane x');
    for (const cell of column(table, 'linear bending energy').map(Number))
      if (cell !== 0) expect(cell, 'no rounding').toBeGreaterThan(1e-9);

    for (const method of ['lri', 'linear', 'rotation-strain']) {
      const largest = column(table, `${method} distance largest`);
      expect(largest[0], 'before the animation').toBe('');
      times.forEach((t, index) => {
        if ([0, 0.5, 1, 1.5, 2].includes(t)) expect(Number(largest[index])).toBeLessThan(0.001);
        else if (t > 0) expect(Number(largest[index])).toBeGreaterThan(0.1);
      });
      const said = table.comments.find((line) => line.startsWith(`# ${method}: KG error`))!;
      const most = Math.max(...largest.map(Number));
      expect(Number(/largest distance ([\d.]+) %/.exec(said)![1])).toBeCloseTo(most, 2);
    }

    const alike = await runCli(
      folder,
      'measure',
      file,
      '--sample',
      '0,0.5,1,1.5,2',
      '--at',
      '0.3,1',
      '--shell-bending',
    );
    const shell = column(read(alike.stdout), 'lri bending by edge lengths and angles').map(Number);
    (await sequence.shellBending([0.3, 1])).forEach((energy, i) => expect(shell[i]! / energy).toBeCloseTo(1, 5));
    expect(alike.stdout).toContain('# bending by edge lengths and angles: ');
    expect(table.columns).not.toContain('lri bending by edge lengths and angles');

    const written = await runCli(folder, 'measure', file, '--frames', '3', '--output', 'table.csv');
    expect([written.code, written.stdout]).toEqual([0, 'table.csv: 3 rows\n']);
    expect(read(await readFile(path.join(folder, 'table.csv'), 'utf8')).rows).toHaveLength(3);
  });

  describe('against the output of complete for the same keys', () => {
    /** A bar along z, with a rotation that increases from pose to pose. */
    const pose = (turn: number): Uint8Array => {
      const lines: string[] = [];
      for (let k = 0; k <= 6; k += 1)
        for (const [x, y] of [
          [1, 1],
          [-1, 1],
          [-1, -1],
          [1, -1],
        ] as const) {
          const angle = (turn * k) / 6;
          const [c, s] = [Math.cos(angle), Math.sin(angle)];
          lines.push(`v ${x * c - y * s} ${x * s + y * c} ${k}`);
        }
      for (let k = 0; k < 6; k += 1)
        for (let c = 0; c < 4; c += 1)
          lines.push(`f ${4 * k + c + 1} ${4 * k + ((c + 1) % 4) + 1} ${4 * k + ((c + 1) % 4) + 5} ${4 * k + c + 5}`);
      return text(`${lines.join('\n')}\n`);
    };
    const KEYS = ['p0.obj', 'p1.obj', 'p2.obj'];
    const percent = (stdout: string): number => Number(/^# lri: KG error ([\d.e-]+) %/m.exec(stdout)?.[1]);

    it.each([
      ['as they are', []],
      ['z up, with another unit, at other times @all', ['--up', 'z', '--unit', '0.01', '--key-times', '3,3.5,7']],
    ])('the error is nothing: keys %s', { timeout: 300_000 }, async (_, options) => {
      const folder = await folderOf(KEYS.map((name, index) => ({ name, bytes: pose(0.9 * index) })));
      for (const [output, args, against] of [
        ['m.glb', [], ['m.glb']],
        ['slow.glb', ['--duration', '9'], ['slow.glb']],
        ['bounce.glb', ['--bounce'], ['bounce.glb']],
        ['frames/', ['--frames', '13'], ['frames']],
        ['beyond/', ['--frames', '21', '--range=-1:9'], ['beyond']],
        ['uneven/', ['--at', options.length > 0 ? '3,3.1,4,5.5,7' : '0,0.1,0.7,1.6,2'], ['uneven']],
        ['c.pc2', ['--fps', '10'], ['c.pc2', '--against', 'c.obj']],
        ['c.mdd', ['--frames', '9', '--duration', '20'], ['c.mdd', '--against', 'c.obj']],
      ] as const) {
        const made = await runCli(folder, 'complete', ...KEYS, ...options, ...args, '--output', output);
        expect([output, made.code]).toEqual([output, 0]);
        const result = await runCli(folder, 'measure', ...KEYS, ...options, '--against', ...against);
        expect([output, result.code]).toEqual([output, 0]);
        expect(`${output} ${percent(result.stdout) < 0.001}`, result.stdout.slice(0, 900)).toBe(`${output} true`);
        if (!['beyond/', 'uneven/'].includes(output)) expect([output, result.stderr]).toEqual([output, '']);
      }
      const { rows } = read((await runCli(folder, 'measure', ...KEYS, ...options, '--against', 'frames')).stdout);
      expect(rows, 'at its own frames').toHaveLength(13);
    });

    it('a cache without times is spread over the keys, and doubtful comparisons give a warning first', {
      timeout: 200_000,
    }, async () => {
      const folder = await folderOf(KEYS.map((name, index) => ({ name, bytes: pose(0.9 * index) })));
      expect((await runCli(folder, 'complete', ...KEYS, '--output', 'c.pc2', '--frames', '25')).code).toBe(0);
      // The file as another program would write it, without our comments.
      const obj = await readFile(path.join(folder, 'c.obj'), 'utf8');
      await writeFile(path.join(folder, 'c.obj'), obj.replace(/^#.*\n/gm, ''));
      const cache = ['--against', 'c.pc2', '--against', 'c.obj'];
      const spread = await runCli(folder, 'measure', ...KEYS, ...cache);
      expect(percent(spread.stdout)).toBeLessThan(0.001);
      expect(spread.stdout).toContain('25, spaced evenly from the first key to the last');

      const alike = await runCli(folder, 'measure', ...KEYS, '--up', 'z', ...cache);
      expect([percent(alike.stdout) < 0.001, alike.stderr]).toEqual([true, '']);
      const turned = await runCli(folder, 'measure', ...KEYS, '--up', 'z', ...cache, '--against-up', 'y');
      expect(percent(turned.stdout)).toBeGreaterThan(1);
      expect(turned.stdout.indexOf('# warning: ')).toBeLessThan(turned.stdout.indexOf('KG error'));
      expect(turned.stderr).toMatch(/^warning: .*--against-up z/);
      const small = await runCli(folder, 'measure', ...KEYS, ...cache, '--against-unit', '0.001');
      expect(small.stderr).toMatch(/--against-unit 1\b/);

      expect((await runCli(folder, 'complete', ...KEYS, '--output', 'm.glb')).code).toBe(0);
      const other = await runCli(folder, 'measure', ...KEYS, '--key-times', '0,0.5,1', '--against', 'm.glb');
      expect(other.stderr).toMatch(/the keys run from 0 to 1 s, and the animation from 0 to 2 s/);
      expect((await runCli(folder, 'measure', ...KEYS, '--against-up', 'z')).code).toBe(2);
    });

    it('compares at times in any order, given several times, alone, or at the end', { timeout: 60_000 }, async () => {
      const folder = await folderOf(KEYS.map((name, index) => ({ name, bytes: pose(0.9 * index) })));
      expect((await runCli(folder, 'complete', ...KEYS, '--output', 'm.glb', '--frames', '41')).code).toBe(0);
      for (const at of ['0.8,0.2', '0.5,0.5', '0.5', '1.9999999,2,2.0000001', '0.3,5,0.1,0.3']) {
        const words = ['measure', ...KEYS, '--at', at];
        const { code, stdout } = await runCli(folder, ...words, '--against', 'm.glb');
        expect([at, code]).toEqual([at, 0]);
        const table = read(stdout);
        expect(column(table, 'time')).toEqual(column(read((await runCli(folder, ...words)).stdout), 'time'));
        // The frames are blended between those of the file.
        const far = column(table, 'lri distance largest');
        at.split(',').forEach((t, row) =>
          t === '5' ? expect(far[row]).toBe('') : expect(Number(far[row])).toBeLessThan(0.1),
        );
      }
    });

    it('no name becomes a spreadsheet formula', { timeout: 60_000 }, async () => {
      const names = ['=1+1.obj', 'a,=2.obj', 'b;@c "x".obj'];
      const folder = await folderOf(names.map((name, index) => ({ name, bytes: pose(0.9 * index) })));
      const { stdout, code } = await runCli(folder, 'measure', ...names, '--frames', '2');
      expect(code).toBe(0);
      const cells = stdout.split(/[,;\t\r\n]/).map((cell) => cell.replace(/^[\s"']+/, ''));
      expect(cells.filter((cell) => /^[=+@-]/.test(cell) && !/^-?[\d.e-]+$/.test(cell))).toEqual([]);
      expect(JSON.parse(/^# files (.*)$/m.exec(stdout)![1]!)).toEqual(names);
    });
  });

  it.each([
    [['--hold', 'on', '--pin', '3:0.1', '--turns', '2:1'], 'lri,rotation-strain,rimd,lengths,geodesic'],
    [['--boundary', 'periodic', '--tension', '0,1,0'], 'lri,lengths,shell'],
    [['--boundary', 'hermite', '--start-speed', '0'], 'lri,geodesic,linear,lengths'],
    [['--keep-lengths', '1'], 'lri,rimd,cubic-vertex'],
    [['--ghost-faces', '60', '--transfer', 'paper'], 'lri,rimd,linear,rotation-strain'],
  ])('leaves %j out of the methods that lack it, in %s', { timeout: 60_000 }, async (options, methods) => {
    const folder = await folderOf([await rigFile(file)]);
    const words = ['measure', file, '--sample', '0,1,2', '--at', '0,0.5'];
    const measured = async (...more: string[]): Promise<string> => {
      const { code, stdout, stderr } = await runCli(folder, ...words, ...more);
      expect([code, stderr]).toEqual([0, '']);
      return stdout;
    };
    const own = await measured(...options);
    const all = await measured(...options, '--methods', methods);
    const [main, last] = [methods.split(',')[0]!, methods.split(',').at(-1)!];
    const volume = `${main} volume`;
    expect(column(read(all), volume)).toEqual(column(read(own), volume));
    if (options[0] !== '--boundary') {
      const plain = await measured('--methods', last);
      const volumes = column(read(plain), `${last} volume`);
      for (const [i, value] of column(read(all), `${last} volume`).entries())
        expect(Number(value) / Number(volumes[i])).toBeCloseTo(1, 6);
    }
  });

  it("leaves a project's options out only for the methods that lack them", { timeout: 60_000 }, async () => {
    const keys = await engine.importKeyframes([await rigFile()], { sample: [0, 0.5, 1, 1.5, 2] });
    const held = await engine.createSequence(keys, { hold: 'on' });
    const [glb] = await held.export({ format: 'glb' });
    const folder = await folderOf([{ name: 'held.glb', bytes: glb!.bytes }]);
    const volumesOf = async (methods: string): Promise<string[]> => {
      const { code, stdout } = await runCli(folder, 'measure', 'held.glb', '--methods', methods, '--frames', '9');
      expect(code).toBe(0);
      return column(read(stdout), 'lri volume');
    };
    expect(await volumesOf('rimd,lri')).toEqual(await volumesOf('lri,rimd'));
  });

  it('refuses unusable input with a message', { timeout: 60_000 }, async () => {
    const pose = (height: number): Uint8Array => text(`v 0 0 0\nv 1 0 0\nv 0 ${height} 0\nf 1 2 3\n`);
    const folder = await folderOf([
      await rigFile(file),
      { name: 'a.obj', bytes: pose(1) },
      { name: 'b.obj', bytes: pose(2) },
    ]);
    for (const [args, code, says] of [
      [['measure'], 2, /give at least one file/],
      [['measure', file, '--methods', 'best'], 2, /--methods.*lri/],
      [['measure', file, '--method', 'lri'], 2, /unknown option --method/],
      [['measure', file, '--hold', 'on', '--methods', 'rimd,lri'], 2, /--hold requires --method lri/],
      [['measure', 'a.obj', 'b.obj', '--against', file], 1, /rig\.glb/],
      [['measure', file, '--against', 'nothing.glb'], 1, /nothing\.glb/],
    ] as const) {
      const result = await runCli(folder, ...args);
      expect([args.join(' '), result.code]).toEqual([args.join(' '), code]);
      expect(result.stderr).toMatch(says);
      expect(result.stdout).toBe('');
    }
  });
});
