import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { namedArchives, verifyArchives } from '../../wasm/toolchain/apt.mjs';

const content = 'a package';
const sha256 = createHash('sha256').update(content).digest('hex');
const archive = { file: 'thing_1.0_all.deb', sha256 };
let folder = '';

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'archives-'));
});

afterEach(() => {
  rmSync(folder, { recursive: true, force: true });
});

describe('downloaded archives', () => {
  it('are listed with their digests', () => {
    const printed = `Reading...\n'https://mirror.test/pool/thing_1.0_all.deb' thing_1.0_all.deb 9 SHA256:${sha256}\n`;
    expect(namedArchives(printed)).toEqual([archive]);
  });

  it('are accepted if complete', () => {
    writeFileSync(path.join(folder, archive.file), content);
    expect(() => verifyArchives(folder, [archive])).not.toThrow();
  });

  it.each([
    ['cut off', 'a pack'],
    ['changed', 'a parcel!'],
  ])('are refused and deleted when %s', (_what, broken) => {
    writeFileSync(path.join(folder, archive.file), broken);
    expect(() => verifyArchives(folder, [archive])).toThrow('not downloaded whole');
    expect(existsSync(path.join(folder, archive.file))).toBe(false);
  });

  it('are reported if missing', () => {
    expect(() => verifyArchives(folder, [archive])).toThrow(archive.file);
  });
});
