/** The lint of words finds banned words in texts and comments, and ignores names in code. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { bannedIn, EXCEPTIONS } from '../../wasm/toolchain/words.mjs';

const root = path.resolve(import.meta.dirname, '../..');
const found = (file: string, source: string): [number, string][] =>
  bannedIn(file, source).map(({ line, words }) => [line, words]);

it('finds a banned word in comments, strings, templates and documents, with its line', () => {
  expect(found('a.ts', 'let a;\n// Nobody hears.\n')).toEqual([
    [2, 'Nobody'],
    [2, 'hears'],
  ]);
  expect(found('a.cpp', 'throw Error("the page is told " + name);')).toEqual([[1, 'is told']]);
  expect(found('a.mjs', 'log(`$' + '{count} faces, so many`);')).toEqual([[1, 'so many']]);
  expect(found('a.md', 'One.\nBesides, two.')).toEqual([[2, 'Besides']]);
  expect(found('CMakeLists.txt', 'set(A 1) # anew')).toEqual([[1, 'anew']]);
  expect(found('public/a.json', '{\n"anew": "It starts anew." }')).toEqual([[2, 'anew']]);
});

it('finds a phrase that continues on the next line of a comment', () => {
  expect(found('a.h', '// It stays, so\n// that it is there.\n')).toEqual([[1, 'so that']]);
  expect(found('a.ts', '/**\n * It is used no\n * more.\n */')).toEqual([[2, 'no more']]);
});

it('leaves names, paths, single words in quotes and code spans alone', () => {
  expect(found('a.ts', "const anew = hears('besides');\nconst no = 1; more();")).toEqual([]);
  expect(found('a.md', 'See `anew` and [this](docs/anew.md).')).toEqual([]);
  expect(found('a.bin', 'nobody')).toEqual([]);
  expect(found('tests/a.json', '["for nobody else"]')).toEqual([]);
});

it('has at most 20 exceptions, each used and with a reason', () => {
  expect(EXCEPTIONS.length).toBeLessThanOrEqual(20);
  for (const { file, words, why } of EXCEPTIONS) {
    expect(why, file).toMatch(/\w+ \w+/);
    const source = readFileSync(path.join(root, file), 'utf8');
    expect(
      bannedIn(file, source).some((one) => words.test(one.words)),
      file,
    ).toBe(true);
  }
});
