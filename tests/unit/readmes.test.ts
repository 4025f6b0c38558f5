/** Files and folders that READMEs name are there. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../..');
const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
  cwd: root,
  encoding: 'utf8',
}).split('\n');

/** Every file and folder, and files without their extensions. */
const known = new Set<string>();
for (const file of files.filter(Boolean)) {
  for (const name of [file, file.replace(/(\.(test|spec))?\.\w+$/, '')]) known.add(name);
  for (let folder = path.dirname(file); folder !== '.'; folder = path.dirname(folder)) known.add(folder);
}

/** Made by the build, or outside of the repository. */
const ELSEWHERE = /^(build|dist|\.toolchain|tests\/fuzz\/found|\.\.\/shared)\b/;
/** Text in backticks that is a path, and in the first column of a table the name of a file. */
function namedIn(readme: string): string[] {
  const text = readFileSync(path.join(root, readme), 'utf8').replace(/```[\s\S]*?```/g, '');
  const spans = (of: string): string[] => Array.from(of.matchAll(/`([\w.-]+(?:\/[\w.-]+)*\/?)`/g), ([, name]) => name!);
  const firstCells = Array.from(text.matchAll(/^\| *((?:`[^`|]+`(?:, )?)+) *\|/gm), ([, cell]) => cell!);
  return [...new Set([...spans(text).filter((name) => name.includes('/')), ...firstCells.flatMap(spans)])];
}

/** Seen from the README's folder, from a folder in it, from the root, or from the core that the main README maps. */
function isThere(name: string, folder: string): boolean {
  const clean = name.replace(/\/$/, '');
  const candidates = [path.join(folder, clean), clean, path.join('wasm/core', clean)];
  return (
    candidates.some((one) => known.has(one)) ||
    [...known].some((one) => one.startsWith(folder) && one.endsWith(`/${clean}`))
  );
}

describe('READMEs name what is there', () => {
  it.each(files.filter((file) => /(^|\/)(README|CONTRIBUTING)\.md$/.test(file)))('%s', (readme) => {
    const folder = path.dirname(readme) === '.' ? '' : path.dirname(readme);
    const made = (name: string): boolean => [name, path.join(folder, name)].some((one) => ELSEWHERE.test(one));
    const missing = namedIn(readme).filter((name) => !made(name) && !isThere(name, folder));
    expect(missing).toEqual([]);
  });
});
