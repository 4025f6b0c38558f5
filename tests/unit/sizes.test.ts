import { randomBytes } from 'node:crypto';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { LIMITS, checkSizes, sizesOf } from '../../wasm/toolchain/sizes.mjs';

let folder = '';

/** Does not compress. */
const noise = (bytes: number): string => `/* ${randomBytes(bytes / 2).toString('hex')} */`;

function write(name: string, text: string | Uint8Array): void {
  writeFileSync(path.join(folder, name), text);
}

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'sizes-'));
  mkdirSync(path.join(folder, 'assets'));
  write('index.html', '<script type="module" crossorigin src="./assets/index-A.js"></script>');
  write(
    'assets/index-A.js',
    'import{a as b}from"./three-B.js";new Worker(new URL("worker-C.js",import.meta.url));b(()=>import("./lazy-D.js"))',
  );
  write('assets/three-B.js', 'export const a=1');
  write('assets/worker-C.js', 'const u=new URL("core-E.wasm",import.meta.url);import("./lazy-D.js")');
  write('assets/core-E.wasm', new Uint8Array(1000));
  write('assets/lazy-D.js', noise(LIMITS.JavaScript * 3));
  write('assets/other-F.js', 'another page');
});

afterEach(() => rmSync(folder, { recursive: true }));

describe('the check of sizes', () => {
  it('counts what the page needs to start: imports, the worker, the wasm; not what is loaded later', () => {
    const when = Object.fromEntries(sizesOf(folder).map((file) => [file.name, file.when]));
    expect(when).toEqual({
      'index-A.js': 'start',
      'three-B.js': 'start',
      'worker-C.js': 'start',
      'core-E.wasm': 'start',
      'lazy-D.js': 'later',
      'other-F.js': 'elsewhere',
    });
    const lines: string[] = [];
    checkSizes(folder, (line) => lines.push(line));
    expect(lines.join('\n')).toMatch(
      /lazy-D\.js, only when it is needed[\s\S]*JavaScript to start: 0\.\d KB[\s\S]*wasm to start: 0\.\d KB/,
    );
  });

  it('fails over the limit, for the worker as for the page', () => {
    write('assets/worker-C.js', `new URL("core-E.wasm",import.meta.url);${noise(LIMITS.JavaScript * 3)}`);
    expect(() => checkSizes(folder, () => undefined)).toThrow(
      /of JavaScript \(compressed\) to start; the limit is [\d.]+ KB/,
    );
  });

  it('fails over the limit of wasm', () => {
    write('assets/core-E.wasm', randomBytes(LIMITS.wasm + 1));
    expect(() => checkSizes(folder, () => undefined)).toThrow(/of wasm/);
  });

  it('fails over the limit of wasm for a module that comes later', () => {
    write('assets/threads-G.wasm', randomBytes(LIMITS.wasm + 1));
    expect(() => checkSizes(folder, () => undefined)).toThrow(/threads-G\.wasm has [\d.]+ KB .*the limit is/);
  });

  it('fails where it finds nothing to measure', () => {
    write('assets/worker-C.js', 'const u="core-E.wasm"');
    expect(() => checkSizes(folder, () => undefined)).toThrow(/no wasm was found/);
  });
});
