/**
 * npm run bench [-- FACES,FACES,... --browser --save]: every stage over generated meshes, beside native Eigen and the paper.
 * Machines differ: compare numbers of one run.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { benchArguments, type Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import { browserPlace } from './browser.ts';
import { benchGhostInBrowser } from './ghost-browser.ts';
import { benchGhost } from './ghost.ts';
import { withNative } from './native.ts';
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

const DEFAULT_FACES = [10_000, 32_000, 80_000, 332_000, 1_300_000];

const facesOf = ({ sizes }: Wanted): number[] => sizes?.map(({ faces }) => faces) ?? DEFAULT_FACES;

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
    results.sizes.push(await withNative(mesh, mesh + REFERENCE, async (native, runEigen) => ({ native, run: await place.measure(mesh, runEigen) })));
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

function bench(wanted: Wanted): Promise<void> {
  return withPlace(wanted.browser, async (place) => {
    const { text, verdict } = report(await runAll(place, facesOf(wanted)));
    console.log(text);
    if (wanted.save) save(text, wanted.browser);
    say(verdict);
  });
}

function benchThreads(wanted: Wanted): Promise<void> {
  return withPlace(wanted.browser, async (place) => {
    for (const faces of facesOf(wanted)) console.log(threadsLine(await place.threads(meshOf(faces))));
  });
}

const benches = { stages: bench, threads: benchThreads, ghost: benchGhost, 'ghost browser': benchGhostInBrowser };
const wanted = benchArguments(process.argv.slice(2));
await benches[wanted.what](wanted);
