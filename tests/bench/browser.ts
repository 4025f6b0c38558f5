/** The same measurements in Chromium: a page of our own, bundled beside the results and served from the repository. */
import path from 'node:path';
import { chromium } from '@playwright/test';
import { build } from 'esbuild';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';
import { serve } from '../../wasm/toolchain/serve.mjs';
import type { Run } from './measure.ts';

export interface BenchPage {
  version: string;
  /** mesh: the file's path in the repository. */
  measure(mesh: string): Promise<Run>;
  close(): Promise<void>;
}

// Page and worker at the depth below the repository at which the path to the wasm module is the engine's own.
async function bundle(repository: string): Promise<void> {
  await build({
    entryPoints: [
      { in: path.join(repository, 'tests/bench/page.ts'), out: 'page' },
      { in: path.join(repository, 'web/engine/engine.worker.ts'), out: 'worker' },
    ],
    outdir: path.join(repository, 'build/bench-page'),
    bundle: true,
    splitting: true,
    platform: 'browser',
    target: 'es2022',
    format: 'esm',
    external: ['../../build/wasm/shapespline.mjs'],
    logLevel: 'warning',
  });
}

export async function openPage(repository: string): Promise<BenchPage> {
  await bundle(repository);
  const { url, server } = await serve(repository, { port: 4273 });
  const args = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  const browser = await chromium.launch({ executablePath: findBrowser(chromium) ?? undefined, args });
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  page.on('pageerror', (error) => process.stderr.write(`${error.message}\n`));
  await page.goto(`${url}tests/bench/page.html`);
  return {
    version: `Chromium ${browser.version()}`,
    measure: (mesh) => page.evaluate(([program, file]) => import(program!).then(({ measureFile }) => measureFile(file) as Promise<Run>),
      [`${url}build/bench-page/page.js`, `${url}${mesh}`]),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}
