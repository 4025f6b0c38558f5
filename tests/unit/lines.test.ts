import { expect, it } from 'vitest';
import { codeLines, languageOf } from '../../wasm/toolchain/lines.mjs';

it.each([
  ['one;\n\n  \ntwo;\n', 'C++', 2],
  ['// no\n/* no\n no */ yes;\nyes; // no\n/* no */\n', 'C++', 2],
  ['const url = "http://a"; // no\nconst b = \'/*\';\nyes;\n', 'TypeScript', 3],
  ['const t = `a\n// part of the text\n\n`;\n', 'TypeScript', 3],
  ["const t = 'it\\'s'; /* no\nno */\n", 'TypeScript', 1],
  ['<!-- no\n no -->\n<p title="it\'s">yes</p>\n', 'HTML', 1],
  ['# no\nset(a "#b")\n', 'CMake', 1],
])('lines of code in %j', (text, language, count) => {
  expect(codeLines(text, language)).toBe(count);
});

it('file names determine languages', () => {
  const files = ['a/CMakeLists.txt', 'a.h', 'b.test.ts', 'c.mjs', 'README.md', 'd.png'];
  expect(files.map(languageOf)).toEqual(['CMake', 'C++', 'TypeScript', 'TypeScript', undefined, undefined]);
});
