// What a visitor has to fetch: the page's JavaScript and wasm, compressed, against their limits. A build over them
// fails.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { Explained } from './log.mjs';

/** Bytes after gzip. */
export const LIMITS = { JavaScript: 260_000, wasm: 475_000 };

/**
 * What users of the npm package have to fetch for each of its scripts, with what it imports at once; of the element
 * what it adds to the engine. Bytes after gzip.
 */
export const PACKAGE_LIMITS = {
  'index.js': 24_000,
  'worker.js': 23_000,
  'codecs.js': 98_000,
  'element.js': 40_000,
  'element-class.js': 40_000,
  'canvas-viewer.js': 40_000,
  'cdn.js': 260_000,
};
/** Of these all counts that they import later, too: it comes with the first shape. */
const BESIDE_ENGINE = ['element.js', 'element-class.js', 'canvas-viewer.js'];

// The bundler's own output: these forms and no others.
const NOW = [/(?:from|import)\s*["']\.\/([^"']+\.js)["']/g, /new URL\(\s*["'](?:\.\/)?([^"']+\.(?:js|wasm))["']/g];
const LATER = [/import\(\s*["']\.\/([^"']+\.js)["']\s*\)/g];

const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;
const found = (text, patterns) => patterns.flatMap((pattern) => [...text.matchAll(pattern)].map(([, name]) => name));

/** Files that a page of the build needs to start, and all others that hold code, with their sizes after gzip. */
export function sizesOf(folder, page = 'index.html') {
  const assets = path.join(folder, 'assets');
  const html = readFileSync(path.join(folder, page), 'utf8');
  const start = new Set();
  const waiting = [...html.matchAll(/assets\/([^"']+\.js)["']/g)].map(([, name]) => name);
  while (waiting.length > 0) {
    const name = waiting.pop();
    if (start.has(name) || !existsSync(path.join(assets, name))) continue;
    start.add(name);
    if (name.endsWith('.js')) waiting.push(...found(readFileSync(path.join(assets, name), 'utf8'), NOW));
  }
  const code = readdirSync(assets)
    .filter((name) => /\.(js|wasm)$/.test(name))
    .sort();
  const lazy = new Set(
    code.flatMap((name) => (name.endsWith('.js') ? found(readFileSync(path.join(assets, name), 'utf8'), LATER) : [])),
  );
  const files = code.map((name) => ({
    name,
    kind: name.endsWith('.wasm') ? 'wasm' : 'JavaScript',
    bytes: gzipSync(readFileSync(path.join(assets, name))).length,
    when: start.has(name) ? 'start' : lazy.has(name) || name.endsWith('.wasm') ? 'later' : 'elsewhere',
  }));
  return files;
}

/** A script of the package and all that it imports at once. */
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

const gzipped = (folder, names) =>
  [...names].reduce((sum, name) => sum + gzipSync(readFileSync(path.join(folder, name))).length, 0);

/** The scripts of the package that are there, each with its size and limit. */
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

/** Prints the sizes of the package; throws where one is over its limit. */
export function checkPackageSizes(folder, print = (line) => process.stderr.write(`${line}\n`)) {
  for (const { name, limit, bytes } of packageSizes(folder)) {
    const beside = BESIDE_ENGINE.includes(name) ? ' beside engine and three.js' : '';
    print(`package, ${name}${beside}: ${kilobytes(bytes)} compressed, of at most ${kilobytes(limit)}`);
    if (bytes > limit)
      throw new Explained(`${name} of the package has ${kilobytes(bytes)}; the limit is ${kilobytes(limit)}.`);
  }
}

/** Prints the sizes; throws where one is over its limit or where nothing was found to measure. */
export function checkSizes(folder, print = (line) => process.stderr.write(`${line}\n`)) {
  const files = sizesOf(folder);
  for (const { name, bytes, when } of files) {
    const words = { start: '', later: ', only when it is needed', elsewhere: ', another page' }[when];
    print(`  ${kilobytes(bytes).padStart(10)}  ${name}${words}`);
  }
  for (const [kind, limit] of Object.entries(LIMITS)) {
    const total = files
      .filter((file) => file.kind === kind && file.when === 'start')
      .reduce((sum, { bytes }) => sum + bytes, 0);
    print(`${kind} to start: ${kilobytes(total)} compressed, of at most ${kilobytes(limit)}`);
    if (total === 0)
      throw new Explained(`no ${kind} was found in ${folder}: the check of sizes no longer understands the build`);
    // A module that takes the place of the first one where threads can share memory (web/engine/browser.ts).
    const other = files.find(
      (file) => file.kind === kind && file.when === 'later' && file.bytes > limit && kind === 'wasm',
    );
    if (other)
      throw new Explained(
        `${other.name} has ${kilobytes(other.bytes)} (compressed); the limit is ${kilobytes(limit)}.`,
      );
    if (total > limit) {
      throw new Explained(
        `The page needs ${kilobytes(total)} of ${kind} (compressed) to start; the limit is ${kilobytes(limit)}. ` +
          'Load what is not needed at once later, or leave it out.',
      );
    }
  }
}
