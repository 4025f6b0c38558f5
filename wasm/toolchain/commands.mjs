// The npm scripts.
import { pathToFileURL } from 'node:url';
import { benchArguments } from './bench-arguments.mjs';
import { benchBundle, benchPrograms, nodeBundle, npmPackage, page, wasmModule } from './build.mjs';
import { run } from './exec.mjs';
import { fuzz } from './fuzz.mjs';
import { printLines } from './lines.mjs';
import { format, lint } from './lint.mjs';
import { step } from './log.mjs';
import { packageDir } from './npm-package.mjs';
import { inRoot } from './paths.mjs';
import { prepare } from './prepare.mjs';
import { forBench, forBrowser, forWasm } from './requirements.mjs';
import { serve } from './serve.mjs';
import { checkPackageSizes, checkSizes } from './sizes.mjs';
import { test } from './test.mjs';

async function build() {
  await prepare(forWasm, [wasmModule, npmPackage, page, nodeBundle]);
  step('checking the sizes');
  checkSizes(inRoot('dist'));
  checkPackageSizes(packageDir);
}

async function start() {
  await prepare(forWasm, [wasmModule, npmPackage, page]);
  const { url } = await serve(inRoot('dist'), { port: Number(process.env.PORT) || 4173, isolated: true });
  console.log(`shapespline is at ${url} (stop it with Ctrl+C)`);
}

async function dev(args) {
  await prepare(forWasm, [wasmModule, npmPackage]);
  await run(process.execPath, [inRoot('node_modules/vite/bin/vite.js'), '--config', 'web/vite.config.ts', ...args], {
    inherit: true,
  });
}

// Runs a bundled program as if started directly, in the user's working directory.
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
  const { browser, what } = benchArguments(args);
  const inBrowser = browser || ['ghost browser', 'exports', 'embed', 'start', 'drop'].includes(what);
  await prepare(
    [...forBench, ...(inBrowser ? forBrowser : [])],
    [wasmModule, ...(what === 'inputs' ? [] : [benchPrograms]), benchBundle, ...(what === 'embed' ? [npmPackage] : [])],
  );
  await runBundle(inRoot('build/node/bench.mjs'), args);
}

async function lintAlone() {
  if ((await lint()).failed > 0) process.exitCode = 1;
}

export const commands = { start, dev, build, test, bench, fuzz, cli, lint: lintAlone, format, lines: printLines };
