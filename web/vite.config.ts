import { rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';
import { manual } from './manual/plugin.ts';
import { offline } from './offline/plugin.ts';
import { NOTICES, notices, packageOf } from '../wasm/toolchain/notices.mjs';
import { withoutPixels } from '../wasm/toolchain/pixels.mjs';
import { developmentGuards } from '../wasm/toolchain/serve.mjs';
import { preload } from './offline/preload.ts';
import { unusedShaders } from './viewer/unused-shaders.ts';

const here = fileURLToPath(new URL('.', import.meta.url));
const repository = fileURLToPath(new URL('..', import.meta.url));

// The public folder also has a README and the image of the main README; visitors need neither.
const forReaders: Plugin = {
  name: 'shapespline-for-readers',
  apply: 'build',
  closeBundle: () => {
    for (const name of ['README.md', 'divider.gif']) rmSync(`${repository}dist/${name}`, { force: true });
  },
};

/** Npm packages in the page and in its workers, which are bundled before the page. */
const bundled = new Set<string>();
const collectsPackages = (): Plugin => ({
  name: 'shapespline-collects-packages',
  apply: 'build',
  generateBundle(_, bundle) {
    for (const part of Object.values(bundle)) {
      const modules = part.type === 'chunk' ? Object.keys(part.modules) : [];
      for (const name of modules.map(packageOf)) if (name !== null) bundled.add(name);
    }
  },
});

const carriesNotices: Plugin = {
  name: 'shapespline-carries-notices',
  apply: 'build',
  writeBundle: () => writeFileSync(`${repository}dist/${NOTICES}`, notices(bundled)),
};

export default defineConfig({
  root: here,
  publicDir: `${repository}public`,
  cacheDir: `${repository}build/vite`,
  // Relative URLs: the built page works from any sub-path of any static host.
  base: './',
  // The React example imports the element like a page that uses the package.
  resolve: { alias: { ...withoutPixels, 'shapespline/element': `${here}embed/register.ts` } },
  plugins: [preload(), unusedShaders(), collectsPackages(), carriesNotices, manual(), forReaders, offline()],
  build: {
    outDir: `${repository}dist`,
    emptyOutDir: true,
    target: 'es2022',
    // three.js alone is larger than Vite's warning limit.
    chunkSizeWarningLimit: 1200,
    rollupOptions: {
      input: { index: `${here}index.html`, play: `${here}play.html`, embed: `${here}embed/examples/index.html` },
    },
  },
  worker: { format: 'es', plugins: () => [collectsPackages()] },
  // Also bundles the workers' packages before the first request, because finding one later would reload the page.
  optimizeDeps: { entries: ['**/*.html', 'engine/worker/*.worker.ts'] },
  server: { fs: { allow: [repository] }, headers: developmentGuards },
});
