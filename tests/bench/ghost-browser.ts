/**
 * npm run bench -- ghost browser [FACES,...]: large meshes with a ghost mesh of 2,000 faces, on the built page in
 * Chromium. Reports the response to each move of the slider, the main thread's long tasks, and the tab's peak memory.
 */
import { execFileSync, spawn } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { createServer, type AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium, type Page } from '@playwright/test';
import type { Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import type {} from '../../web/app/test-hook.ts';
import { browserOptions, dist, isPageBuilt } from './built-page.ts';
import { residentOf } from './process-memory.ts';

const DEFAULT_SIZES = [{ faces: 330_000 }, { faces: 1_300_000 }];
const MOVES = 40;
const WAIT_MS = 600_000;
const generator = fileURLToPath(new URL('../cmake-wasm/shapespline_meshes.js', import.meta.url));

export async function benchGhostInBrowser({ sizes }: Wanted): Promise<void> {
  if (!isPageBuilt()) return;
  const folder = await mkdtemp(path.join(tmpdir(), 'shapespline-bench-'));
  const port = await freePort();
  const server = spawn(
    process.execPath,
    [path.join(dist, '../wasm/toolchain/serve.mjs'), dist, '--port', String(port)],
    { stdio: ['ignore', 'pipe', 'inherit'] },
  );
  await new Promise((listening) => server.stdout.once('data', listening));
  try {
    for (const { faces } of sizes ?? DEFAULT_SIZES) {
      execFileSync(process.execPath, [generator, '--bench', String(faces), folder], {
        stdio: ['ignore', 'ignore', 'inherit'],
      });
      const browser = await chromium.launchServer(browserOptions());
      try {
        const page = await (await chromium.connect(browser.wsEndpoint())).newPage();
        console.log(
          JSON.stringify(
            await measure(
              page,
              `http://localhost:${port}/`,
              path.join(folder, `bench-${faces}.glb`),
              browser.process().pid!,
            ),
            null,
            2,
          ),
        );
      } finally {
        await browser.close();
      }
    }
  } finally {
    server.kill();
    await rm(folder, { recursive: true, force: true });
  }
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, 'localhost', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}

async function measure(page: Page, url: string, file: string, pid: number): Promise<object> {
  page.setDefaultTimeout(WAIT_MS);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(url);
  await page.waitForFunction(() => window.__shapespline !== undefined);
  const settled = async (): Promise<void> => {
    await page.waitForTimeout(100);
    await page.evaluate(() => window.__shapespline!.settled());
  };
  await page.evaluate(() => window.__shapespline!.ready);
  await settled();
  const opened = performance.now();
  await page.getByTestId('file-input').setInputFiles(file);
  await page.waitForFunction(() => window.__shapespline!.state.source.kind === 'files');
  await settled();
  const openMs = performance.now() - opened;
  const withGhost = performance.now();
  await page.getByTestId('ghost').check();
  await settled();
  const ghostMs = performance.now() - withGhost;
  const scrub = await page.evaluate(async (moves) => {
    const hook = window.__shapespline!;
    const tasks: number[] = [];
    const observer = new PerformanceObserver((list) =>
      tasks.push(...list.getEntries().map(({ duration }) => duration)),
    );
    observer.observe({ type: 'longtask' });
    const responses: number[] = [];
    for (let i = 0; i < moves; i += 1) {
      const start = performance.now();
      await hook.evaluate(-0.3 + (1.6 * i) / moves);
      const responded = performance.now();
      await hook.setTime(-0.3 + (1.6 * i) / moves);
      responses.push(responded - start);
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
    observer.disconnect();
    return { responses: responses.sort((a, b) => a - b), tasks: tasks.sort((a, b) => b - a) };
  }, MOVES);
  const stats = (await page.evaluate(() => window.__shapespline!.stats()))!;
  const round = (ms: number | undefined): number => Math.round(10 * (ms ?? 0)) / 10;
  return {
    file: path.basename(file),
    ghostFaces: stats.ghostFaces,
    openMs: round(openMs),
    ghostMs: round(ghostMs),
    responseMs: { median: round(scrub.responses[MOVES / 2]), slowest: round(scrub.responses.at(-1)) },
    longTasks: { over50: scrub.tasks.length, longestMs: round(scrub.tasks[0]) },
    heapMB: Math.round(stats.heapBytes / 2 ** 20),
    tabPeakMB: peakOf(pid),
  };
}

/** The largest resident set of any renderer of the browser so far, if the system reports it (Linux). */
function peakOf(pid: number): number | null {
  const processes = residentOf(pid);
  return processes && Math.round(Math.max(0, ...processes.map(({ peak }) => peak)));
}
