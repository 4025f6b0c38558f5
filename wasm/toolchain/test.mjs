// `npm test [-- SUITE [ARGUMENTS]]`: runs the suites one after the other, each on all cores, and says where the time
// went.
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { installBlender } from './blender.mjs';
import { buildNative, buildWasm, nodeBundle, npmPackage, page, wasmModule } from './build.mjs';
import { nothing, reports, runReported, sentence, sum } from './counts.mjs';
import { runDoctest } from './doctest.mjs';
import { run, which } from './exec.mjs';
import { lint } from './lint.mjs';
import { whileLocked } from './lock.mjs';
import { Explained, step } from './log.mjs';
import { inParallel } from './parallel.mjs';
import { buildDir, inRoot } from './paths.mjs';
import { prepare, prepareSystem } from './prepare.mjs';
import { forBrowser, forLinting, forNative, forWasm } from './requirements.mjs';
import { freePort } from './serve.mjs';
import { unlessUnchanged } from './unchanged.mjs';

const node = process.execPath;
const bin = (...parts) => inRoot('node_modules', ...parts);

function hasFiles(folder, ending) {
  return (
    existsSync(inRoot(folder)) && readdirSync(inRoot(folder), { recursive: true }).some((name) => name.endsWith(ending))
  );
}

async function typecheck() {
  const folders = ['web', 'tests'].filter((folder) => hasFiles(folder, '.ts'));
  const tasks = folders.map((folder) => async () => {
    step(`checking the types of ${folder}`);
    // What the compiler keeps of the last time spares it the files that have not changed.
    const kept = ['--incremental', '--tsBuildInfoFile', path.join(buildDir, 'types', `${folder}.tsbuildinfo`)];
    const args = [bin('typescript/bin/tsc'), '-p', folder, ...kept];
    const { code } = await run(node, args, { show: 'after', allowFailure: true });
    return code === 0 ? { ...nothing, passed: 1 } : { ...nothing, failed: 1, names: [`the types of ${folder}`] };
  });
  return sum(await inParallel(tasks));
}

// The benchmark's part is compiled with them, so that it does not fall behind unseen.
const nativeTargets = ['shapespline_tests', 'shapespline_thread_tests', 'shapespline_bench_native'];
const compileNative = () => whileLocked(() => buildNative(nativeTargets));
const compileWasm = () => whileLocked(() => buildWasm(['shapespline_tests']));

// ThreadSanitizer needs addresses that are not randomised much.
const atFixedAddresses = (program) => (which('setarch') ? ['setarch', '-R', program] : [program]);

const cases = (name, programs, words, runAll) =>
  words.length > 0 ? runAll() : unlessUnchanged(name, programs, runAll);

function native(words, folder) {
  const [tests, threadTests] = ['shapespline_tests', 'shapespline_thread_tests'].map((name) => path.join(folder, name));
  return cases('native', [tests, threadTests], words, async () => {
    step('native tests, under AddressSanitizer and UBSan');
    const all = await runDoctest('native', [tests], words);
    step('native tests of what two threads share, under ThreadSanitizer');
    return sum([all, await runDoctest('native-threads', atFixedAddresses(threadTests), words)]);
  });
}

function wasm(words, folder) {
  const [script, module] = ['js', 'wasm'].map((ending) => path.join(folder, `shapespline_tests.${ending}`));
  return cases('wasm', [script, module], words, () => {
    step('the same tests as wasm, in Node');
    return runDoctest('wasm', [node, script], words);
  });
}

function countVitest(report) {
  const brokenFiles = report.testResults.filter(
    (file) => file.status === 'failed' && file.assertionResults.length === 0,
  );
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + brokenFiles.length,
    skipped: report.numPendingTests + report.numTodoTests,
    names: [
      ...brokenFiles.map(({ name }) => path.basename(name)),
      ...report.testResults.flatMap(({ name, assertionResults }) =>
        assertionResults
          .filter(({ status }) => status === 'failed')
          .map(({ fullName }) => `${path.basename(name)}: ${fullName}`),
      ),
    ],
  };
}

const vitest = (project) => async (words) => {
  step(`${project} tests`);
  const args = (report) => [
    bin('vitest/vitest.mjs'),
    'run',
    '--config',
    'tests/vitest.config.ts',
    '--project',
    project,
    '--reporter=default',
    '--reporter=json',
    `--outputFile.json=${report}`,
    ...words,
  ];
  return runReported(project, node, args, { count: countVitest });
};

const specsOf = ({ suites = [], specs = [] }) => [...specs, ...suites.flatMap(specsOf)];

function countPlaywright({ suites, stats, errors }) {
  return {
    passed: stats.expected + stats.flaky,
    failed: stats.unexpected + errors.length,
    skipped: stats.skipped,
    names: [
      ...errors.map(({ message }) => message),
      ...specsOf({ suites })
        .filter(({ ok }) => !ok)
        .map(({ file, title }) => `${file}: ${title}`),
    ],
  };
}

