/**
 * npm run bench [-- FACES,FACES,... --browser --save]: every stage over generated meshes, with native solvers and the
 * paper's numbers. Machines differ, so compare numbers of one run only.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { benchArguments, type Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import { browserRunner } from './browser.ts';
import { exportTable } from './exports.ts';
import { benchDrop } from './drop.ts';
import { FEW_KEYS, MANY_KEYS } from './key-counts.ts';
import { withNative } from './native.ts';
import { nodeRunner } from './node-runner.ts';
import { TABLE_2 } from './paper.ts';
import type { Runner } from './runner.ts';
import { report, type Results } from './report.ts';
import { holdTables } from './hold.ts';
import { benchStart } from './start.ts';
import type { Family } from './tables.ts';

// The path is relative to the bundle, build/node/bench.mjs.
const repository = fileURLToPath(new URL('../../', import.meta.url));
const folder = path.join(repository, 'build/bench');
const generator = path.join(repository, 'build/cmake-wasm/shapespline_meshes.js');
const reader = path.join(repository, 'build/cmake-wasm/shapespline_bench_read.wasm');

const DEFAULT_FACES = [10_000, 32_000, 80_000, 332_000, 1_300_000];
/** Size limits for meshes in parts, and with many keys. */
const LARGEST_PARTS = 400_000,
  LARGEST_MANY_KEYS = 100_000;

const facesOf = ({ sizes }: Wanted): number[] => sizes?.map(({ faces }) => faces) ?? DEFAULT_FACES;

/** Path of a generated mesh; `kind` is one of the generator's. */
function meshOf(
  faces: number,
  { kind = '', keys = FEW_KEYS }: { kind?: '' | '-split' | '-parts'; keys?: number } = {},
): string {
  const into = path.join(folder, `keys-${keys}`);
  const words = [generator, `--bench${kind}`, String(faces), String(keys), into];
  execFileSync(process.execPath, words, { stdio: ['ignore', 'ignore', 'inherit'] });
  return path.join(into, `bench-${faces}${kind}.glb`);
}

function say(what: string): void {
  process.stderr.write(`${what}\n`);
}

function machine(): string {
  const { model = 'unknown processor', speed = 0 } = cpus()[0] ?? {};
  const clock = speed > 0 && !/Hz/.test(model) ? ` at ${(speed / 1000).toFixed(2)} GHz` : '';
  return `${cpus().length} x ${model.trim()}${clock}`;
}

/** The smallest and the largest size. */
const endsOf = (sizes: number[]): number[] => [
  ...new Set(sizes.length > 0 ? [Math.min(...sizes), Math.max(...sizes)] : []),
];

async function runAll(runner: Runner, sizes: number[]): Promise<Results> {
  const results: Results = { where: `${runner.name}, ${machine()}`, sizes: [], motions: [], resolutions: [], keys: [] };
  const measure = async (family: Family, faces: number): Promise<void> => {
    say(`${faces} faces, ${family}`);
    const mesh = meshOf(faces, { kind: family === 'parts' ? '-parts' : '', keys: family === 'eight keys' ? 8 : 3 });
    results.sizes.push(
      await withNative(mesh, async (unknowns, runNative) => ({
        family,
        unknowns,
        run: await runner.measure(mesh, runNative),
      })),
    );
  };
  for (const faces of sizes) await measure('smooth', faces);
  for (const faces of sizes.filter((one) => one <= LARGEST_PARTS)) await measure('parts', faces);
  for (const faces of sizes.filter((one) => one > LARGEST_MANY_KEYS && one <= LARGEST_PARTS))
    await measure('eight keys', faces);
  for (const row of TABLE_2.filter(({ faces }) => faces <= 1.2 * Math.max(...sizes))) {
    say(`${row.model}, ${row.shapes} shapes`);
    results.motions.push({ row, run: await runner.motion(meshOf(row.faces), row) });
  }
  // Requires a size of about four times the faces in the list.
  for (const faces of sizes.filter((one) => sizes.some((other) => Math.abs(other - 4 * one) < 0.05 * other))) {
    say(`${faces} faces and each of them split into four`);
    results.resolutions.push(await runner.resolutions(meshOf(faces), meshOf(faces, { kind: '-split' })));
  }
  for (const faces of endsOf(sizes.filter((one) => one <= LARGEST_MANY_KEYS))) {
    for (const keys of MANY_KEYS) {
      say(`${faces} faces, ${keys} keys`);
      results.keys.push(await runner.keys(meshOf(faces), meshOf(faces, { keys }), keys));
    }
  }
  return results;
}

function save(text: string, kind: '' | '-browser' | '-exports' | '-hold'): void {
  const { version } = JSON.parse(readFileSync(path.join(repository, 'package.json'), 'utf8')) as { version: string };
  const file = path.join(repository, 'tests/bench/results', `${version}${kind}.md`);
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, text);
  say(`saved as ${path.relative(repository, file)}`);
}

async function withRunner(browser: boolean, work: (runner: Runner) => Promise<void>): Promise<void> {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const runner = browser ? await browserRunner(repository) : nodeRunner(reader);
  try {
    await work(runner);
  } finally {
    await runner.close();
  }
}

function bench(wanted: Wanted): Promise<void> {
  return withRunner(wanted.browser, async (runner) => {
    const { text, verdict } = report(await runAll(runner, facesOf(wanted)));
    console.log(text);
    if (wanted.save) save(text, wanted.browser ? '-browser' : '');
    say(verdict);
  });
}

async function benchExports({ sizes, save: wanted }: Wanted): Promise<void> {
  const meshBytes = (faces: number): Uint8Array => readFileSync(meshOf(faces));
  const place = { repository, folder: path.join(folder, 'exports'), meshOf: meshBytes, say };
  const text = await exportTable(place, sizes?.map(({ faces }) => faces) ?? null);
  console.log(text);
  if (wanted) save(`# Exported animations in players: ${machine()}\n\n${text}\n`, '-exports');
}

async function benchHold({ files, save: wanted }: Wanted): Promise<void> {
  const text = await holdTables(files, say);
  console.log(text);
  if (wanted) save(`# Motions that hold what rests: ${machine()}\n\n${text}\n`, '-hold');
}

const benches: Record<Wanted['what'], (wanted: Wanted) => Promise<void>> = {
  stages: bench,
  exports: benchExports,
  start: benchStart,
  drop: ({ sizes }) => benchDrop(sizes?.map(({ faces }) => faces) ?? [332_000], meshOf),
  hold: benchHold,
};
const wanted = benchArguments(process.argv.slice(2));
await benches[wanted.what](wanted);
