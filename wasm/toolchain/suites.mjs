// The suites of `npm test`: requirements, build steps and commands. Each uses all cores.
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { stripVTControlCharacters } from 'node:util';
import { installBlender } from './blender.mjs';
import { buildNative, buildWasm, nodeBundle, npmPackage, page, wasmModule } from './build.mjs';
import { nothing, reports, runReported, sum } from './counts.mjs';
import { runDoctest } from './doctest.mjs';
import { run, which } from './exec.mjs';
import { lint } from './lint.mjs';
import { whileLocked } from './lock.mjs';
import { step } from './log.mjs';
import { inParallel } from './parallel.mjs';
import { buildDir, inRoot } from './paths.mjs';
import { forBrowser, forFormatting, forNative, forTidying, forWasm } from './requirements.mjs';
import { freePort } from './serve.mjs';
import { tidy } from './tidy.mjs';
import { unlessUnchanged } from './unchanged.mjs';

const node = process.execPath;
const bin = (...parts) => inRoot('node_modules', ...parts);

/** Whether a folder has files with this extension. */
export function hasFiles(folder, ending) {
  return (
    existsSync(inRoot(folder)) && readdirSync(inRoot(folder), { recursive: true }).some((name) => name.endsWith(ending))
  );
}

async function typecheck() {
  const folders = ['web', 'tests'].filter((folder) => hasFiles(folder, '.ts'));
  const tasks = folders.map((folder) => async () => {
    step(`checking the types of ${folder}`);
    // Stored compiler state, so unchanged files are not checked again.
    const kept = ['--incremental', '--tsBuildInfoFile', path.join(buildDir, 'types', `${folder}.tsbuildinfo`)];
    const args = [bin('typescript/bin/tsc'), '-p', folder, ...kept];
    const { code } = await run(node, args, { show: 'after', allowFailure: true });
    return code === 0 ? { ...nothing, passed: 1 } : { ...nothing, failed: 1, names: [`the types of ${folder}`] };
  });
  return sum(await inParallel(tasks));
}

const compileNative =
  (...targets) =>
  () =>
    whileLocked(() => buildNative(targets));
const compileWasm = () => whileLocked(() => buildWasm(['shapespline_tests']));

// ThreadSanitizer needs addresses with little randomisation.
const atFixedAddresses = (program) => (which('setarch') ? ['setarch', '-R', program] : [program]);

const NOT_DENSE = '--test-suite-exclude=dense';
const cases = (name, programs, words, runAll) => {
  if (words.length === 0) return unlessUnchanged(name, programs, runAll);
  return words.join() === NOT_DENSE ? unlessUnchanged(`${name}-thin`, programs, runAll) : runAll();
};

function native(words, folder) {
  const program = path.join(folder, 'shapespline_tests');
  return cases('native', [program], words, () => {
    step('native tests, under AddressSanitizer and UBSan');
    return runDoctest('native', [program], words);
  });
}

function threads(words, folder) {
  const program = path.join(folder, 'shapespline_thread_tests');
  return cases('threads', [program], words, () => {
    step('native tests of code that two threads share, under ThreadSanitizer');
    return runDoctest('threads', atFixedAddresses(program), words);
  });
}

function wasm(words, folder) {
  const [script, module] = ['js', 'wasm'].map((ending) => path.join(folder, `shapespline_tests.${ending}`));
  return cases('wasm', [script, module], words, () => {
    step('the native tests as wasm, in Node');
    return runDoctest('wasm', [node, script], words);
  });
}

/** The first lines of a failure and its line in the test, for the summary. */
function reason(message = '') {
  const lines = stripVTControlCharacters(message)
    .split('\n')
    .map((line) => line.trim());
  const place = lines.find((line) => line.startsWith('at ') && line.includes(inRoot('tests')));
  const words = lines.filter((line) => line && !line.startsWith('at ')).slice(0, 10);
  return [...words, ...(place ? [place] : [])].map((line) => `\n    ${line.slice(0, 200)}`).join('');
}

/** Counts the tests of a report. Tests marked `@all` do not count as skipped if they were excluded. */
const countVitest = (all) => (report) => {
  const brokenFiles = report.testResults.filter(
    (file) => file.status === 'failed' && file.assertionResults.length === 0,
  );
  const tests = report.testResults.flatMap(({ name, assertionResults }) =>
    assertionResults.map((test) => ({ ...test, file: path.basename(name) })),
  );
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + brokenFiles.length,
    skipped: tests.filter(({ status, fullName }) => !RAN.includes(status) && (all || !fullName.includes('@all')))
      .length,
    names: [
      ...brokenFiles.map(({ name }) => path.basename(name)),
      ...tests
        .filter(({ status }) => status === 'failed')
        .map(({ file, fullName, failureMessages }) => `${file}: ${fullName}${reason(failureMessages[0])}`),
    ],
  };
};
const RAN = ['passed', 'failed'];

