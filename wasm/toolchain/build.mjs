// The steps of a build. Each has `isCurrent()`, which is quick and silent, and `make()`.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { emccOnPath, findEmscripten } from './emscripten.mjs';
import { run } from './exec.mjs';
import { step } from './log.mjs';
import { NOTICES, notices, packageOf } from './notices.mjs';
import { buildPackage } from './npm-package.mjs';
import { cores } from './parallel.mjs';
import { buildDir, inRoot } from './paths.mjs';
import { digest, isStamped, stamp } from './stamps.mjs';
import { wasmStaysOutside } from './wasm-outside.mjs';

const node = process.execPath;
const jobs = String(cores);
// Compiles sanitized code in two thirds of g++'s time.
const sanitizing = process.env.CXX ?? 'clang++-19';

// Compiles all files of a folder together, because most time is spent parsing headers of other folders.
const wholeRooms = '-DSHAPESPLINE_WHOLE_ROOMS=ON';

// A build folder is for one compiler; another compiler starts with an empty folder.
function useFolder(folder, compiler) {
  const note = path.join(folder, 'compiler');
  if (existsSync(folder) && (!existsSync(note) || readFileSync(note, 'utf8') !== compiler))
    rmSync(folder, { recursive: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(note, compiler);
}

async function configure({ folder, compiler, wrap = [], options = [], env }) {
  useFolder(folder, compiler);
  const [program, ...args] = [...wrap, 'cmake', '-S', inRoot(), '-B', folder, '-G', 'Ninja', ...options];
  await run(program, args, { env });
}

async function cmake({ folder, targets, env, ...how }) {
  await configure({ folder, env, ...how });
  await run('cmake', ['--build', folder, '-j', jobs, '--target', ...targets], { env, show: 'all' });
}

/** Builds targets with Emscripten in build/cmake-wasm. */
export async function buildWasm(targets) {
  const { emcc, version, env } = findEmscripten();
  step(`building ${targets.join(' and ')} with Emscripten${version ? ` ${version}` : ''}`);
  const folder = path.join(buildDir, 'cmake-wasm');
  const emcmake = path.join(path.dirname(emcc), 'emcmake');
  await cmake({ folder, compiler: `${emcc} ${version}`, wrap: [emcmake], options: [wholeRooms], targets, env });
  return folder;
}

/** Builds the native tests under sanitizers in build/cmake-native. */
export async function buildNative(targets) {
  step(`building ${targets.join(' and ')} with ${sanitizing}`);
  const folder = path.join(buildDir, 'cmake-native');
  const options = ['-DSHAPESPLINE_SANITIZE=ON', wholeRooms, `-DCMAKE_CXX_COMPILER=${sanitizing}`];
  await cmake({ folder, compiler: sanitizing, options, targets });
  return folder;
}

/** Builds optimised native programs in build/cmake-release. */
export async function buildRelease(targets) {
  step(`building ${targets.join(' and ')} with the system's compiler`);
  const folder = path.join(buildDir, 'cmake-release');
  await cmake({ folder, compiler: process.env.CXX ?? '', options: ['-DBUILD_TESTING=OFF'], targets });
  return folder;
}

/**
 * Writes compile commands of each native library to build/cmake-tidy, without precompiled headers, which only one
 * compiler can read.
 */
export async function configureForTidy() {
  const folder = path.join(buildDir, 'cmake-tidy');
  const alone = ['-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON', '-DBUILD_TESTING=OFF'];
  const options = [...alone, wholeRooms, `-DCMAKE_CXX_COMPILER=${sanitizing}`];
  await configure({ folder, compiler: sanitizing, options });
  return folder;
}

/** Builds the fuzz targets in build/cmake-fuzz. */
export async function buildFuzzers(targets) {
  step(`building ${targets.join(', ')}`);
  const folder = path.join(buildDir, 'cmake-fuzz');
  const options = ['-DSHAPESPLINE_FUZZ=ON', '-DBUILD_TESTING=OFF', '-DCMAKE_CXX_COMPILER=clang++-19'];
  await cmake({ folder, compiler: 'clang++-19', options, targets });
  return folder;
}

const wasmInputs = ['CMakeLists.txt', 'wasm/core', 'wasm/io', 'wasm/shells', 'wasm/bindings', 'tests/shapes'];
const wasmModules = ['shapespline', 'shapespline_threads', 'shapespline_files', 'shapespline_shells'];
const wasmOutputs = wasmModules.flatMap((name) => [`build/wasm/${name}.mjs`, `build/wasm/${name}.wasm`]);

/** A step with a digest of its inputs. The digest is computed before the step runs, so later edits count as changes. */
function guarded(name, value, outputs, action) {
  return {
    isCurrent: () => isStamped(name, value(), outputs),
    async make() {
      const before = value();
      await action();
      stamp(name, before);
    },
  };
}

export const wasmModule = guarded(
  'wasm',
  () => digest(wasmInputs, emccOnPath()),
  wasmOutputs,
  async () => {
    await buildWasm([...wasmModules, 'shapespline_meshes']);
  },
);

const noticeInputs = ['wasm/toolchain/notices.mjs', 'LICENSE'];

export const page = guarded(
  'page',
  () => digest(['web', 'public', 'build/wasm', 'build/package', 'package-lock.json', ...noticeInputs]),
  ['dist/index.html'],
  async () => {
    step('building the page');
    await run(node, [inRoot('node_modules/vite/bin/vite.js'), 'build', '--config', 'web/vite.config.ts'], {
      show: 'all',
    });
  },
);

// Bundles programs for Node, which cannot run the TypeScript sources.
async function bundle(entries) {
  const { build } = await import('esbuild');
  const { metafile } = await build({
    metafile: true,
    entryPoints: entries.filter(({ in: file }) => existsSync(file)),
    outdir: inRoot('build/node'),
    outExtension: { '.js': '.mjs' },
    bundle: true,
    platform: 'node',
    target: 'node20',
    format: 'esm',
    sourcemap: true,
    // The decoders of compressed meshes stay separate packages, loaded when a file needs them.
    packages: 'external',
    external: ['../../wasm/toolchain/*'],
    plugins: [wasmStaysOutside],
    logLevel: 'warning',
  });
  return metafile;
}

// The notices include these packages, because the bundle needs them.
function writeNotices({ outputs }) {
  const external = Object.values(outputs).flatMap(({ imports }) => imports.filter((one) => one.external));
  const names = external.map((one) => packageOf(`/node_modules/${one.path}/`));
  const packages = names.filter((name) => existsSync(inRoot('node_modules', name ?? '.', 'package.json')));
  writeFileSync(inRoot('build/node', NOTICES), notices(packages));
}

const entry = (out, file) => ({ out, in: inRoot(file) });
const engineEntries = [
  entry('node-worker', 'web/engine/worker/node-worker.ts'),
  entry('second-thread-node', 'web/engine/worker/second-thread-node.ts'),
];

export const nodeBundle = guarded(
  'node-bundle',
  () => digest(['web/engine', 'web/study', 'web/cli', 'package.json', 'package-lock.json', ...noticeInputs]),
  ['build/node/cli.mjs', 'build/node/second-thread-node.mjs', `build/node/${NOTICES}`],
  async () => writeNotices(await bundle([entry('cli', 'web/cli/main.ts'), ...engineEntries])),
);

export const npmPackage = guarded(
  'npm-package',
  () =>
    digest([
      'web',
      'build/wasm',
      'CHANGELOG.md',
      'package.json',
      'package-lock.json',
      'wasm/toolchain/npm-package.mjs',
      'wasm/toolchain/npm-manifest.mjs',
      'wasm/toolchain/element-types.mjs',
      ...noticeInputs,
    ]),
  ['build/package/package.json'],
  async () => {
    step('building the npm package');
    await buildPackage();
  },
);

// CHOLMOD is compiled in if installed, even later.
const hasCholmod = () =>
  ['/usr/include/suitesparse', '/usr/include'].some((folder) => existsSync(`${folder}/cholmod.h`));

export const benchPrograms = guarded(
  'bench-programs',
  () =>
    digest(
      [...wasmInputs, 'tests/bench/native', 'tests/bench/wasm'],
      `${emccOnPath()} ${process.env.CXX ?? ''} ${hasCholmod()}`,
    ),
  ['build/cmake-release/shapespline_bench_native', 'build/cmake-wasm/shapespline_bench_read.wasm'],
  async () => {
    await buildRelease(['shapespline_bench_native']);
    await buildWasm(['shapespline_bench_read']);
  },
);

export const benchBundle = guarded(
  'bench-bundle',
  () => digest(['web/engine', 'tests/bench', 'package.json', 'package-lock.json']),
  ['build/node/bench.mjs', 'build/node/load-babylon.mjs'],
  () =>
    bundle([
      entry('bench', 'tests/bench/main.ts'),
      entry('load-babylon', 'tests/bench/load-babylon.ts'),
      ...engineEntries,
    ]),
);

export const fuzzBundle = guarded(
  'fuzz-bundle',
  () => digest(['web/engine', 'tests/fuzz', 'tests/engine/support', 'package.json', 'package-lock.json']),
  ['build/node/fuzz-decoders.mjs'],
  () => bundle([entry('fuzz-decoders', 'tests/fuzz/decoders.ts')]),
);
