// Copyright and licences of all distributed code: the npm packages in a bundle, and the libraries in the wasm module.
import { existsSync, readFileSync, readdirSync, realpathSync } from 'node:fs';
import path from 'node:path';
import { findEmscripten } from './emscripten.mjs';
import { Explained } from './log.mjs';
import { emscriptenDir, headersDir, inRoot } from './paths.mjs';

export const NOTICES = 'notices.txt';

const read = (file) => readFileSync(file, 'utf8').replaceAll('\r', '').trim();
const firstThere = (files) => files.find((file) => existsSync(file));
const section = (title, ...parts) => [`${'='.repeat(100)}\n${title}`, ...parts.filter(Boolean)].join('\n\n');

/** The npm package of a bundled module, or null. */
export function packageOf(module) {
  const [, name] = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(module.replaceAll('\\', '/')) ?? [];
  return name ?? null;
}

function ofPackage(name) {
  const folder = inRoot('node_modules', name);
  const { version, license, repository, homepage } = JSON.parse(read(path.join(folder, 'package.json')));
  const source = (repository?.url ?? homepage ?? '').replace(/^git\+/, '');
  const texts = readdirSync(folder)
    .filter((file) => /^(licen[cs]e|notice|copying)/i.test(file))
    .map((file) => read(path.join(folder, file)));
  const known = license in wholeTexts;
  if (texts.length === 0 && !known) throw new Explained(`${name} has no licence text that could be handed on`);
  return section(
    `${name} ${version}, ${license}`,
    `Source: ${source}`,
    known && 'The whole text of its licence stands at the end.',
    ...texts.filter((text) => !known || text.length < 2000),
  );
}

/** Common licence texts, from packages that are always installed. */
const wholeTexts = {
  'Apache-2.0': { title: 'Apache License, Version 2.0', file: 'typescript/LICENSE.txt' },
  'MPL-2.0': { title: 'Mozilla Public License, Version 2.0', file: 'mediabunny/LICENSE' },
};

const libraries = [
  {
    name: 'Eigen, MPL-2.0',
    source: 'https://gitlab.com/libeigen/eigen, unchanged, as the headers that the C++ sources include',
    package: 'libeigen3-dev',
    headers: ['eigen3/Eigen/Core', 'Eigen/Core'],
  },
  {
    name: 'JSON for Modern C++ (nlohmann-json), MIT',
    source: 'https://github.com/nlohmann/json',
    package: 'nlohmann-json3-dev',
    headers: ['nlohmann/json.hpp'],
  },
  {
    name: 'tinygltf, MIT',
    source: 'https://github.com/syoyo/tinygltf',
    package: 'libtinygltf-dev',
    headers: ['tiny_gltf.h', 'tinygltf/tiny_gltf.h'],
  },
];

/** The comment at the start of a header. */
function headOf(file) {
  const lines = read(file).split('\n');
  const end = lines.findIndex((line) => !/^(\/\/|\/?\*| \*|$)/.test(line));
  return lines.slice(0, end).join('\n').trim();
}

const MIT = `Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.`;

/** A library's notice from the distribution's package, or else from the header itself. */
function ofLibrary({ name, source, package: debian, headers }) {
  const document = firstThere([headersDir, '/'].map((root) => path.join(root, `usr/share/doc/${debian}/copyright`)));
  const folders = [`${headersDir}/usr/include`, '/usr/include', '/usr/local/include', '/opt/homebrew/include'];
  const header = firstThere([...folders, '/opt/local/include'].flatMap((f) => headers.map((h) => path.join(f, h))));
  if (!document && !header)
    throw new Explained(`no copyright of ${name} was found: neither its package's nor its header`);
  const ownMit = name.endsWith('MIT') && !document && !headOf(header).includes('Permission is hereby granted');
  return section(name, `Source: ${source}`, document ? read(document) : headOf(header), ownMit && MIT);
}

/** The part of a Debian copyright file about the compiled code, without tests and tools. */
function compiledIn(copyright) {
  const stanzas = copyright.split(/\n(?:[ \t]*\n)+/);
  const filesOf = (stanza) => /^Files:((?:.|\n[ \t])*)/m.exec(stanza)?.[1].trim().split(/\s+/) ?? [];
  const isIn = (file) => file === '*' || file.startsWith('system/lib/') || file.startsWith('src/');
  const used = stanzas.filter((stanza) => filesOf(stanza).some(isIn));
  const licences = used.flatMap(
    (stanza) =>
      /^License:(.*)$/m
        .exec(stanza)?.[1]
        .trim()
        .split(/ (?:or|and|with) /) ?? [],
  );
  const texts = stanzas.filter((stanza) => {
    const [, name] = /^License:[ \t]*(\S+)/.exec(stanza) ?? [];
    return name !== undefined && licences.includes(name);
  });
  return [...used, ...texts].join('\n\n');
}

/** Emscripten's own libraries: C (musl), C++ and its runtime (LLVM), memory, and the script around the module. */
function ofEmscripten() {
  const found = findEmscripten();
  const folder = found ? path.dirname(realpathSync(found.emcc)) : path.join(emscriptenDir, 'usr/share/emscripten');
  const below = (place) => (existsSync(place) ? readdirSync(place).map((name) => path.join(place, name)) : []);
  const documents = [emscriptenDir, '/'].map((root) => path.join(root, 'usr/share/doc/emscripten/copyright'));
  const document = firstThere(documents);
  const own = [
    folder,
    ...below(path.join(folder, 'system/lib')),
    ...below(path.join(folder, 'system/lib/libc')),
  ].flatMap((place) =>
    ['LICENSE', 'LICENSE.TXT', 'LICENSE.txt', 'COPYRIGHT'].map((n) => path.join(place, n)).filter(existsSync),
  );
  if (!document && own.length === 0)
    throw new Explained(`no copyright of Emscripten's libraries was found in ${folder}`);
  return section(
    'Emscripten with its C and C++ libraries: musl, libc++, libc++abi, compiler-rt, dlmalloc',
    'Source: https://github.com/emscripten-core/emscripten',
    document && compiledIn(read(document)),
    ...own.map((file) => `${path.relative(folder, file)}:\n\n${read(file)}`),
  );
}

/** The text for a bundle with these npm packages and the wasm module. */
export function notices(packages) {
  const whole = Object.values(wholeTexts).map(({ title, file }) => section(title, read(inRoot('node_modules', file))));
  const parts = [
    'shapespline contains the works below. Their notices and licences follow its own.',
    section('shapespline, MIT', read(inRoot('LICENSE'))),
    ...[...new Set(packages)].sort().map(ofPackage),
    ...libraries.map(ofLibrary),
    ofEmscripten(),
    ...whole,
  ];
  return `${parts.join('\n\n')}\n`;
}
