/** Large shapes on a host that isolates its pages: a second thread, and the same frames as everywhere else. */
import { fileURLToPath } from 'node:url';
import { freePort, serve } from '../../wasm/toolchain/serve.mjs';
import { App, expect, test } from './support.ts';

const BUILT = fileURLToPath(new URL('../../dist', import.meta.url));

const FACES = 84_000;  // 42,002 vertices: above what threads are tried for
const PLAIN = `http://localhost:${process.env['SHAPESPLINE_BUILT_PORT'] ?? '5274'}/some/sub/path/`;
const HELPER = /helper\.worker-[\w-]+\.js/g;
const TIMES = [0.1, 0.35, 0.5, 0.8, 1.2];

interface Shown {
  isolated: boolean;
  helper: boolean;
  threads: number;
  /** On the page, of the threads at work. */
  said: string | null;
  positions: Float32Array[];
}

/** Opens a large shape, makes more frames than are needed to choose, and up to `patience` more until two threads are the faster
    ones, and looks at some. */
async function show(app: App, patience = 0): Promise<Shown> {
  await app.openGenerated(FACES);
  const frames = await app.page.evaluate(async ([times, more]) => {
    const list: number[][] = [];
    for (let round = 0; round < 4; ++round) for (const t of times) list[times.indexOf(t)] = Array.from(await window.__shapespline!.evaluate(t));
    for (let i = 0; i < more && (await window.__shapespline!.stats())!.threads === 1; ++i) await window.__shapespline!.evaluate(0.2);
    return list;
  }, [TIMES, patience] as const);
  await app.setTime(0.4);
  await app.by('mesh-report').locator('summary').click();
  return {
    isolated: await app.page.evaluate(() => crossOriginIsolated),
    helper: app.page.workers().some((worker) => worker.url().includes('helper')),
    threads: (await app.stats()).threads,
    said: await app.by('mesh-report').locator('dt:text-is("Threads at work") + dd').textContent(),
    positions: frames.map((frame) => Float32Array.from(frame)),
  };
}

test('an isolated page has a second thread for a large shape, and the frames of a page without', async ({ app, browser }) => {
  test.setTimeout(240_000);
  await app.open();
  const isolated = await show(app, 600);  // on a busy machine one thread may win at first
  await app.expectNoProblems();
  const plainPage = new App(await browser.newPage({ reducedMotion: 'reduce', baseURL: PLAIN }));
  await plainPage.open();
  const plain = await show(plainPage);
  await plainPage.expectNoProblems();
  await plainPage.page.close();
  expect(isolated).toMatchObject({ isolated: true, helper: true, said: String(isolated.threads) });
  expect(plain).toMatchObject({ isolated: false, helper: false, threads: 1, said: '1' });
  expect(isolated.positions).toEqual(plain.positions);
});

test('an isolated page that was opened once works without a network, with two threads once it had them', async ({ browser }) => {
  test.setTimeout(240_000);
  const port = await freePort();
  const host = async (): Promise<() => Promise<void>> => {
    const { server } = await serve(BUILT, { port, tries: 1, isolated: true });
    return () => new Promise((gone) => {
      server.close(() => gone());
      server.closeAllConnections();
    });
  };
  const app = new App(await browser.newPage({ reducedMotion: 'reduce', baseURL: `http://localhost:${port}/` }));
  const visit = async (): Promise<Shown> => {
    await app.open();
    return show(app);
  };
  let stop = await host();
  await app.open();
  await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await stop();
  const alone = await visit();
  expect(alone).toMatchObject({ isolated: true, helper: false, threads: 1 });
  stop = await host();
  const online = await visit();
  expect(online).toMatchObject({ isolated: true, helper: true });
  await stop();
  const offline = await visit();
  expect(offline).toMatchObject({ isolated: true, helper: true });
  expect(offline.positions).toEqual(online.positions);
  expect(offline.positions).toEqual(alone.positions);
  await app.page.close();
});

test.describe('without what it takes', () => {
  test.use({ serviceWorkers: 'block' });  // whose requests cannot be stopped here

  test('an isolated page works without the module for two threads', async ({ app }) => {
    test.setTimeout(240_000);
    await app.page.route(/shapespline_threads.*\.wasm$/, (route) => route.abort());
    await app.open();
    const shown = await show(app);
    expect(shown).toMatchObject({ isolated: true, helper: false, threads: 1 });
    expect(shown.positions).toHaveLength(TIMES.length);
  });

  test('an isolated page works without the second thread itself', async ({ app }) => {
    test.setTimeout(240_000);
    await app.page.route(/engine\.worker.*\.js$/, async (route) => {  // requests of workers themselves cannot be stopped
      const response = await route.fetch();
      const text = await response.text();
      expect(text).toMatch(HELPER);
      await route.fulfill({ response, body: text.replaceAll(HELPER, 'no-such-file.js') });
    });
    await app.open();
    const shown = await show(app);
    expect(shown).toMatchObject({ isolated: true, threads: 1 });
    expect(shown.positions).toHaveLength(TIMES.length);
  });
});

test('a sample of usual size has one thread on an isolated page', async ({ app }) => {
  await app.open({ sample: 'cactus' });
  await app.setTime(0.4);
  expect((await app.stats()).threads).toBe(1);
  await app.expectNoProblems();
});
