/**
 * npm run bench [-- FACES,FACES,... --browser --save]: every stage over generated meshes, beside native Eigen and the paper.
 * Machines differ: compare numbers of one run.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { browserPlace } from './browser.ts';
import { benchGhost } from './ghost.ts';
import { runNative } from './native.ts';
import { nodePlace } from './node-place.ts';
import { TABLE_2 } from './paper.ts';
import { REFERENCE, type Place } from './place.ts';
import { report, type Results } from './report.ts';
import { threadsLine } from './threads.ts';

// Relative to the bundle, build/node/bench.mjs.
const repository = fileURLToPath(new URL('../../', import.meta.url));
const folder = path.join(repository, 'build/bench');
const generator = path.join(repository, 'build/cmake-wasm/shapespline_samples.js');
const reader = path.join(repository, 'build/cmake-wasm/shapespline_bench_read.wasm');

const DEFAULT_SIZES = '10000,32000,80000,332000,1300000';
const USAGE = 'usage: npm run bench [-- [threads] FACES,FACES,... --browser --save] with 64 to 4000000 faces each';

interface Choices {
  sizes: number[];
  browser: boolean;
  save: boolean;
}

function choicesFrom(args: string[]): Choices | null {
  try {
    const { values, positionals } = parseArgs({
      args,
      allowPositionals: true,
      options: { browser: { type: 'boolean', default: false }, save: { type: 'boolean', default: false } },
    });
    const sizes = (positionals[0] ?? DEFAULT_SIZES).split(',').map(Number);
    const good = positionals.length <= 1 && sizes.every((size) => Number.isInteger(size) && size >= 64 && size <= 4_000_000);
    return good ? { sizes, ...values } : null;
  } catch {
    return null;
  }
}

/** Path of a generated mesh. */
function meshOf(faces: number, split = false): string {
  execFileSync(process.execPath, [generator, split ? '--bench-split' : '--bench', String(faces), folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  return path.join(folder, `bench-${faces}${split ? '-split' : ''}.glb`);
}

function say(what: string): void {
  process.stderr.write(`${what}\n`);
}

async function runAll(place: Place, sizes: number[]): Promise<Results> {
  const where = `${place.name}, ${cpus().length} x ${cpus()[0]?.model ?? 'unknown processor'}`;
  const results: Results = { where, sizes: [], motions: [], resolutions: [] };
  for (const faces of sizes) {
    say(`${faces} faces`);
    const mesh = meshOf(faces);
    const native = runNative(mesh, mesh + REFERENCE);
    results.sizes.push({ native, run: await place.measure(mesh) });
  }
  for (const row of TABLE_2.filter(({ faces }) => faces <= 1.2 * Math.max(...sizes))) {
    say(`${row.model}, ${row.shapes} shapes`);
    results.motions.push({ row, run: await place.motion(meshOf(row.faces), row) });
  }
  // Where the list has a size of about four times the faces.
  for (const faces of sizes.filter((one) => sizes.some((other) => Math.abs(other - 4 * one) < 0.05 * other))) {
    say(`${faces} faces and each of them split into four`);
    results.resolutions.push(await place.resolutions(meshOf(faces), meshOf(faces, true)));
  }
  return results;
}

function save(text: string, browser: boolean): void {
  const { version } = JSON.parse(readFileSync(path.join(repository, 'package.json'), 'utf8')) as { version: string };
  const file = path.join(repository, 'tests/bench/results', `${version}${browser ? '-browser' : ''}.md`);
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, text);
  say(`saved as ${path.relative(repository, file)}`);
}

async function withPlace(browser: boolean, work: (place: Place) => Promise<void>): Promise<void> {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const place = browser ? await browserPlace(repository) : nodePlace(reader);
  try {
    await work(place);
  } finally {
    await place.close();
  }
}

function bench({ sizes, browser, save: keep }: Choices): Promise<void> {
  return withPlace(browser, async (place) => {
    const { text, verdict } = report(await runAll(place, sizes));
    console.log(text);
    if (keep) save(text, browser);
    say(verdict);
  });
}

function benchThreads({ sizes, browser }: Choices): Promise<void> {
  return withPlace(browser, async (place) => {
    for (const faces of sizes) console.log(threadsLine(await place.threads(meshOf(faces))));
  });
}

if (process.argv[2] === 'ghost') process.exit(await benchGhost(process.argv.slice(3)));
const twoThreads = process.argv[2] === 'threads';
const choices = choicesFrom(process.argv.slice(twoThreads ? 3 : 2));
if (choices) await (twoThreads ? benchThreads : bench)(choices);
else {
  say(USAGE);
  process.exitCode = 2;
}
