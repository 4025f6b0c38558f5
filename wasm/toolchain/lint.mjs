// `npm run lint` and `npm run format`: clang-format for C++, Biome for TypeScript and the scripts here, and the lints
// of words and names.
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { nothing, sum } from './counts.mjs';
import { run, which } from './exec.mjs';
import { step } from './log.mjs';
import { lintNames } from './names.mjs';
import { inParallel } from './parallel.mjs';
import { inRoot } from './paths.mjs';
import { prepareSystem } from './prepare.mjs';
import { forFormatting } from './requirements.mjs';
import { lintWords } from './words.mjs';

const sources = (folder) =>
  readdirSync(inRoot(folder), { recursive: true })
    .filter((name) => /\.(h|cpp)$/.test(name))
    .map((name) => path.join(folder, name));

const cpp = (...how) => [which('clang-format-19') ?? 'clang-format', how, ['wasm', 'tests'].flatMap(sources)];
const biome = (...how) => [process.execPath, [inRoot('node_modules/@biomejs/biome/bin/biome'), ...how], []];

async function each(tools) {
  const tasks = tools.map(([program, how, files]) => async () => {
    const { code } = await run(program, [...how, ...files], { show: 'after', allowFailure: true });
    return code === 0
      ? { ...nothing, passed: 1 }
      : { ...nothing, failed: 1, names: [[program, ...how].map((part) => path.basename(part)).join(' ')] };
  });
  return sum(await inParallel(tasks));
}

function words() {
  const found = [...lintWords(), ...lintNames()];
  for (const one of found) process.stderr.write(`${one}\n`);
  return found.length === 0 ? { ...nothing, passed: 1 } : { ...nothing, failed: 1, names: ['words'] };
}

/** Checks format, lint rules and words, and prints what to change. */
export async function lint() {
  await prepareSystem(forFormatting);
  step('format, lint rules and words (npm run format fixes the format)');
  return sum([await each([cpp('--dry-run', '-Werror'), biome('check', '--error-on-warnings')]), words()]);
}

export async function format() {
  await prepareSystem(forFormatting);
  step('formatting');
  await each([cpp('-i'), biome('format', '--write')]);
}
