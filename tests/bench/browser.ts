/**
 * The engine in Chromium: a page bundled next to the results and served from the repository, isolated for two threads
 * and a finer clock.
 */
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { chromium } from '@playwright/test';
import { build, type Plugin } from 'esbuild';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';
import { developmentGuards, serve } from '../../wasm/toolchain/serve.mjs';
import { wasmStaysOutside } from '../../wasm/toolchain/wasm-outside.mjs';
import type { Runner } from './runner.ts';

// The URL of a worker within a worker is unchanged.
const secondThreadAddress: Plugin = {
  name: 'second-thread-address',
  setup: ({ onLoad }) =>
    onLoad({ filter: /engine\.worker\.ts$/ }, async ({ path: file }) => {
      const text = await readFile(file, 'utf8');
      return { contents: text.replace('second-thread.worker.ts', 'second-thread.worker.js'), loader: 'ts' };
    }),
};

async function bundle(repository: string): Promise<void> {
  await build({
    entryPoints: [
      { in: path.join(repository, 'tests/bench/page.ts'), out: 'page' },
      { in: path.join(repository, 'web/engine/worker/engine.worker.ts'), out: 'worker' },
      { in: path.join(repository, 'web/engine/worker/second-thread.worker.ts'), out: 'second-thread.worker' },
    ],
    outdir: path.join(repository, 'build/bench-page'),
    bundle: true,
    splitting: true,
    platform: 'browser',
    target: 'es2022',
    format: 'esm',
    // Decoders are loaded only when a file needs them, and generated files do not.
    packages: 'external',
    plugins: [secondThreadAddress, wasmStaysOutside],
    logLevel: 'warning',
  });
}

export async function browserRunner(repository: string): Promise<Runner> {
  await bundle(repository);
  const { url, server } = await serve(repository, { port: 4273, isolated: true, headers: developmentGuards });
  const args = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  const browser = await chromium.launch({ executablePath: findBrowser(chromium) ?? undefined, args });
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  page.on('pageerror', (error) => process.stderr.write(`${error.message}\n`));
  await page.goto(`${url}tests/bench/page.html`);
  const addressOf = (file: string): string => url + path.relative(repository, file).split(path.sep).join('/');
  // Functions among the arguments, such as runNative, run here when the page calls them.
  const call = <T>(name: string, ...words: unknown[]): Promise<T> =>
    page.evaluate(
      ([program, exported, args]) =>
        import(program).then((bundled) =>
          (bundled as Record<string, (...args: unknown[]) => Promise<unknown>>)[exported]!(...args),
        ),
      [`${url}build/bench-page/page.js`, name, words] as const,
      { exposeFunctions: true },
    ) as Promise<T>;
  return {
    name: `Chromium ${browser.version()}`,
    measure: (mesh, runNative) => call('measureFile', addressOf(mesh), runNative),
    motion: (mesh, motion) => call('motionOf', addressOf(mesh), motion),
    resolutions: (coarse, fine) => call('resolutionsOf', addressOf(coarse), addressOf(fine)),
    keys: (few, many, count) => call('keysOf', addressOf(few), addressOf(many), count),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}
