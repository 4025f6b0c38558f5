import { randomBytes } from 'node:crypto';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { LIMITS, checkSizes, sizesOf } from '../../wasm/toolchain/sizes.mjs';

let folder = '';

/** Incompressible text. */
const noise = (bytes: number): string => `/* ${randomBytes(bytes / 2).toString('hex')} */`;

function write(name: string, text: string | Uint8Array): void {
  writeFileSync(path.join(folder, name), text);
}

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'sizes-'));
  mkdirSync(path.join(folder, 'assets'));
  write(
    'index.html',
    '<script type="module" src="./assets/index-A.js"></script><link rel="stylesheet" href="./assets/index-S.css">',
  );
  write('assets/index-S.css', 'a{b:c}');
  write(
    'assets/index-A.js',
    'import{a as b}from"./three-B.js";new Worker(new URL("worker-C.js",import.meta.url));b(()=>import("./lazy-D.js"))',
  );
  write('assets/three-B.js', 'export const a=1');
  write('assets/worker-C.js', 'const u=new URL("core-E.wasm",import.meta.url);import("./lazy-D.js")');
  write('assets/core-E.wasm', new Uint8Array(1000));
  write('assets/lazy-D.js', noise(LIMITS.firstPicture * 3));
  write('assets/other-F.js', 'another page');
});

afterEach(() => rmSync(folder, { recursive: true }));

describe('the check of sizes', () => {
  it('counts what the page needs to start: itself, style, imports, the worker, the wasm; not what is loaded later', () => {
    write('assets/shapespline_files-G.wasm', new Uint8Array(1000));
    const when = Object.fromEntries(sizesOf(folder).map((file) => [file.name, file.when]));
    expect(when).toEqual({
      'index.html': 'start',
      'index-S.css': 'start',
      'index-A.js': 'start',
      'three-B.js': 'start',
      'worker-C.js': 'start',
      'core-E.wasm': 'start',
      'lazy-D.js': 'later',
      'shapespline_files-G.wasm': 'later',
      'other-F.js': 'elsewhere',
    });
    const lines: string[] = [];
    checkSizes(folder, (line) => lines.push(line));
    expect(lines.join('\n')).toMatch(
      /lazy-D\.js, only when it is needed[\s\S]*until the first picture: 0\.\d KB[\s\S]*shapespline_files: 0\.\d KB/,
    );
  });

  it('fails above the limit, for worker, page and wasm', () => {
    write('assets/worker-C.js', `new URL("core-E.wasm",import.meta.url);${noise(LIMITS.firstPicture * 3)}`);
    expect(() => checkSizes(folder, () => undefined)).toThrow(
      /first picture .* \(compressed\); the limit is [\d.]+ KB/,
    );
    write('assets/worker-C.js', 'new URL("core-E.wasm",import.meta.url)');
    write('assets/core-E.wasm', randomBytes(LIMITS.firstPicture + 1));
    expect(() => checkSizes(folder, () => undefined)).toThrow(/first picture/);
  });

  it.each(['shapespline_files', 'shapespline_threads'] as const)(
    'fails over the limit of %s, which comes later',
    (name) => {
      write(`assets/${name}-G.wasm`, randomBytes(LIMITS[name] + 1));
      expect(() => checkSizes(folder, () => undefined)).toThrow(new RegExp(`${name} needs [\\d.]+ KB .*the limit is`));
    },
  );

  it('fails if it finds nothing to measure', () => {
    write('assets/worker-C.js', 'const u="core-E.wasm"');
    expect(() => checkSizes(folder, () => undefined)).toThrow(/no wasm was found/);
  });
});
