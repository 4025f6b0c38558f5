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
import { createEngine } from '../../web/engine/node.ts';
import { openPage } from './browser.ts';
import { benchGhost } from './ghost.ts';
import { measure, type Run } from './measure.ts';
import { runNative, type NativeRun } from './native.ts';
import { report, type Result } from './tables.ts';

// Relative to the bundle, build/node/bench.mjs.
const repository = fileURLToPath(new URL('../../', import.meta.url));
const folder = path.join(repository, 'build/bench');
const generator = path.join(repository, 'build/cmake-wasm/shapespline_samples.js');
const reader = path.join(repository, 'build/cmake-wasm/shapespline_bench_read.wasm');

const DEFAULT_SIZES = '10000,32000,80000,332000,1300000';
const USAGE = 'usage: npm run bench [-- FACES,FACES,... --browser --save] with 64 to 4000000 faces each';

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

/** The generated mesh as a file, and what the native solvers make of it. */
function prepareMesh(faces: number): { mesh: string; native: NativeRun; reference: Float64Array } {
  execFileSync(process.execPath, [generator, '--bench', String(faces), folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  const mesh = path.join(folder, `bench-${faces}.glb`);
  return { mesh, ...runNative(mesh) };
}

async function measureInNode(mesh: string, reference: Float64Array): Promise<Run> {
  const engine = createEngine();
  try {
    return await measure(engine, {
      name: path.basename(mesh),
      mesh: new Uint8Array(readFileSync(mesh)),
      reference,
      reader: readFileSync(reader),
    });
  } finally {
    engine.dispose();
  }
}

async function runAll({ sizes, browser }: Choices): Promise<{ where: string; results: Result[] }> {
  const page = browser ? await openPage(repository) : null;
  try {
    const results: Result[] = [];
    for (const faces of sizes) {
      process.stderr.write(`${faces} faces\n`);
      const { mesh, native, reference } = prepareMesh(faces);
      const run = page ? await page.measure(path.relative(repository, mesh)) : await measureInNode(mesh, reference);
      results.push({ run, native });
    }
    return { where: page ? page.version : `Node ${process.version}`, results };
  } finally {
    await page?.close();
  }
}

function save(text: string, browser: boolean): void {
  const { version } = JSON.parse(readFileSync(path.join(repository, 'package.json'), 'utf8')) as { version: string };
  const file = path.join(repository, 'tests/bench/results', `${version}${browser ? '-browser' : ''}.md`);
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, text);
  process.stderr.write(`saved as ${path.relative(repository, file)}\n`);
}

if (process.argv[2] === 'ghost') process.exit(await benchGhost(process.argv.slice(3)));
const choices = choicesFrom(process.argv.slice(2));
if (!choices) {
  process.stderr.write(`${USAGE}\n`);
  process.exitCode = 2;
} else {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const { where, results } = await runAll(choices);
  const text = report(`# ${where}, ${cpus().length} x ${cpus()[0]?.model ?? 'unknown processor'}`, results);
  console.log(text);
  if (choices.save) save(text, choices.browser);
}
