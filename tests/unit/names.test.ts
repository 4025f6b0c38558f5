/** The lint of names finds private words in identifiers and file names, and ignores comments and strings. */
import { expect, it } from 'vitest';
import { privateNamesIn, wordsOf } from '../../wasm/toolchain/names.mjs';

const found = (file: string, source = ''): [number, string][] =>
  privateNamesIn(file, source).map(({ line, name }) => [line, name]);

it('splits a name of any style into words', () => {
  for (const name of ['readTruth', 'ReadTruth_', 'READ_TRUTH', 'read-truth']) expect(wordsOf(name)).toBe('read truth');
  expect(wordsOf('isGLBTruth2')).toBe('is glb truth2');
});

it('finds private words in identifiers and file names', () => {
  expect(found('web/cli/doubts.ts')).toEqual([[0, 'doubts.ts']]);
  expect(found('a.ts', 'const MAX = 1;\nconst MOST_KEYS = 2;')).toEqual([[2, 'MOST_KEYS']]);
  expect(found('a.cpp', 'int leastStep = readTruth();')).toEqual([
    [1, 'leastStep'],
    [1, 'readTruth'],
  ]);
  expect(found('a.ts', 'say(`the truth $' + '{whyNoLengths(doc)}`)')).toEqual([[1, 'whyNoLengths']]);
});

it('leaves other words, comments and strings alone', () => {
  expect(found('a.ts', "// the least_truth\nconst most = 'MOST_KEYS' + atLeast + wholeTurn;")).toEqual([]);
  expect(found('a.css', '.time-peek { color: red }')).toEqual([]);
});
