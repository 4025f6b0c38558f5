// System requirements of scripts, their detection and their installation.
import { existsSync } from 'node:fs';
import path from 'node:path';
import { installPackages, unpackPackages, whyNoInstall } from './apt.mjs';
import { hasBrowser } from './chromium.mjs';
import { emccTooOld, findEmscripten, oldestVersion, unpackEmscripten } from './emscripten.mjs';
import { which } from './exec.mjs';
import { Explained } from './log.mjs';
import { headersDir } from './paths.mjs';

const includeFolders = [
  `${headersDir}/usr/include`,
  '/usr/include',
  '/usr/local/include',
  '/opt/homebrew/include',
  '/opt/local/include',
];
const hasHeader = (...names) => includeFolders.some((f) => names.some((name) => existsSync(path.join(f, name))));

const headers = [
  { name: 'Eigen 3.4', files: ['Eigen/Core', 'eigen3/Eigen/Core'], package: 'libeigen3-dev' },
  { name: 'tinygltf 2.8 or newer', files: ['tiny_gltf.h', 'tinygltf/tiny_gltf.h'], package: 'libtinygltf-dev' },
  { name: 'nlohmann-json 3', files: ['nlohmann/json.hpp'], package: 'nlohmann-json3-dev' },
  { name: 'doctest 2.4', files: ['doctest/doctest.h'], package: 'doctest-dev' },
];

const onPath = (...names) => names.some((name) => which(name));

const clangWithRuntime = ['clang-19', 'libclang-rt-19-dev'];
const hasClangWithRuntime = () => onPath('clang++-19') && existsSync('/usr/lib/llvm-19/lib/clang/19/lib/linux');

/** Each has `name` and `hint` for users, `has()`, and Debian `packages` or its own `install()`. */
const all = {
  emscripten: {
    get name() {
      return `Emscripten ${oldestVersion.join('.')} or newer (emcc on PATH${emccTooOld()})`;
    },
    hint: 'https://emscripten.org/docs/getting_started/downloads.html; macOS: brew install emscripten; Debian 13: apt-get install emscripten',
    has: () => findEmscripten() !== null,
    packages: ['clang-19', 'lld-19', 'llvm-19', 'python3'],
    install: unpackEmscripten,
  },
  headers: {
    get name() {
      const missing = headers.filter(({ files }) => !hasHeader(...files)).map(({ name }) => name);
      return `${missing.join(', ')} (C++ headers)`;
    },
    hint: `Debian 13: apt-get install ${headers.map((h) => h.package).join(' ')}; macOS: brew install eigen tinygltf nlohmann-json doctest`,
    has: () => headers.every(({ files }) => hasHeader(...files)),
    packages: [],
    install: () =>
      unpackPackages(
        headers.map((h) => h.package),
        headersDir,
      ),
  },
  cmake: {
    name: 'CMake 3.20 or newer',
    hint: 'https://cmake.org/download; macOS: brew install cmake; Debian: apt-get install cmake',
    has: () => onPath('cmake'),
    packages: ['cmake'],
  },
  ninja: {
    name: 'Ninja',
    hint: 'https://ninja-build.org; macOS: brew install ninja; Debian: apt-get install ninja-build',
    has: () => onPath('ninja'),
    packages: ['ninja-build'],
  },
  compiler: {
    name: 'a native C++20 compiler (g++ 12 or clang++ 14 or newer)',
    hint: 'Debian: apt-get install g++; macOS: xcode-select --install',
    has: () => onPath('c++', 'g++', 'clang++'),
    packages: ['g++'],
  },
  chromium: {
    name: 'Chromium',
    hint: 'npm ci && npx playwright install chromium; Debian: apt-get install chromium-headless-shell',
    has: hasBrowser,
    packages: ['chromium-headless-shell', 'fonts-liberation'],
  },
  formatter: {
    name: 'clang-format 19',
    hint: 'Debian: apt-get install clang-format-19; macOS: brew install clang-format',
    has: () => onPath('clang-format-19', 'clang-format'),
    packages: ['clang-format-19'],
  },
  tidy: {
    name: 'clang-tidy 19',
    hint: 'Debian: apt-get install clang-tidy-19; macOS: brew install llvm',
    has: () => onPath('clang-tidy-19', 'clang-tidy'),
    packages: ['clang-tidy-19'],
  },
  sanitizers: {
    name: 'clang 19 with its sanitizers (clang++-19 on PATH, or the compiler that CXX names)',
    hint: 'Debian: apt-get install clang-19 libclang-rt-19-dev; elsewhere: CXX=g++ or CXX=clang++',
    has: () => Boolean(process.env.CXX) || hasClangWithRuntime(),
    packages: clangWithRuntime,
  },
  fuzzer: {
    name: 'clang 19 with libFuzzer',
    hint: 'Debian: apt-get install clang-19 libclang-rt-19-dev',
    has: hasClangWithRuntime,
    packages: clangWithRuntime,
  },
};

export const forWasm = ['emscripten', 'headers', 'cmake', 'ninja'];
export const forNative = ['headers', 'cmake', 'ninja', 'sanitizers'];
export const forBench = [...forWasm, 'compiler'];
export const forBrowser = ['chromium'];
export const forFormatting = ['formatter'];
export const forTidying = ['tidy', ...forNative];
export const forFuzzing = ['headers', 'cmake', 'ninja', 'fuzzer'];

/** The requirements among `names` that are not met. */
export function missing(names) {
  return [...new Set(names)].map((name) => all[name]).filter((requirement) => !requirement.has());
}

/** One message with each missing requirement and its installation. */
function explain(reason, things) {
  const list = things.map(({ name, hint }) => `  - ${name}\n      ${hint}`);
  return new Explained(`shapespline cannot be built here yet (${reason}). Missing:\n${list.join('\n')}`);
}

/** Fails with one message if a missing requirement cannot be installed. `extra` is checked as well. */
export function checkInstallable(names, extra) {
  const reason = whyNoInstall();
  const things = [...missing(names), ...extra];
  if (reason && things.length > 0) throw explain(reason, things);
}

/** Installs missing requirements: system packages together, then packages unpacked into the repository. */
export async function installMissing(names) {
  const things = missing(names);
  const packages = [...new Set(things.flatMap((thing) => thing.packages))];
  if (packages.length > 0) await installPackages(packages);
  for (const thing of things) if (!thing.has()) await thing.install?.();
  const left = missing(names);
  if (left.length > 0) throw explain('installing did not help', left);
}
