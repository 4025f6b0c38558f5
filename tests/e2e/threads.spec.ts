/** Large shapes on a host that isolates its pages: a second thread, and the same frames as everywhere else. */
import { App, expect, test } from './support.ts';

const FACES = 84_000;  // 42,002 vertices: above what threads are tried for
const PLAIN = `http://localhost:${process.env['SHAPESPLINE_BUILT_PORT'] ?? '5274'}/some/sub/path/`;
const HELPER = /helper\.worker-[\w-]+\.js/g;
const TIMES = [0.1, 0.35, 0.5, 0.8, 1.2];

interface Shown {
  isolated: boolean;
  helper: boolean;
  threads: number;
  positions: Float32Array[];
}

/** Opens a large shape, makes more frames than are needed to choose, and looks at some. */
async function show(app: App): Promise<Shown> {
  await app.openGenerated(FACES);
  const frames = await app.page.evaluate(async (times) => {
    const list: number[][] = [];
    for (let round = 0; round < 4; ++round) for (const t of times) list[times.indexOf(t)] = Array.from(await window.__shapespline!.evaluate(t));
    return list;
  }, TIMES);
  return {
    isolated: await app.page.evaluate(() => crossOriginIsolated),
    helper: app.page.workers().some((worker) => worker.url().includes('helper')),
    threads: (await app.stats()).threads,
    positions: frames.map((frame) => Float32Array.from(frame)),
  };
}

test('an isolated page has a second thread for a large shape, and the frames of a page without', async ({ app, browser }) => {
  test.setTimeout(240_000);
  await app.open();
  const isolated = await show(app);
  await app.expectNoProblems();
  const plainPage = new App(await browser.newPage({ reducedMotion: 'reduce', baseURL: PLAIN }));
  await plainPage.open();
  const plain = await show(plainPage);
  await plainPage.expectNoProblems();
  await plainPage.page.close();
  expect(isolated).toMatchObject({ isolated: true, helper: true });
  expect(plain).toMatchObject({ isolated: false, helper: false, threads: 1 });
  expect(isolated.positions).toEqual(plain.positions);
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
