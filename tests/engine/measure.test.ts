/** `measure`: the table of several methods, and how far each is off an animation. */
import { readFile } from 'node:fs/promises';
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
  it('writes what the engine measures, and the errors against the animation', { timeout: 60_000 }, async () => {
    const folder = await folderOf([await rigFile(file)]);
    const { code, stdout, stderr } = await runCli(
      folder,
      ...['measure', file, '--sample', '0,0.5,1,1.5,2', '--methods', 'lri,linear', '--against', file],
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

    for (const method of ['lri', 'linear']) {
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

    const written = await runCli(folder, 'measure', file, '--frames', '3', '--output', 'table.csv');
    expect([written.code, written.stdout]).toEqual([0, 'table.csv: 3 rows\n']);
    expect(read(await readFile(path.join(folder, 'table.csv'), 'utf8')).rows).toHaveLength(3);
  });

  it('refuses what it cannot use in a sentence', { timeout: 60_000 }, async () => {
    const pose = (height: number): Uint8Array => text(`v 0 0 0\nv 1 0 0\nv 0 ${height} 0\nf 1 2 3\n`);
    const folder = await folderOf([
      await rigFile(file),
      { name: 'a.obj', bytes: pose(1) },
      { name: 'b.obj', bytes: pose(2) },
    ]);
    for (const [args, code, says] of [
      [['measure'], 2, /name at least one file/],
      [['measure', file, '--methods', 'best'], 2, /--methods.*lri/],
      [['measure', file, '--method', 'lri'], 2, /unknown option --method/],
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
