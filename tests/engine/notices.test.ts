/** Distributed files state their authors and licences. */
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { notices } from '../../wasm/toolchain/notices.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const text = (file: string): string => readFileSync(`${repository}${file}`, 'utf8');

/** Packages that the sources of these folders import at run time. */
function importedIn(...folders: string[]): string[] {
  const files = folders.flatMap((folder) =>
    readdirSync(`${repository}${folder}`, { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.ts'))
      .map((name) => `${folder}/${name}`),
  );
  const specifiers = files.flatMap((file) =>
    Array.from(text(file).matchAll(/(?:^import (?!type\b)[^;]*?from |import\()'([^'.][^']*)'/gms), ([, name]) => name!),
  );
  const names = specifiers.filter((name) => !name.startsWith('node:') && !name.startsWith('data:'));
  return [...new Set(names.map((name) => name.split('/', name.startsWith('@') ? 2 : 1).join('/')))];
}

it('the notices of the command line name its packages and the libraries in the module', () => {
  const made = text('build/node/notices.txt');
  const packages = importedIn('web/engine', 'web/cli', 'web/study');
  expect(packages).toEqual(expect.arrayContaining(['draco3dgltf', 'meshoptimizer', '@gltf-transform/core']));
  for (const name of packages) expect(made).toMatch(new RegExp(`^${name} \\d`, 'm'));
});

it('notices contain the full licence texts and the locations of sources', () => {
  const made = notices(importedIn('web'));
  for (const name of ['three', 'draco3dgltf', 'meshoptimizer', 'idb-keyval', 'client-zip', 'mediabunny'])
    expect(made).toMatch(new RegExp(`^${name} \\d`, 'm'));
  for (const words of [
    text('LICENSE').trim(),
    'https://gitlab.com/libeigen/eigen',
    'Mozilla Public License Version 2.0',
    'Version 2.0, January 2004',
    'Niels Lohmann',
    'Syoyo Fujita',
    'The Emscripten Authors',
    'musl',
    'LLVM',
  ])
    expect(made).toContain(words);
});
