/**
 * npm run bench -- start: the built page's first visit in Chromium, from a local server. Reports the times after
 * navigation when scripts run, the sample is read, its motion is made, its shape is drawn, and the graphics card has
 * finished. Measures a running browser and a freshly started one. Processor times are less affected by other programs.
 */
import type { Browser } from '@playwright/test';
import type { Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import { serve } from '../../wasm/toolchain/serve.mjs';
import { dist, isPageBuilt, startBrowser } from './built-page.ts';
import { quantile } from './quantile.ts';

const RUNS = 7;
const MARKS = ['scripts', 'read', 'made', 'seen', 'finished'] as const;
/** A running browser has already opened its window, which takes about this long. */
const WINDOW_MS = 1200;

type Times = Record<(typeof MARKS)[number] | 'cpu', number>;

/** Runs in the page. The first mark is set when the image is requested, this one when it is finished. */
function markFinished(): void {
  const mark = performance.mark.bind(performance);
  performance.mark = (name, options) => {
    const gl = name === 'shapespline seen' ? document.querySelector('canvas')!.getContext('webgl2') : null;
    const fence = gl?.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl?.flush();
    const look = (): void => {
      if (gl!.getSyncParameter(fence!, gl!.SYNC_STATUS) === gl!.SIGNALED) mark('shapespline finished');
      else setTimeout(look, 4);
    };
    if (fence) setTimeout(look, 4);
    return mark(name, options);
  };
}

/** Nothing from an earlier visit is stored, neither files nor settings. */
async function visit(browser: Browser, url: string, windowMs = 0): Promise<Times> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.addInitScript(markFinished);
  await new Promise((resolve) => setTimeout(resolve, windowMs));
  const session = await browser.newBrowserCDPSession();
  const cpu = async (): Promise<number> => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return processInfo.filter(({ type }) => type !== 'browser').reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  };
  const before = await cpu();
  await page.goto(url, { waitUntil: 'commit' });
  await page.waitForFunction(() => performance.getEntriesByName('shapespline finished').length > 0, null, {
    polling: 20,
  });
  const spent = (await cpu()) - before;
  const marks = await page.evaluate(
    (names) => names.map((name) => performance.getEntriesByName(`shapespline ${name}`)[0]!.startTime),
    [...MARKS],
  );
  await session.detach();
  await context.close();
  return Object.fromEntries([...MARKS.map((name, i) => [name, marks[i]!]), ['cpu', 1000 * spent]]) as Times;
}

async function justStarted(url: string): Promise<Times> {
  const browser = await startBrowser();
  try {
    return await visit(browser, url);
  } finally {
    await browser.close();
  }
}

function line(what: string, visits: readonly Times[]): string {
  const median = (name: keyof Times): string =>
    Math.round(
      quantile(
        visits.map((times) => times[name]),
        0.5,
      ),
    ).toString();
  return `| ${what} | ${[...MARKS, 'cpu' as const].map(median).join(' | ')} |`;
}

export async function benchStart(_: Wanted): Promise<void> {
  if (!isPageBuilt()) return;
  const { url, server } = await serve(dist, { port: 4274 });
  const running = await startBrowser();
  const warm: Times[] = [];
  const cold: Times[] = [];
  try {
    await visit(running, url, WINDOW_MS);
    for (let run = 0; run < RUNS; run += 1) {
      warm.push(await visit(running, url, WINDOW_MS));
      cold.push(await justStarted(url));
    }
  } finally {
    await running.close();
    server.close();
  }
  console.log(
    `Milliseconds after the navigation, medians of ${RUNS} first visits; CPU of all processes but the browser's.`,
  );
  console.log('');
  console.log('| browser | scripts | read | made | seen | finished | CPU |');
  console.log('|---|---|---|---|---|---|---|');
  console.log(line('running', warm));
  console.log(line('just started', cold));
}
