import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { whileHolding } from '../../wasm/toolchain/lock.mjs';

let folder = '';
let lock = '';

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'lock-'));
  lock = path.join(folder, 'lock');
});

afterEach(() => {
  rmSync(folder, { recursive: true, force: true });
});

const module = pathToFileURL(path.resolve('wasm/toolchain/lock.mjs')).href;

/** Another process that runs `body` while holding the lock. */
function holding(body: string) {
  const code = `const { whileHolding } = await import(${JSON.stringify(module)});
    const { appendFileSync, existsSync } = await import('node:fs');
    await whileHolding(${JSON.stringify(lock)}, async () => { ${body} });`;
  return spawn(process.execPath, ['--input-type=module', '-e', code], { stdio: ['ignore', 'pipe', 'pipe'] });
}

type Child = ReturnType<typeof holding>;
const ended = (child: Child) => new Promise<number | null>((resolve) => child.on('close', resolve));
const said = (child: Child, words: string) =>
  new Promise<string>((resolve) => {
    let text = '';
    const take = (chunk: Buffer) => {
      text += chunk.toString();
      if (text.includes(words)) resolve(text);
    };
    child.stdout.on('data', take);
    child.stderr.on('data', take);
  });

describe('the lock of a checkout', () => {
  it('is released by an action that fails', async () => {
    await expect(whileHolding(lock, () => Promise.reject(new Error('failed')))).rejects.toThrow('failed');
    expect(existsSync(lock)).toBe(false);
  });

  it.each([
    ['nothing, as after a full disk', ''],
    ['no JSON', '4711'],
    ['a process that has ended', JSON.stringify({ pid: 4_194_304, start: '1', since: '' })],
    ['a process that got the id of the one that held it', JSON.stringify({ pid: process.ppid, start: '1', since: '' })],
  ])('is taken over where it holds %s', async (_what, content) => {
    writeFileSync(lock, content);
    expect(await whileHolding(lock, () => 'done')).toBe('done');
    expect(readdirSync(folder)).toEqual([]);
  });

  it('is waited for, with a message', async () => {
    const sign = path.join(folder, 'sign');
    const child = await whileHolding(lock, async () => {
      const waiting = holding(`console.log(existsSync(${JSON.stringify(sign)}) ? 'after' : 'before');`);
      const text = await said(waiting, 'waiting for');
      expect(text).toContain(`process ${process.pid}, since 20`);
      writeFileSync(sign, '');
      return waiting;
    });
    const text = said(child, 'after');
    expect(await ended(child)).toBe(0);
    expect(await text).toContain('after');
  });

  it('is held by one process at a time, also if several find it stale', async () => {
    writeFileSync(lock, '');
    const log = path.join(folder, 'log');
    const line = (word: string) => `appendFileSync(${JSON.stringify(log)}, '${word}\\n');`;
    const body = `${line('in')} await new Promise((wake) => setTimeout(wake, 20)); ${line('out')}`;
    const codes = await Promise.all(Array.from({ length: 4 }, () => ended(holding(body))));
    expect(codes).toEqual([0, 0, 0, 0]);
    expect(readFileSync(log, 'utf8')).toBe('in\nout\n'.repeat(4));
  });

  const disk = path.join(tmpdir(), `lock-disk-${process.pid}`);
  const mount = () => {
    mkdirSync(disk, { recursive: true });
    return spawnSync('mount', ['-t', 'tmpfs', '-o', 'size=64k', 'tmpfs', disk]).status === 0;
  };
  it('reports a full disk, and leaves nothing behind', async (context) => {
    if (!mount()) return context.skip('needs the right to mount a small disk');
    try {
      expect(() => writeFileSync(path.join(disk, 'all'), Buffer.alloc(1 << 20))).toThrow('ENOSPC');
      await expect(whileHolding(path.join(disk, 'lock'), () => 'done')).rejects.toThrow('the disk is full');
      expect(readdirSync(disk)).toEqual(['all']);
    } finally {
      spawnSync('umount', [disk]);
      rmSync(disk, { recursive: true, force: true });
    }
  });
});
