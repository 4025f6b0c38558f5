/** The page made by `npm run build`, and the browser that measures it. */
import { existsSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium, type Browser } from '@playwright/test';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';

// The path is relative to the bundle, build/node/bench.mjs.
export const dist = fileURLToPath(new URL('../../dist', import.meta.url));

/** If the page does not exist, prints instructions and exits with a failure. */
export function isPageBuilt(): boolean {
  if (existsSync(path.join(dist, 'index.html'))) return true;
  console.error('The page is not built yet: npm run build.');
  process.exitCode = 1;
  return false;
}

/** Options of Chromium for software drawing. */
export const browserOptions = () => ({
  executablePath: findBrowser(chromium) ?? undefined,
  args: [
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ],
});

export const startBrowser = (): Promise<Browser> => chromium.launch(browserOptions());
