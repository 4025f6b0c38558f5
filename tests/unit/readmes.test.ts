/** Files and folders named in documents exist, and READMEs are short. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';

const root = path.resolve(import.meta.dirname, '../..');
const files = execFileSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
  cwd: root,
  encoding: 'utf8',
}).split('\n');

/** Every file and folder, with and without extension. */
const known = new Set<string>();
for (const file of files.filter(Boolean)) {
  for (const name of [file, file.replace(/(\.(test|spec))?\.\w+$/, '')]) known.add(name);
  for (let folder = path.dirname(file); folder !== '.'; folder = path.dirname(folder)) known.add(folder);
}

/** Made by the build, or outside the repository. */
const ELSEWHERE = /^(build|dist|\.toolchain|tests\/fuzz\/found|\.\.\/shared)\b/;
/** Text in backticks that is a path, or a file name in the first column of a table. */
function namedIn(document: string): string[] {
  const text = readFileSync(path.join(root, document), 'utf8').replace(/```[\s\S]*?```/g, '');
  const spans = (of: string): string[] => Array.from(of.matchAll(/`([\w.-]+(?:\/[\w.-]+)*\/?)`/g), ([, name]) => name!);
  const firstCells = Array.from(text.matchAll(/^\| *((?:`[^`|]+`(?:, )?)+) *\|/gm), ([, cell]) => cell!);
  return [...new Set([...spans(text).filter((name) => name.includes('/')), ...firstCells.flatMap(spans)])];
}

/** Relative to the document's folder, a subfolder, the root, or the core that the main README describes. */
function isThere(name: string, folder: string): boolean {
  const clean = name.replace(/\/$/, '');
  const candidates = [path.join(folder, clean), clean, path.join('wasm/core', clean)];
  return (
    candidates.some((one) => known.has(one)) ||
    [...known].some((one) => one.startsWith(folder) && one.endsWith(`/${clean}`))
  );
}

describe('documents name what is there', () => {
  const documents = files.filter((file) => /(?<!CHANGELOG)\.md$/.test(file) && !file.includes('bench/results/'));
  it.each(documents)('%s', (document) => {
    const folder = path.dirname(document) === '.' ? '' : path.dirname(document);
    const made = (name: string): boolean => [name, path.join(folder, name)].some((one) => ELSEWHERE.test(one));
    const missing = namedIn(document).filter((name) => !made(name) && !isThere(name, folder));
    expect(missing).toEqual([]);
  });
});

/** The main README, and the one shown by npm. */
const FOR_USERS = ['README.md', 'web/package/README.md'];
const MAX_LINES = 60;

describe(`READMEs have at most ${MAX_LINES} lines, generated tables aside`, () => {
  it.each(files.filter((file) => file.endsWith('/README.md') && !FOR_USERS.includes(file)))('%s', (readme) => {
    // Generated tables are between two equal markers.
    const text = readFileSync(path.join(root, readme), 'utf8').replace(/(<!-- \w+ -->)[\s\S]*?\1/g, '');
    expect(text.trimEnd().split('\n').length).toBeLessThanOrEqual(MAX_LINES);
  });
});