// Excluded from plain `npm test`: tests marked `@all`.
const NOT_SLOW = '--grep-invert=@all';
const allOf = (words) => (words.includes(NOT_SLOW) ? '' : '1');

// Files of a suite without shared browsers or engines run in shared processes: one per file takes three times as long
// for the unit tests.
const SHARED = '--no-isolate';

const vitest =
  (project, ...flags) =>
  async (words) => {
    step(`${project} tests`);
    const all = allOf(words);
    const args = (report) => [
      bin('vitest/vitest.mjs'),
      'run',
      '--config',
      'tests/vitest.config.ts',
      '--project',
      project,
      ...flags,
      '--reporter=default',
      '--reporter=json',
      `--outputFile.json=${report}`,
      ...words.filter((word) => word !== NOT_SLOW),
    ];
    return runReported(project, node, args, { count: countVitest(all), env: { SHAPESPLINE_ALL: all } });
  };

const specsOf = ({ suites = [], specs = [] }) => [...specs, ...suites.flatMap(specsOf)];

function countPlaywright({ suites, stats, errors }) {
  return {
    passed: stats.expected,
    failed: stats.unexpected + stats.flaky + errors.length,
    skipped: stats.skipped,
    names: [
      ...errors.map(({ message }) => message),
      ...specsOf({ suites })
        .filter(({ ok, tests }) => !ok || tests.some(({ status }) => status === 'flaky'))
        .map(({ file, title, tests }) => {
          const errors = tests.flatMap(({ results }) => results.flatMap(({ error }) => error ?? []));
          return `${file}: ${title}${reason(errors[0]?.stack)}`;
        }),
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
    SHAPESPLINE_ALL: allOf(words),
  };
  return runReported('e2e', node, args, { count: countPlaywright, env });
}

/**
 * Suites in execution order. A suite without `files` is skipped. `requirements`, `steps` and `compile(words)` prepare
 * it; `run(words, compiled)` runs it. Words come from the command line. Plain `npm test` runs a suite with its own
 * `words`, and skips suites with `onlyInAll`. `npm test -- all` runs a suite with its `wordsInAll`, or completely.
 */
export const suites = {
  lint: { run: lint, files: ['web', '.ts'], requirements: forFormatting, steps: [] },
  typecheck: { run: typecheck, files: ['web', '.ts'], requirements: forWasm, steps: [wasmModule] },
  unit: { run: vitest('unit', SHARED), files: ['tests/unit', '.test.ts'], requirements: [], steps: [] },
  native: {
    run: native,
    files: ['tests/native', '_test.cpp'],
    requirements: forNative,
    steps: [],
    compile: compileNative('shapespline_tests'),
    words: [NOT_DENSE],
    // The suite `wasm` runs the dense cases. Sanitizers take three times as long for them, in the same code.
    wordsInAll: [NOT_DENSE],
  },
  engine: {
    run: vitest('engine', SHARED),
    files: ['tests/engine', '.test.ts'],
    requirements: forWasm,
    steps: [wasmModule, nodeBundle],
    words: [NOT_SLOW],
  },
  tools: {
    run: vitest('tools'),
    files: ['tests/tools', '.test.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, nodeBundle],
    compile: (words) => (words.length > 0 ? null : installBlender()),
    words: ['gltf-transform', 'players'],
  },
  package: {
    run: vitest('package'),
    files: ['tests/package', '.test.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, npmPackage],
    words: ['package/node', 'package/pages'],
  },
  e2e: {
    run: endToEnd,
    files: ['tests/e2e', '.spec.ts'],
    requirements: [...forWasm, ...forBrowser],
    steps: [wasmModule, npmPackage, page],
    words: [NOT_SLOW],
  },
  tidy: { run: tidy, files: ['wasm', '.cpp'], requirements: forTidying, steps: [], onlyInAll: true },
  threads: {
    run: threads,
    files: ['tests/native', '_test.cpp'],
    requirements: forNative,
    steps: [],
    // Also compiles the benchmark, to detect changes that break it.
    compile: compileNative('shapespline_thread_tests', 'shapespline_bench_native'),
    onlyInAll: true,
  },
  wasm: {
    run: wasm,
    files: ['tests/native', '_test.cpp'],
    requirements: forWasm,
    steps: [],
    compile: compileWasm,
    onlyInAll: true,
  },
};
