// Runs clang-tidy over core, io and shells, one folder at a time. All sources of a folder are checked together,
// because most time is spent on headers of other folders. A folder is checked again if it, one of our headers that it
// includes, or the rules have changed.
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { configureForTidy } from './build.mjs';
import { nothing, sum } from './counts.mjs';
import { run, which } from './exec.mjs';
import { step } from './log.mjs';
import { inParallel } from './parallel.mjs';
import { inRoot } from './paths.mjs';
import { digest, isStamped, stamp } from './stamps.mjs';

const rules = ['.clang-tidy', 'CMakeLists.txt'];

const sourcesOf = (folder) => readdirSync(inRoot(folder)).filter((name) => /\.(h|cpp)$/.test(name));
const rooms = () =>
  ['wasm/core', 'wasm/io', 'wasm/shells']
    .flatMap((folder) => [folder, ...readdirSync(inRoot(folder)).map((name) => path.join(folder, name))])
    .filter((folder) => !path.extname(folder) && sourcesOf(folder).some((name) => name.endsWith('.cpp')));

// The file and all our headers that it includes, directly or indirectly.
function reach(file, found) {
  if (found.has(file)) return;
  found.add(file);
  for (const [, name] of readFileSync(inRoot(file), 'utf8').matchAll(/^#include "(.+)"/gm))
    reach(path.join('wasm', name), found);
}

function state(room) {
  const found = new Set();
  for (const name of sourcesOf(room)) reach(path.join(room, name), found);
  return digest([...rules, ...[...found].sort()]);
}

// The combined source file that CMake has made for each folder.
function unityFiles(folder) {
  const commands = JSON.parse(readFileSync(path.join(folder, 'compile_commands.json'), 'utf8'));
  const files = commands.map(({ file }) => file).filter((file) => file.includes('/Unity/'));
  return new Map(
    files.map((file) => {
      const [, source] = /#include "(.+\/wasm\/.+)"/.exec(readFileSync(file, 'utf8')) ?? [];
      return [source && path.relative(inRoot(), path.dirname(source)), file];
    }),
  );
}

/** Numbers of passed folders, including unchanged ones, and of failed ones. */
export async function tidy() {
  const all = rooms().map((room) => ({ room, name: `tidy-${room.replaceAll('/', '-')}`, value: state(room) }));
  const waiting = all.filter(({ name, value }) => !isStamped(name, value, []));
  const unchanged = { ...nothing, passed: all.length - waiting.length };
  if (waiting.length === 0) return unchanged;
  step(`clang-tidy: ${waiting.map(({ room }) => room.replace('wasm/', '')).join(', ')}`);
  const folder = await configureForTidy();
  const files = unityFiles(folder);
  const program = which('clang-tidy-19') ?? 'clang-tidy';
  const checks = waiting.map(({ room, name, value }) => async () => {
    const args = ['--quiet', '-p', folder, files.get(room)];
    // Output of a passed run only counts warnings in third-party headers.
    const { code, tail } = await run(program, args, { allowFailure: true });
    if (code !== 0) {
      process.stderr.write(tail);
      return { ...nothing, failed: 1, names: [`clang-tidy of ${room}`] };
    }
    stamp(name, value);
    return { ...nothing, passed: 1 };
  });
  return sum([unchanged, ...(await inParallel(checks))]);
}
