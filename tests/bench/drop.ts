/**
 * npm run bench -- drop [FACES,...]: the built page in Chromium, from opening a file until its motion is drawn. Reports
 * when the file was read, the first key was shown, the motion was made, its shape was drawn, and the graphics card
 * finished; and the page's longest unresponsive time.
 */
import type { Page } from '@playwright/test';
import { serve } from '../../wasm/toolchain/serve.mjs';
import type {} from '../../web/app/test-hook.ts';
import { dist, isPageBuilt, startBrowser } from './built-page.ts';
import { quantile } from './quantile.ts';

const RUNS = 5;
const COLUMNS = ['read', 'first key', 'made', 'drawn', 'finished', 'longest task'] as const;

/** Milliseconds after the file was given, NaN for missing events. */
type Times = Record<(typeof COLUMNS)[number], number>;

/** Runs in the page, because the observed events are short. */
function watch(): Promise<Times> {
  const begin = performance.now();
  let longest = 0;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longest = Math.max(longest, duration);
  }).observe({ type: 'longtask' });
  const after = (name: string): number => {
    const mark = performance.getEntriesByName(`shapespline ${name}`).findLast(({ startTime }) => startTime > begin);
    return mark ? mark.startTime - begin : NaN;
  };
  return new Promise((resolve) => {
    const look = (): void => {
      const isOpen = window.__shapespline!.state.source.kind === 'files' && !Number.isNaN(after('made'));
      if (!isOpen) return void requestAnimationFrame(look);
      // The shape was first drawn in the frame after this one.
      const end = (): void => {
        const drawn = performance.now() - begin;
        const gl = document.querySelector('canvas')!.getContext('webgl2')!;
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
        gl.flush();
        const poll = (): void => {
          if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return void setTimeout(poll, 4);
          const finished = performance.now() - begin;
          const marks = { read: after('read'), 'first key': after('first key'), made: after('made') };
          resolve({ ...marks, drawn, finished, 'longest task': longest });
        };
        poll();
      };
      requestAnimationFrame(() => requestAnimationFrame(end));
    };
    look();
  });
}

async function drop(page: Page, url: string, file: string): Promise<Times> {
  await page.goto(url);
  await page.waitForFunction(() => window.__shapespline);
  await page.evaluate(() => window.__shapespline!.settled());
  const watched = page.evaluate(watch);
  await page.locator('[data-testid=file-input]').setInputFiles(file);
  return watched;
}

/** `meshOf`: the path of a generated mesh. */
export async function benchDrop(faces: readonly number[], meshOf: (faces: number) => string): Promise<void> {
  if (!isPageBuilt()) return;
  const { url, server } = await serve(dist, { port: 4275 });
  const browser = await startBrowser();
  console.log(`Milliseconds after a file was given to the page, medians of ${RUNS}; "longest task": of the page.`);
  console.log('');
  console.log(`| faces | ${COLUMNS.join(' | ')} |`);
  console.log(`|${'---|'.repeat(1 + COLUMNS.length)}`);
  try {
    for (const count of faces) {
      const file = meshOf(count);
      const runs: Times[] = [];
      while (runs.length < RUNS) {
        const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
        runs.push(await drop(await context.newPage(), url, file));
        await context.close();
      }
      const medians = COLUMNS.map((name) => {
        const median = quantile(runs.map((times) => times[name]));
        return Number.isNaN(median) ? '' : median.toFixed(0);
      });
      console.log(`| ${[count, ...medians].join(' | ')} |`);
    }
  } finally {
    await browser.close();
    server.close();
  }
}
