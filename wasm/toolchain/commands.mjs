// The npm scripts.
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { benchBundle, benchPrograms, buildFuzzers, nodeBundle, page, wasmModule } from './build.mjs';
import { run } from './exec.mjs';
import { whileLocked } from './lock.mjs';
import { Explained, step } from './log.mjs';
import { inRoot } from './paths.mjs';
import { prepare, prepareSystem } from './prepare.mjs';
import { forBrowser, forFuzzing, forNative, forWasm } from './requirements.mjs';
import { serve } from './serve.mjs';
import { checkSizes } from './sizes.mjs';
import { test } from './test.mjs';

async function build() {
  await prepare(forWasm, [wasmModule, page, nodeBundle]);
  step('checking the sizes');
  checkSizes(inRoot('dist'));
}

async function start() {
  await prepare(forWasm, [wasmModule, page]);
  const { url } = await serve(inRoot('dist'), { port: Number(process.env.PORT) || 4173 });
  console.log(`shapespline is at ${url} (stop it with Ctrl+C)`);
}

async function dev(args) {
  await prepare(forWasm, [wasmModule]);
  await run(process.execPath, [inRoot('node_modules/vite/bin/vite.js'), '--config', 'web/vite.config.ts', ...args], { inherit: true });
}

// Runs a bundled program as if it had been started itself, where the user is.
async function runBundle(file, args) {
  process.chdir(process.env.INIT_CWD ?? process.cwd());
  process.argv = [process.execPath, file, ...args];
  await import(pathToFileURL(file).href);
}

async function cli(args) {
  await prepare(forWasm, [wasmModule, nodeBundle]);
  await runBundle(inRoot('build/node/cli.mjs'), args);
}

async function bench(args) {
  const browser = args.includes('--browser') ? forBrowser : [];
  await prepare([...forWasm, ...forNative, ...browser], [wasmModule, benchPrograms, benchBundle]);
  await runBundle(inRoot('build/node/bench.mjs'), args);
}

// fuzz [SECONDS] [TARGET]: each target, from its corpus, for so many seconds.
async function fuzz([seconds = '60', only]) {
  await prepareSystem(forFuzzing);
  const folder = await whileLocked(buildFuzzers);
  const targets = readdirSync(folder).filter((name) => name.endsWith('_fuzz') && (!only || name === only));
  if (targets.length === 0) throw new Explained('there is no such fuzz target in tests/fuzz');
  for (const target of targets) {
    const corpus = path.join(folder, 'corpus', target);
    mkdirSync(corpus, { recursive: true });
    const seeds = inRoot('tests/fuzz/corpus', target.replace(/_fuzz$/, ''));
    const inputs = [corpus, ...(existsSync(seeds) ? [seeds] : [])];
    await run(path.join(folder, target), [...inputs, `-max_total_time=${seconds}`, '-timeout=10', `-artifact_prefix=${folder}/`], { inherit: true });
  }
}

export const commands = { start, dev, build, test, bench, fuzz, cli };
