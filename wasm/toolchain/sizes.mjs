// What a visitor has to fetch: the page's JavaScript and wasm, compressed, against their limits. A build over them
// fails.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { Explained } from './log.mjs';

/** Bytes after gzip. */
export const LIMITS = { JavaScript: 260_000, wasm: 450_000 };

// The bundler's own output: these forms and no others.
const NOW = [/(?:from|import)\s*["']\.\/([^"']+\.js)["']/g, /new URL\(\s*["'](?:\.\/)?([^"']+\.(?:js|wasm))["']/g];
const LATER = [/import\(\s*["']\.\/([^"']+\.js)["']\s*\)/g];

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

/** Prints the sizes; throws where one is over its limit or where nothing was found to measure. */
export function checkSizes(folder, print = (line) => process.stderr.write(`${line}\n`)) {
  const files = sizesOf(folder);
  const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;
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
