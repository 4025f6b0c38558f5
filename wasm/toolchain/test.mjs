// `npm test [-- SUITE [ARGUMENTS]]`: runs the suites in order of their cost and adds up what their reports say.
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { buildNative, buildWasm, nodeBundle, page, wasmModule } from './build.mjs';
import { run, which } from './exec.mjs';
import { lint } from './lint.mjs';
import { whileLocked } from './lock.mjs';
import { Explained, step } from './log.mjs';
import { buildDir, inRoot } from './paths.mjs';
import { prepare, prepareSystem } from './prepare.mjs';
import { forBrowser, forLinting, forNative, forWasm } from './requirements.mjs';
import { freePort } from './serve.mjs';

const node = process.execPath;
const reports = path.join(buildDir, 'reports');
const nothing = { passed: 0, failed: 0, skipped: 0 };
const bin = (...parts) => inRoot('node_modules', ...parts);

function hasFiles(folder, ending) {
  return (
    existsSync(inRoot(folder)) && readdirSync(inRoot(folder), { recursive: true }).some((name) => name.endsWith(ending))
  );
}

// Runs a program that writes a JSON report; one that leaves none, or fails without a failed test, counts as a failure.
async function runReported(name, program, args, count, env = {}) {
  const report = path.join(reports, `${name}.json`);
  rmSync(report, { force: true });
  const { code } = await run(program, args(report), { show: 'all', allowFailure: true, env });
  if (!existsSync(report)) return { ...nothing, failed: 1 };
  const counts = count(JSON.parse(readFileSync(report, 'utf8')));
  return code !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
}

const sum = (list) =>
  list.reduce(
    (total, counts) => Object.fromEntries(Object.keys(nothing).map((k) => [k, total[k] + counts[k]])),
    nothing,
  );

async function typecheck() {
  const counts = { ...nothing };
  for (const folder of ['web', 'tests']) {
    if (!hasFiles(folder, '.ts')) continue;
    step(`checking the types of ${folder}`);
    const { code } = await run(node, [bin('typescript/bin/tsc'), '-p', folder], { show: 'all', allowFailure: true });
    ++counts[code === 0 ? 'passed' : 'failed'];
  }
  return counts;
}

const doctestArguments = (words) => [
  '--no-version',
  '--no-colors',
  ...words.map((word) => (word.startsWith('-') ? word : `--test-case=*${word}*`)),
];

// ThreadSanitizer needs addresses that are not randomised much.
const atFixedAddresses = (program) =>
  which('setarch') ? { program: 'setarch', before: ['-R', program] } : { program, before: [] };

async function native(words) {
  const folder = await whileLocked(() => buildNative(['shapespline_tests', 'shapespline_thread_tests']));
  const args = (report) => [`--report=${report}`, ...doctestArguments(words)];
  step('native tests, under AddressSanitizer and UBSan');
  const all = await runReported('native', path.join(folder, 'shapespline_tests'), args, (counts) => counts);
  step('native tests of what two threads share, under ThreadSanitizer');
  const { program, before } = atFixedAddresses(path.join(folder, 'shapespline_thread_tests'));
  const shared = await runReported(
    'native-threads',
    program,
    (report) => [...before, ...args(report)],
    (counts) => counts,
  );
  return sum([all, shared]);
}

async function wasm(words) {
  const folder = await whileLocked(() => buildWasm(['shapespline_tests']));
  step('the same tests as wasm, in Node');
  const args = (report) => [
    path.join(folder, 'shapespline_tests.js'),
    `--report=${report}`,
    ...doctestArguments(words),
  ];
  return runReported('wasm', node, args, (counts) => counts);
}

function countVitest(report) {
  const brokenFiles = report.testResults.filter(
    (file) => file.status === 'failed' && file.assertionResults.length === 0,
  );
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + brokenFiles.length,
    skipped: report.numPendingTests + report.numTodoTests,
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
  return runReported(project, node, args, countVitest);
};

function countPlaywright({ stats, errors }) {
  return { passed: stats.expected + stats.flaky, failed: stats.unexpected + errors.length, skipped: stats.skipped };
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
  return runReported('e2e', node, args, countPlaywright, env);
}

/** In the order they run: `files` tells whether there is anything to run, the rest what it needs. */
const suites = {
  lint: { run: lint, files: ['web', '.ts'], requirements: forLinting, steps: [] },
  typecheck: { run: typecheck, files: ['web', '.ts'], requirements: forWasm, steps: [wasmModule] },
  unit: { run: vitest('unit'), files: ['tests/unit', '.test.ts'], requirements: [], steps: [] },
  native: { run: native, files: ['tests/native', '_test.cpp'], requirements: forNative, steps: [] },
  wasm: { run: wasm, files: ['tests/native', '_test.cpp'], requirements: forWasm, steps: [] },
  engine: {
    run: vitest('engine'),
    files: ['tests/engine', '.test.ts'],
    requirements: forWasm,
    steps: [wasmModule, nodeBundle],
  },
  e2e: {
    run: endToEnd,
    files: ['tests/e2e', '.spec.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, page],
  },
};

// A suite that cannot be built has failed; the others still run.
async function runSuite(name, words) {
  const suite = suites[name];
  if (!hasFiles(...suite.files)) return nothing;
  const started = Date.now();
  try {
    await prepare(suite.requirements, suite.steps);
    return { ...(await suite.run(words)), seconds: (Date.now() - started) / 1000 };
  } catch (error) {
    if (!(error instanceof Explained)) throw error;
    process.stderr.write(`${error.message}\n`);
    return { ...nothing, failed: 1, seconds: (Date.now() - started) / 1000 };
  }
}

const sentence = ({ passed, failed, skipped }) => `${passed} passed, ${failed} failed, ${skipped} skipped`;

function summarise(results) {
  const total = { ...nothing };
  console.log('');
  for (const [name, counts] of Object.entries(results)) {
    for (const key of Object.keys(total)) total[key] += counts[key];
    const time = counts.seconds === undefined ? 'no files yet' : `${counts.seconds.toFixed(0)} s`;
    console.log(`${name.padEnd(10)} ${sentence(counts).padEnd(36)} ${time}`);
  }
  console.log(sentence(total));
  return total;
}

export async function test([only, ...words]) {
  if (only && !Object.hasOwn(suites, only)) {
    throw new Explained(`no such suite: ${only} (${Object.keys(suites).join(', ')})`);
  }
  const names = only ? [only] : Object.keys(suites);
  mkdirSync(reports, { recursive: true });
  await prepareSystem(names.flatMap((name) => suites[name].requirements));
  const results = {};
  for (const name of names) results[name] = await runSuite(name, words);
  const total = summarise(results);
  if (total.failed > 0 || total.passed === 0) process.exitCode = 1;
}
