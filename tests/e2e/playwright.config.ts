import { chromium, defineConfig, devices } from '@playwright/test';
import { fileURLToPath } from 'node:url';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
// `npm test` passes free ports; these are for running Playwright directly.
const devPort = process.env.SHAPESPLINE_DEV_PORT ?? '5273';
const builtPort = process.env.SHAPESPLINE_BUILT_PORT ?? '5274';
const isolatedPort = process.env.SHAPESPLINE_ISOLATED_PORT ?? '5275';
const subPath = '/some/sub/path/';

const args = [
  // WebGL 2 without a graphics card.
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  // Only the shape needs WebGL. The page is painted faster without it, and comparisons do not need smooth edges.
  '--disable-gpu-rasterization',
  '--disable-gpu-compositing',
  '--webgl-antialiasing-mode=none',
  // Compiled code is reused by the next page of the site, which saves a third of opening.
  '--process-per-site',
  // No background traffic of the browser.
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  // Without https, browsers trust only the host name localhost.
  '--host-resolver-rules=MAP insecure.test localhost',
];
// Every Chromium window loads two pages for its own address bar, almost a second of work per test. Only the last such
// list counts, and Playwright cannot extend its own, so this list includes Playwright's.
args.push(
  `--disable-features=${[
    'WebUIOmniboxAimPopup',
    'WebUIOmniboxPopup',
    'AimEnabled',
    'AvoidCorsURLLoaderRestartOnRedirect',
    'AvoidUnnecessaryBeforeUnloadCheckSync',
    'DestroyProfileOnBrowserClose',
    'HttpsFirstBalancedModeAutoEnable',
    'HttpsUpgrades',
    'LensOverlay',
    'MediaRouter',
    'NetworkTimeServiceQuerying',
    'OptimizationHints',
    'PaintHolding',
    'PreconnectToSearch',
    'ThirdPartyStoragePartitioning',
  ]}`,
);
if (process.getuid?.() === 0) args.push('--no-sandbox');

const project = (name: string, baseURL: string) => ({ name, use: { ...devices['Desktop Chrome'], baseURL } });

export default defineConfig({
  testDir: '.',
  outputDir: '../../build/playwright',
  // A single page does not use both cores.
  workers: 2,
  fullyParallel: true,
  timeout: 90_000,
  // Tests tagged @all are expensive and rarely find anything; they run with `npm test -- all`.
  grepInvert: process.env.SHAPESPLINE_ALL === '1' ? [] : /@all/,
  // A flaky test is a failed test.
  retries: 0,
  expect: { timeout: 20_000 },
  forbidOnly: Boolean(process.env.CI),
  use: {
    launchOptions: { executablePath: findBrowser(chromium) ?? undefined, args },
    // Traces would slow down every test and are needed for few; `--trace on` enables them.
    trace: 'off',
    screenshot: 'only-on-failure',
  },
  // All tests run on the built page under a sub-path. Tests that depend on the server (tagged @server) also run on the
  // development server: loading the page, its worker, samples, files and decoders, and the motion itself.
  projects: [
    { ...project('dev', `http://localhost:${devPort}/`), grep: /@server/ },
    { ...project('built', `http://localhost:${builtPort}${subPath}`), testIgnore: /threads\.spec\.ts$/ },
    // A host with the two headers that let threads share memory.
    { ...project('isolated', `http://localhost:${isolatedPort}/`), testMatch: /threads\.spec\.ts$/ },
  ],
  webServer: [
    {
      command: `node node_modules/vite/bin/vite.js --config web/vite.config.ts --port ${devPort} --strictPort`,
      url: `http://localhost:${devPort}/`,
      cwd: repository,
    },
    {
      command: `node wasm/toolchain/serve.mjs dist --port ${builtPort} --prefix ${subPath}`,
      url: `http://localhost:${builtPort}${subPath}`,
      cwd: repository,
    },
    {
      command: `node wasm/toolchain/serve.mjs dist --port ${isolatedPort} --isolated`,
      url: `http://localhost:${isolatedPort}/`,
      cwd: repository,
    },
  ],
});
