/** A C++ suite that has passed runs again after a change, in CI, and after a failure. */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { unlessUnchanged } from '../../wasm/toolchain/unchanged.mjs';
import { reports } from '../../wasm/toolchain/counts.mjs';
import { stampsDir } from '../../wasm/toolchain/paths.mjs';

const NAME = `unchanged-test-${process.pid}`;
const PASSED = { passed: 7, failed: 0, skipped: 1 };

let folder = '';
let program = '';
const suite = (counts = PASSED) => {
  const runAll = vi.fn(() => counts);
  return { runAll, result: unlessUnchanged(NAME, [program], runAll) };
};

beforeEach(() => {
  vi.stubEnv('CI', '');
  folder = mkdtempSync(path.join(tmpdir(), 'shapespline-unchanged-'));
  program = path.join(folder, 'program');
  writeFileSync(program, 'one');
});

afterEach(() => {
  vi.unstubAllEnvs();
  for (const file of [folder, path.join(reports, `${NAME}-passed.json`), path.join(stampsDir, `${NAME}-passed`)])
    rmSync(file, { recursive: true, force: true });
});

it('reports the counts of its last run if nothing has changed', async () => {
  expect(await suite().result).toEqual(PASSED);
  const again = suite();
  expect(await again.result).toEqual({ ...PASSED, unchanged: true });
  expect(again.runAll).not.toHaveBeenCalled();
});

it('runs again with another program, with other real inputs, and in CI', async () => {
  await suite().result;
  writeFileSync(program, 'two');
  expect(await suite().result).toEqual(PASSED);
  vi.stubEnv('SHAPESPLINE_DATA', folder);
  expect(await suite().result).toEqual(PASSED);
  writeFileSync(path.join(folder, 'input.obj'), 'v 0 0 0');
  expect(await suite().result).toEqual(PASSED);
  expect(await suite().result).toEqual({ ...PASSED, unchanged: true });
  vi.stubEnv('CI', 'true');
  expect(await suite().result).toEqual(PASSED);
});

it('runs again after a failure', async () => {
  const failed = { ...PASSED, failed: 1 };
  expect(await suite(failed).result).toEqual(failed);
  expect(await suite().result).toEqual(PASSED);
});
