/** Writes sw.js into the build: the service worker with the list of all files and a digest of their contents. */
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const SOURCE = fileURLToPath(new URL('./service-worker.js', import.meta.url));
/** Maps are not needed to work offline. The module for two threads is kept once it was used. */
const LEFT_OUT = /(\.map$|\.md$|^sw\.js$|^\.|shapespline_threads-[^/]*\.wasm$)/;

export function offline(): Plugin {
  let folder = '';
  return {
    name: 'shapespline-offline',
    apply: 'build',
    configResolved(config) {
      folder = config.build.outDir;
    },
    closeBundle() {
      const files = list(folder)
        .filter((file) => !LEFT_OUT.test(file))
        .sort();
      const digest = createHash('sha256');
      for (const file of files) digest.update(file).update(readFileSync(path.join(folder, file)));
      const wanted = files.map((file) => (file === 'index.html' ? './' : `./${file}`));
      const head = `const FILES = ${JSON.stringify(wanted)};\nconst BUILD = ${JSON.stringify(digest.digest('hex').slice(0, 16))};\n`;
      writeFileSync(path.join(folder, 'sw.js'), head + readFileSync(SOURCE, 'utf8'));
    },
  };
}

function list(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => statSync(path.join(folder, name)).isFile())
    .map((name) => name.split(path.sep).join('/'));
}
