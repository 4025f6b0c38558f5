// The result of a C++ suite depends on its programs, the files that they read, and the scripts here. If none has
// changed since the suite passed, it is not run again. It always runs with CI set, and for selected cases.
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { reports } from './counts.mjs';
import { step } from './log.mjs';
import { root } from './paths.mjs';
import { digest, filesBelow, isStamped, stamp } from './stamps.mjs';

const runner = ['test', 'suites', 'unchanged', 'doctest', 'counts', 'parallel', 'exec'].map(
  (name) => `wasm/toolchain/${name}.mjs`,
);
const read = ['tests/fuzz/corpus', 'tests/uri-cases.json', 'tests/native-shapes.json', ...runner];
const settings = ['SHAPESPLINE_DATA', 'SHAPESPLINE_SWEEP', 'ASAN_OPTIONS', 'UBSAN_OPTIONS', 'TSAN_OPTIONS'];

// Real inputs are large, so size and date represent their content.
function dated(folder) {
  return filesBelow([path.relative(root, folder)]).map((file) => {
    const { size, mtimeMs } = statSync(path.join(root, file));
    return `${file} ${size} ${mtimeMs}`;
  });
}

function state(programs) {
  const data = process.env.SHAPESPLINE_DATA ?? path.join(root, '..', 'shared', 'data');
  const words = settings.map((name) => process.env[name] ?? '');
  const files = programs.map((program) => path.relative(root, program));
  return digest([...files, ...read], process.version, words, dated(data));
}

/** Runs all cases of a suite of these programs, or returns the counts of its last pass. */
export async function unlessUnchanged(name, programs, runAll) {
  const counted = path.join(reports, `${name}-passed.json`);
  const value = state(programs);
  if (!process.env.CI && existsSync(counted) && isStamped(`${name}-passed`, value, [])) {
    step(`${name} tests: unchanged since they passed`);
    return { ...JSON.parse(readFileSync(counted, 'utf8')), unchanged: true };
  }
  const counts = await runAll();
  if (counts.failed === 0 && counts.passed > 0) {
    mkdirSync(reports, { recursive: true });
    writeFileSync(counted, JSON.stringify(counts));
    stamp(`${name}-passed`, value);
  }
  return counts;
}
