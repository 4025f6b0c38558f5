/** Large shapes on a host that isolates its pages: a second thread, with the same frames as elsewhere. */
import { fileURLToPath } from 'node:url';
import { freePort, serve } from '../../wasm/toolchain/serve.mjs';
import { App, expect, test } from './support.ts';

test.use({ ownProfile: true });

const BUILT = fileURLToPath(new URL('../../dist', import.meta.url));

const FACES = 84_000; // 42,002 vertices: above the limit for a second thread
const PLAIN = `http://localhost:${process.env['SHAPESPLINE_BUILT_PORT'] ?? '5274'}/some/sub/path/`;
const TIMES = [0.1, 0.35, 0.5, 0.8, 1.2];

interface Shown {
  isolated: boolean;
  helper: boolean;
  threads: number;
  /** The page's text about the threads in use. */
  said: string | null;
  /** A checksum of the positions of each frame. */
  frames: string[];
}

/** Makes each single-thread frame in the engine's worker appear a second slower by its clock. */
function slowAlone(): void {
  type Kernels = Record<'shapespline_set_threads' | 'shapespline_evaluate', (...args: number[]) => number>;
  const now = performance.now.bind(performance);
  const instantiate = WebAssembly.instantiate.bind(WebAssembly);
  let late = 0,
    threads = 1;
  performance.now = () => now() + late;
  WebAssembly.instantiate = async (module: WebAssembly.Module, imports?: WebAssembly.Imports) => {
    const instance = await instantiate(module, imports);
    const kernels = instance.exports as Kernels;
    return {
      exports: {
        ...kernels,
        shapespline_set_threads: (...args: number[]) => {
          threads = args[1]!;
          return kernels.shapespline_set_threads(...args);
        },
        shapespline_evaluate: (...args: number[]) => {
          if (threads === 1) late += 1000;
          return kernels.shapespline_evaluate(...args);
        },
      },
    } as never;
  };
}

/** Changes the script of the engine's worker during loading. */
async function changeWorker(app: App, change: (text: string) => string): Promise<void> {
  await app.page.route(/engine\.worker.*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: change(await response.text()) });
  });
}

/**
 * Opens a large shape and makes more frames than the choice needs, then up to `patience` more until two threads are
 * faster. Returns some frames.
 */
async function show(app: App, patience = 0): Promise<Shown> {
  await app.openGenerated(FACES);
  const frames = await app.page.evaluate(
    async ([times, more]) => {
      const list: string[] = [];
      for (let round = 0; round < 4; ++round)
        for (const [i, t] of times.entries()) {
          const positions = new Float32Array(await window.__shapespline!.evaluate(t));
          list[i] = String(new Uint8Array(await crypto.subtle.digest('SHA-256', positions)));
        }
      for (let i = 0; i < more && (await window.__shapespline!.stats())!.threads === 1; ++i)
        await window.__shapespline!.evaluate(0.2);
      return list;
    },
    [TIMES, patience] as const,
  );
  await app.setTime(0.4);
  await app.by('mesh-report').locator('summary').click();
  return {
    isolated: await app.page.evaluate(() => crossOriginIsolated),
    helper: app.page.workers().some((worker) => worker.url().includes('second-thread')),
    threads: (await app.stats()).threads,
    said: await app.by('mesh-report').locator('dt:text-is("Threads") + dd').textContent(),
    frames,
  };
}

test('an isolated page works offline after the first visit, with two threads if it had them online', {
  tag: '@all',
}, async ({ browser }) => {
  test.setTimeout(240_000);
  const port = await freePort();
  const host = async (): Promise<() => Promise<void>> => {
    const { server } = await serve(BUILT, { port, tries: 1, isolated: true });
    return () =>
      new Promise((gone) => {
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
  expect(new Set(offline.frames).size).toBe(TIMES.length);
  expect(offline).toMatchObject({ isolated: true, helper: true });
  expect(offline.frames).toEqual(online.frames);
  expect(offline.frames).toEqual(alone.frames);
  await app.page.close();
});

test.describe('with changed or blocked files', () => {
  test.use({ serviceWorkers: 'block' }); // a service worker's requests cannot be intercepted

  test('on an isolated page, two threads compute a large shape if that is faster, with the same frames as one thread', {
    tag: '@all',
  }, async ({ app, browser }) => {
    test.setTimeout(240_000);
    await changeWorker(app, (text) => `(${slowAlone.toString()})();\n${text}`);
    await app.open();
    const isolated = await show(app, 600); // the second thread may take time to become ready
    expect(app.problems).toEqual([]);
    const plainPage = new App(await browser.newPage({ reducedMotion: 'reduce', baseURL: PLAIN }));
    await plainPage.open();
    const plain = await show(plainPage);
    expect(plainPage.problems).toEqual([]);
    await plainPage.page.close();
    expect(isolated).toMatchObject({ isolated: true, helper: true, threads: 2, said: '2' });
    expect(plain).toMatchObject({ isolated: false, helper: false, threads: 1, said: '1' });
    expect(isolated.frames).toEqual(plain.frames);
  });
});

test('a sample of usual size has one thread on an isolated page', async ({ app }) => {
  await app.open({ sample: 'cactus' });
  await app.setTime(0.4);
  expect((await app.stats()).threads).toBe(1);
  await app.expectNoProblems();
});
