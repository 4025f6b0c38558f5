import { rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';
import { offline } from './offline/plugin.ts';
import { guards } from '../wasm/toolchain/serve.mjs';
import { preload } from './offline/preload.ts';

const here = fileURLToPath(new URL('.', import.meta.url));
const repository = fileURLToPath(new URL('..', import.meta.url));

// Beside what is served as it is lie a note for those who work on it and the picture of the main README; visitors need neither.
const forReaders: Plugin = {
  name: 'shapespline-for-readers',
  apply: 'build',
  closeBundle: () => {
    for (const name of ['README.md', 'picture.png']) rmSync(`${repository}dist/${name}`, { force: true });
  },
};

export default defineConfig({
  root: here,
  publicDir: `${repository}public`,
  cacheDir: `${repository}build/vite`,
  // Relative URLs: the built page works from any sub-path of any static host.
  base: './',
  plugins: [preload(), forReaders, offline()],
  build: {
    outDir: `${repository}dist`,
    emptyOutDir: true,
    target: 'es2022',
    // three.js alone is larger than Vite's warning limit.
    chunkSizeWarningLimit: 1200,
  },
  worker: { format: 'es' },
  // The worker's packages, too, are bundled before the first request: finding one later would reload the page.
  optimizeDeps: { entries: ['**/*.html', 'engine/worker/*.worker.ts'] },
  server: { fs: { allow: [repository] }, headers: guards },
});
