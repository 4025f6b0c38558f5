/** Writes sw.js into the build: the service worker with the digests of all files. */
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const SOURCE = fileURLToPath(new URL('./service-worker.js', import.meta.url));
/** Files that are not needed offline. */
const LEFT_OUT = /(\.map$|\.md$|^sw\.js$|^notices\.txt$|^manual\.html$|^\.)/;
/** Files that only some visitors need, stored after their first use. */
const LATER = /\/(shapespline_threads|cdn|codecs)-[^/]*\.(wasm|js)$/;

const sha256 = (content: Uint8Array | string): string => createHash('sha256').update(content).digest('hex');

/** Writes sw.js into a folder that contains all other files of the page. */
export function writeServiceWorker(folder: string): void {
  const digests = list(folder)
    .filter((file) => !LEFT_OUT.test(file))
    .sort()
    .map(
      (file) => [file === 'index.html' ? './' : `./${file}`, sha256(readFileSync(path.join(folder, file)))] as const,
    );
  const source = readFileSync(SOURCE, 'utf8');
  const constants = {
    BUILD: sha256(JSON.stringify(digests) + source).slice(0, 16),
    FILES: Object.fromEntries(digests.filter(([file]) => !LATER.test(file))),
    PAGES: Object.fromEntries(digests.filter(([file]) => isPage(file)).map(([file]) => [file, entryOf(folder, file)])),
    LATER: Object.fromEntries(digests.filter(([file]) => LATER.test(file))),
  };
  const head = Object.entries(constants).map(([name, value]) => `const ${name} = ${JSON.stringify(value)};\n`);
  writeFileSync(path.join(folder, 'sw.js'), head.join('') + source);
}

const isPage = (file: string): boolean => file === './' || /^\.\/[^/]+\.html$/.test(file);

/** The first script of a page. */
function entryOf(folder: string, page: string): string | undefined {
  const html = readFileSync(path.join(folder, page === './' ? 'index.html' : page), 'utf8');
  return /<script [^>]*\bsrc="(?:\.\/)?([^"]+)"/.exec(html)?.[1];
}

export function offline(): Plugin {
  let folder = '';
  return {
    name: 'shapespline-offline',
    apply: 'build',
    configResolved(config) {
      folder = config.build.outDir;
    },
    closeBundle: () => writeServiceWorker(folder),
  };
}

function list(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => statSync(path.join(folder, name)).isFile())
    .map((name) => name.split(path.sep).join('/'));
}
