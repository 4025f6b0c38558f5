import { execFileSync, spawn } from 'node:child_process';
import {
  existsSync,
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { build } from 'esbuild';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { writeOutputs } from '../../web/cli/output.ts';
import { EngineError } from '../../web/engine/api/errors.ts';

let folder = '';
const at = (...names: string[]): string => path.join(folder, ...names);
const file = (place: string, bytes: string) => ({ path: place, files: [{ name: place, bytes }] });
const frames = (place: string, ...names: string[]) => ({
  path: `${place}/`,
  files: names.map((name) => ({ name, bytes: name })),
});
const listed = (): string[] => readdirSync(folder, { recursive: true, encoding: 'utf8' }).sort();

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'output-'));
});

afterEach(() => {
  rmSync(folder, { recursive: true, force: true });
});

describe('results', () => {
  it('are written into new folders and over files', async () => {
    writeFileSync(at('report.json'), 'old');
    await writeOutputs([frames(at('new/out'), 'a.obj', 'b.obj'), file(at('report.json'), 'new')]);
    expect(listed()).toEqual(['new', 'new/out', 'new/out/a.obj', 'new/out/b.obj', 'report.json']);
    expect(readFileSync(at('report.json'), 'utf8')).toBe('new');
  });

  it('are written one by one, as they are made', async () => {
    const made = async function* () {
      for (const name of ['a.obj', 'b.obj', 'c.obj']) {
        yield { name, bytes: name };
        await expect.poll(() => listed().some((place) => place.endsWith(name))).toBe(true);
        expect(existsSync(at('out'))).toBe(false);
      }
    };
    await writeOutputs([{ path: `${at('out')}/`, files: made() }]);
    expect(listed()).toEqual(['out', 'out/a.obj', 'out/b.obj', 'out/c.obj']);
  });

  it('that fail leave nothing behind, and report the failure', async () => {
    const made = async function* () {
      yield { name: 'a.obj', bytes: '' };
      await Promise.reject(new EngineError('out-of-memory', 'There is not enough memory.'));
    };
    await expect(writeOutputs([{ path: `${at('out')}/`, files: made() }])).rejects.toThrow(
      /^There is not enough memory\.$/,
    );
    expect(listed()).toEqual([]);
  });

  it('are written to the target of a link, and the link stays', async () => {
    writeFileSync(at('real'), 'old');
    symlinkSync('real', at('link'));
    symlinkSync('later', at('dangling'));
    await writeOutputs([file(at('link'), 'new'), file(at('dangling'), 'made')]);
    expect(lstatSync(at('link')).isSymbolicLink()).toBe(true);
    expect(readFileSync(at('real'), 'utf8')).toBe('new');
    expect(lstatSync(at('dangling')).isSymbolicLink()).toBe(true);
    expect(readFileSync(at('later'), 'utf8')).toBe('made');
  });

  it('are written into devices and pipes, which are not replaced', async () => {
    execFileSync('mkfifo', [at('pipe')]);
    const reader = spawn('cat', [at('pipe')]);
    let read = '';
    reader.stdout.on('data', (chunk: Buffer) => {
      read += chunk.toString();
    });
    const ended = new Promise((resolve) => reader.on('close', resolve));
    await writeOutputs([file('/dev/null', 'nothing'), file(at('pipe'), 'through')]);
    await ended;
    expect(read).toBe('through');
    expect(lstatSync(at('pipe')).isFIFO()).toBe(true);
    expect(lstatSync('/dev/null').isCharacterDevice()).toBe(true);
    expect(readdirSync('/dev').filter((name) => name.startsWith('null'))).toEqual(['null']);
  });

  it.each([
    ['a report whose name is a folder', () => [frames(at('out'), 'a.obj'), file(at('taken'), '')], 'is a folder'],
    ['a frame whose name is a folder', () => [frames(folder, 'a.obj', 'taken')], 'is a folder'],
    ['two results in one place', () => [file(at('x.glb'), ''), file(at('x.glb'), '')], 'would be written to'],
    ['a report over a frame', () => [frames(at('out'), 'a.obj'), file(at('out/a.obj'), '')], 'would be written to'],
    ['a link that leads to itself', () => [frames(at('out'), 'a.obj'), file(at('round'), '')], 'is a link to itself'],
    [
      'a place below a file',
      () => [frames(at('out'), 'a.obj'), file(at('file/x.glb'), '')],
      'not a directory|ENOTDIR|EEXIST',
    ],
  ])('of which one cannot be written leave nothing behind: %s', async (_what, outputs, why) => {
    mkdirSync(at('taken'));
    writeFileSync(at('file'), '');
    symlinkSync('round', at('round'));
    const before = listed();
    await expect(writeOutputs(outputs())).rejects.toThrow(new RegExp(`^Cannot write the result \\(.*(${why})`));
    expect(listed()).toEqual(before);
  });

  it.each(['SIGINT', 'SIGTERM', 'SIGHUP'] as const)('interrupted by %s leave nothing behind', async (by) => {
    execFileSync('mkfifo', [at('pipe')]);
    const script = path.join(folder, 'script.mjs');
    await build({ entryPoints: ['web/cli/output.ts'], bundle: true, platform: 'node', format: 'esm', outfile: script });
    const outputs = JSON.stringify([frames(at('new/out'), 'a.obj'), file(at('pipe'), 'waits for a reader')]);
    const code = `const { writeOutputs } = await import(${JSON.stringify(script)}); await writeOutputs(${outputs});`;
    const before = listed();
    const writer = spawn(process.execPath, ['--input-type=module', '-e', code]);
    await expect.poll(() => listed().some((name) => name.endsWith('a.obj')), { timeout: 30_000 }).toBe(true);
    writer.kill(by);
    expect(await new Promise((resolve) => writer.on('close', (_code, signal) => resolve(signal)))).toBe(by);
    expect(listed()).toEqual(before);
  });
});
