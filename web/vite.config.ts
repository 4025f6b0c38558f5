import { existsSync, readdirSync, rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';
import { offline } from './offline/plugin.ts';
import { preload } from './offline/preload.ts';

const here = fileURLToPath(new URL('.', import.meta.url));
const repository = fileURLToPath(new URL('..', import.meta.url));

// Every HTML file of these folders is a page of its own.
const pages = ['', 'embed/']
  .filter((folder) => existsSync(here + folder))
  .flatMap((folder) => readdirSync(here + folder).map((file) => here + folder + file))
  .filter((file) => file.endsWith('.html'));

// What is served as it is has a note for those who work on it; visitors need none.
const withoutNotes: Plugin = {
  name: 'shapespline-without-notes',
  apply: 'build',
  closeBundle: () => rmSync(`${repository}dist/README.md`, { force: true }),
};

export default defineConfig({
  root: here,
  publicDir: `${repository}public`,
  cacheDir: `${repository}build/vite`,
  // Relative URLs: the built page works from any sub-path of any static host.
  base: './',
  plugins: [preload(), withoutNotes, offline()],
  build: {
    outDir: `${repository}dist`,
    emptyOutDir: true,
    target: 'es2022',
    rollupOptions: { input: pages },
    // three.js alone is larger than Vite's warning limit.
    chunkSizeWarningLimit: 1200,
  },
  worker: { format: 'es' },
  // The worker's packages, too, are bundled before the first request: finding one later would reload the page.
  optimizeDeps: { entries: ['**/*.html', 'engine/*.worker.ts'] },
  server: { fs: { allow: [repository] } },
});
