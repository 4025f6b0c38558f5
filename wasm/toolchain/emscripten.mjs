// Finds Emscripten, or assembles Debian's packages of it in a folder of the repository.
import { chmodSync, existsSync, mkdirSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { unpackPackages } from './apt.mjs';
import { capture, which } from './exec.mjs';
import { Explained } from './log.mjs';
import { emscriptenDir, inRoot, toolchainDir } from './paths.mjs';

export const oldestVersion = [3, 1, 50];
const llvmBin = '/usr/lib/llvm-19/bin';
const complete = path.join(emscriptenDir, 'complete');

function isOldEnough(version) {
  const parts = version.split('.').map(Number);
  const difference = oldestVersion.map((least, i) => (parts[i] ?? 0) - least).find((d) => d !== 0) ?? 0;
  return difference >= 0;
}

function versionOf(emcc) {
  return capture(emcc, ['--version'])?.match(/\b(\d+\.\d+\.\d+)/)?.[1] ?? null;
}

/** Emscripten on PATH; quick, for stamps. */
export const emccOnPath = () => which('emcc') ?? 'unpacked';

function unpackedEnvironment() {
  const bin = path.join(emscriptenDir, 'usr/share/emscripten');
  return {
    EM_CONFIG: path.join(emscriptenDir, 'config'),
    PATH: [bin, process.env.PATH].join(path.delimiter),
  };
}

/** The problem with the emcc on PATH, for messages; '' if there is none. */
export function emccTooOld() {
  const onPath = which('emcc');
  return onPath ? `; ${onPath} is ${versionOf(onPath) ?? 'broken'}` : '';
}

/** The Emscripten to use, `{ emcc, version, env }`, or null. One on PATH takes precedence if it is new enough. */
export function findEmscripten() {
  const onPath = which('emcc');
  const version = onPath && versionOf(onPath);
  if (version && isOldEnough(version)) {
    return { emcc: onPath, version, env: {} };
  }
  const programs = ['clang', 'wasm-ld', 'llvm-ar'].map((name) => path.join(llvmBin, name));
  if (![complete, ...programs].every((file) => existsSync(file)) || !which('python3')) return null;
  const env = unpackedEnvironment();
  return { emcc: path.join(emscriptenDir, 'usr/share/emscripten/emcc'), version: '', env };
}

// Binaryen needs a newer C library, which is unpacked next to it.
function wrapBinaryen(folder) {
  const real = path.join(folder, 'usr/bin');
  const wrappers = path.join(folder, 'binaryen/bin');
  const loader = ['lib64', 'usr/lib64', 'lib', 'usr/lib']
    .flatMap((lib) =>
      existsSync(path.join(folder, lib)) ? readdirSync(path.join(folder, lib)).map((f) => `${lib}/${f}`) : [],
    )
    .find((file) => /\/ld-linux-[^/]*\.so\.\d+$/.test(file));
  const libraries = readdirSync(path.join(folder, 'usr/lib')).find((name) => name.endsWith('-linux-gnu'));
  if (!loader || !libraries) throw new Explained('the downloaded C library has no program loader');
  mkdirSync(wrappers, { recursive: true });
  for (const name of readdirSync(real).filter((n) => n.startsWith('wasm'))) {
    const text = [
      '#!/bin/sh',
      'here=$(dirname "$0")/../..',
      `exec "$here/${loader}" --library-path "$here/usr/lib/${libraries}" "$here/usr/bin/${name}" "$@"`,
    ];
    writeFileSync(path.join(wrappers, name), `${text.join('\n')}\n`);
    chmodSync(path.join(wrappers, name), 0o755);
  }
}

// Emscripten evaluates this as Python, with EM_CONFIG as its path, so the folder can be moved.
function writeConfig(folder) {
  const lines = [
    'import os',
    "here = os.path.dirname(os.environ['EM_CONFIG'])",
    `LLVM_ROOT = '${llvmBin}'`,
    "BINARYEN_ROOT = here + '/binaryen'",
    `NODE_JS = '${process.execPath}'`,
    "CACHE = here + '/usr/share/emscripten/cache'",
    'FROZEN_CACHE = False',
    "LLVM_ADD_VERSION = ''",
    "CLANG_ADD_VERSION = ''",
  ];
  writeFileSync(path.join(folder, 'config'), `${lines.join('\n')}\n`);
}

// A script for users that adds it to PATH.
function writeShellEnvironment() {
  const lines = [
    `export EM_CONFIG='${path.join(emscriptenDir, 'config')}'`,
    `export PATH='${path.join(emscriptenDir, 'usr/share/emscripten')}':"$PATH"`,
  ];
  writeFileSync(path.join(toolchainDir, 'env.sh'), `${lines.join('\n')}\n`);
}

// Emscripten's script expects this package in its own folder, unlike Debian. A link works even while `npm ci` is
// running.
function addAcorn(folder) {
  const modules = 'usr/share/emscripten/node_modules';
  mkdirSync(path.join(folder, modules), { recursive: true });
  const link = path.join(folder, modules, 'acorn');
  rmSync(link, { recursive: true, force: true });
  symlinkSync(path.relative(path.join(emscriptenDir, modules), inRoot('node_modules/acorn')), link);
}

/** Unpacks Debian 13's Emscripten. Requires clang-19, lld-19, llvm-19 and python3 in the system. */
export async function unpackEmscripten() {
  const packages = ['emscripten', 'binaryen', 'libc6', 'libstdc++6', 'libgcc-s1'];
  await unpackPackages(packages, emscriptenDir, (folder) => {
    wrapBinaryen(folder);
    writeConfig(folder);
    addAcorn(folder);
    // Its scripts are CommonJS, whatever this repository's package.json says.
    writeFileSync(path.join(folder, 'package.json'), '{ "type": "commonjs" }\n');
    writeFileSync(path.join(folder, 'complete'), '');
  });
  writeShellEnvironment();
}
