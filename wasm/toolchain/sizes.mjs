// Compressed download sizes with their limits: until the first image of a first visit, and of wasm modules loaded
// later. A build that exceeds a limit fails.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { Explained } from './log.mjs';

/**
 * Bytes after gzip: the page with its initial style, scripts and wasm; and modules by name, without the bundler's
 * suffix.
 */
export const LIMITS = {
  firstPicture: 685_800,
  shapespline_threads: 396_500,
  shapespline_files: 300_000,
  shapespline_shells: 150_000,
};

/**
 * Download size of each npm package script with its static imports; for the element, in addition to the engine. Bytes
 * after gzip.
 */
export const PACKAGE_LIMITS = {
  'index.js': 24_000,
  'worker.js': 26_500,
  'codecs.js': 98_000,
  'element.js': 40_000,
  'element-class.js': 40_000,
  'canvas-viewer.js': 40_000,
  'cdn.js': 260_000,
};
/** These also count dynamic imports, which come with the first shape. */
const BESIDE_ENGINE = ['element.js', 'element-class.js', 'canvas-viewer.js'];

// Import statements in exactly the forms that the bundler writes.
const NOW = [/(?:from|import)\s*["']\.\/([^"']+\.js)["']/g, /new URL\(\s*["'](?:\.\/)?([^"']+\.(?:js|wasm))["']/g];
const LATER = [/import\(\s*["']\.\/([^"']+\.js)["']\s*\)/g];

const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;
const found = (text, patterns) => patterns.flatMap((pattern) => [...text.matchAll(pattern)].map(([, name]) => name));

const gzipped = (folder, names) =>
  [...names].reduce((sum, name) => sum + gzipSync(readFileSync(path.join(folder, name))).length, 0);

const KINDS = { js: 'JavaScript', wasm: 'wasm', css: 'style', html: 'page' };
const kindOf = (name) => KINDS[name.split('.').pop()];

/**
 * Its URL is in the first script (web/engine/browser-files.ts). tests/e2e/start.spec.ts checks that it is loaded later.
 */
const isLaterModule = (name) => /^shapespline_\w+-.*\.wasm$/.test(name);

/** The built page, its initial files, and all other files with code, with their sizes after gzip. */
export function sizesOf(folder, page = 'index.html') {
  const assets = path.join(folder, 'assets');
  const html = readFileSync(path.join(folder, page), 'utf8');
  const start = new Set();
  const waiting = [...html.matchAll(/assets\/([^"']+\.(?:js|css))["']/g)].map(([, name]) => name);
  while (waiting.length > 0) {
    const name = waiting.pop();
    if (start.has(name) || isLaterModule(name) || !existsSync(path.join(assets, name))) continue;
    start.add(name);
    if (name.endsWith('.js')) waiting.push(...found(readFileSync(path.join(assets, name), 'utf8'), NOW));
  }
  const code = readdirSync(assets)
    .filter((name) => kindOf(name))
    .sort();
  const lazy = new Set(
    code.flatMap((name) => (name.endsWith('.js') ? found(readFileSync(path.join(assets, name), 'utf8'), LATER) : [])),
  );
  const whenOf = (name) =>
    start.has(name) ? 'start' : lazy.has(name) || name.endsWith('.wasm') ? 'later' : 'elsewhere';
  return [
    { name: page, kind: kindOf(page), bytes: gzipped(folder, [page]), when: 'start' },
    ...code.map((name) => ({ name, kind: kindOf(name), bytes: gzipped(assets, [name]), when: whenOf(name) })),
  ];
}

/** A script of the package with its static imports. */
function withImports(folder, entry, patterns = NOW.slice(0, 1)) {
  const files = new Set();
  const waiting = [entry];
  while (waiting.length > 0) {
    const name = waiting.pop();
    if (files.has(name)) continue;
    files.add(name);
    waiting.push(...found(readFileSync(path.join(folder, name), 'utf8'), patterns));
  }
  return files;
}

/** The existing scripts of the package, each with its size and limit. */
export function packageSizes(folder) {
  const soonOrLater = [NOW[0], ...LATER];
  const engine = withImports(folder, 'index.js', soonOrLater);
  return Object.entries(PACKAGE_LIMITS)
    .filter(([name]) => existsSync(path.join(folder, name)))
    .map(([name, limit]) => {
      const files = BESIDE_ENGINE.includes(name)
        ? [...withImports(folder, name, soonOrLater)].filter((file) => !engine.has(file))
        : withImports(folder, name);
      return { name, limit, bytes: gzipped(folder, files) };
    });
}

/** Prints the package's sizes; throws if one exceeds its limit. */
export function checkPackageSizes(folder, print = (line) => process.stderr.write(`${line}\n`)) {
  for (const { name, limit, bytes } of packageSizes(folder)) {
    const beside = BESIDE_ENGINE.includes(name) ? ' beside engine and three.js' : '';
    print(`package, ${name}${beside}: ${kilobytes(bytes)} compressed, of at most ${kilobytes(limit)}`);
    if (bytes > limit)
      throw new Explained(`${name} of the package has ${kilobytes(bytes)}; the limit is ${kilobytes(limit)}.`);
  }
}

/** Prints the sizes; throws if one exceeds its limit or if nothing was measured. */
export function checkSizes(folder, print = (line) => process.stderr.write(`${line}\n`)) {
  const files = sizesOf(folder);
  for (const { name, bytes, when } of files) {
    const words = { start: '', later: ', only when it is needed', elsewhere: ', another page' }[when];
    print(`  ${kilobytes(bytes).padStart(10)}  ${name}${words}`);
  }
  const starting = files.filter(({ when }) => when === 'start');
  for (const kind of Object.values(KINDS))
    if (!starting.some((file) => file.kind === kind))
      throw new Explained(`no ${kind} was found in ${folder}: the check of sizes no longer understands the build`);
  for (const [what, limit] of Object.entries(LIMITS)) {
    const isFirst = what === 'firstPicture';
    const counted = isFirst
      ? starting
      : files.filter(({ name, kind }) => kind === 'wasm' && name.startsWith(`${what}-`));
    const total = counted.reduce((sum, { bytes }) => sum + bytes, 0);
    const of = isFirst ? 'until the first picture' : what;
    print(`${of}: ${kilobytes(total)} compressed, of at most ${kilobytes(limit)}`);
    if (total > limit)
      throw new Explained(
        `${isFirst ? 'The first picture of a visit' : what} needs ${kilobytes(total)} (compressed); the limit is ` +
          `${kilobytes(limit)}. Load what is not needed at once later, or leave it out.`,
      );
  }
}