async function endToEnd(words) {
  step('end-to-end tests in Chromium, on the development server and on the built page');
  const args = () => [
    bin('@playwright/test/cli.js'),
    'test',
    '--config',
    'tests/e2e',
    '--reporter=list,json',
    ...words,
  ];
  const env = {
    PLAYWRIGHT_JSON_OUTPUT_NAME: path.join(reports, 'e2e.json'),
    SHAPESPLINE_DEV_PORT: String(await freePort()),
    SHAPESPLINE_BUILT_PORT: String(await freePort()),
    SHAPESPLINE_ISOLATED_PORT: String(await freePort()),
  };
  return runReported('e2e', node, args, { count: countPlaywright, env });
}

/**
 * In the order they run: `files` tells whether there is anything to run, `requirements`, `steps` and `compile` what it
 * needs; `run` is told the words and what `compile` returns.
 */
const suites = {
  lint: { run: lint, files: ['web', '.ts'], requirements: forLinting, steps: [] },
  typecheck: { run: typecheck, files: ['web', '.ts'], requirements: forWasm, steps: [wasmModule] },
  unit: { run: vitest('unit'), files: ['tests/unit', '.test.ts'], requirements: [], steps: [] },
  native: {
    run: native,
    files: ['tests/native', '_test.cpp'],
    requirements: forNative,
    steps: [],
    compile: compileNative,
  },
  wasm: { run: wasm, files: ['tests/native', '_test.cpp'], requirements: forWasm, steps: [], compile: compileWasm },
  engine: {
    run: vitest('engine'),
    files: ['tests/engine', '.test.ts'],
    requirements: forWasm,
    steps: [wasmModule, nodeBundle],
  },
  tools: {
    run: vitest('tools'),
    files: ['tests/tools', '.test.ts'],
    requirements: forWasm,
    steps: [wasmModule, nodeBundle],
    compile: installBlender,
  },
  package: {
    run: vitest('package'),
    files: ['tests/package', '.test.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, npmPackage],
  },
  e2e: {
    run: endToEnd,
    files: ['tests/e2e', '.spec.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, page],
  },
};

const secondsSince = (moment) => (performance.now() - moment) / 1000;

// A suite that cannot be built has failed; the others still run.
async function runSuite(name, words) {
  const suite = suites[name];
  if (!hasFiles(...suite.files)) return nothing;
  const started = performance.now();
  let making;
  try {
    await prepare(suite.requirements, suite.steps);
    const made = await suite.compile?.();
    making = secondsSince(started);
    const counts = await suite.run(words, made);
    return { ...counts, making, running: secondsSince(started) - making };
  } catch (error) {
    if (!(error instanceof Explained)) throw error;
    process.stderr.write(`${error.message}\n`);
    making ??= secondsSince(started);
    const names = [error.message.split('\n', 1)[0]];
    return { ...nothing, failed: 1, names, making, running: secondsSince(started) - making };
  }
}

// What is done in less than half a second is not worth a number.
const duration = (seconds) => (seconds >= 0.5 ? `${seconds.toFixed(0)} s` : '');
const row = (name, counts, making, running) =>
  [name.padEnd(10), counts.padEnd(36), making.padStart(8), running.padStart(9)].join(' ').trimEnd();

function summarise(results, settingUp, total) {
  console.log(`\n${row('', '', 'making', 'running')}`);
  console.log(row('setting up', '', duration(settingUp), ''));
  for (const [name, counts] of Object.entries(results)) {
    const missing = counts.running === undefined;
    const running = counts.unchanged ? 'unchanged' : duration(counts.running);
    console.log(row(name, missing ? 'no files yet' : sentence(counts), duration(counts.making), running));
  }
  const all = sum(Object.values(results));
  for (const [name, { names = [] }] of Object.entries(results))
    for (const one of names) console.log(`failed in ${name}: ${one}`);
  console.log(`${sentence(all)}, in ${Math.floor(total / 60)} min ${(total % 60).toFixed(0)} s`);
  return all;
}

export async function test([only, ...words]) {
  if (only && !Object.hasOwn(suites, only)) {
    throw new Explained(`no such suite: ${only} (${Object.keys(suites).join(', ')})`);
  }
  const started = performance.now();
  const names = only ? [only] : Object.keys(suites);
  mkdirSync(reports, { recursive: true });
  await prepareSystem(names.flatMap((name) => suites[name].requirements));
  const settingUp = secondsSince(started);
  const results = {};
  for (const name of names) results[name] = await runSuite(name, words);
  const total = summarise(results, settingUp, secondsSince(started));
  if (total.failed > 0 || total.passed === 0) process.exitCode = 1;
}
