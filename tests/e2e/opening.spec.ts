/** The view while large files open: their first key, then the motion, or the earlier content on failure. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

// Responses of a service worker cannot be delayed.
test.use({ contextOptions: { reducedMotion: 'no-preference', serviceWorkers: 'block' }, ownProfile: true });

const generator = fileURLToPath(new URL('../../build/cmake-wasm/shapespline_meshes.js', import.meta.url));
const FACES = 100_000;
let folder = '';
test.beforeAll(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'shapespline-opening-'));
  execFileSync(process.execPath, [generator, '--bench', String(FACES), folder], { stdio: 'ignore' });
});
test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

type Task = 'import' | 'encode';

/** Work on the large mesh pauses at a task's report until the test releases it. */
async function held(app: App): Promise<(task: Task) => void> {
  const free: Task[] = [];
  await app.page.route(/engine\.worker.*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `(${waitAtReport.toString()})();\n${await response.text()}` });
  });
  await app.page.route('**/held-*', (route) =>
    route.fulfill({ body: String(free.some((task) => route.request().url().endsWith(task))) }),
  );
  return (task) => void free.push(task);
}

/** Runs in a worker and affects only data larger than the samples. */
function waitAtReport(): void {
  const post = self.postMessage.bind(self) as (message: { type: string }, options: object) => void;
  let task = '';
  self.addEventListener('message', ({ data }: MessageEvent) => {
    if (data.type === 'import') task = data.files[0].bytes.length > 2e6 ? 'import' : '';
    if (data.type === 'encode') task = data.faces.length > 3 * 80_000 ? 'encode' : '';
  });
  self.postMessage = ((message: { type: string }, options: object) => {
    post(message, options);
    while (task && message.type === 'progress') {
      const request = new XMLHttpRequest();
      request.open('GET', new URL(`held-${task}`, self.location.origin), false);
      request.send();
      if (request.responseText === 'true') task = '';
    }
  }) as typeof self.postMessage;
}

/** Counts import requests to workers. */
function countImports(): void {
  const post = Worker.prototype.postMessage;
  Object.assign(window, { imports: 0 });
  Worker.prototype.postMessage = function (this: Worker, ...given: unknown[]): void {
    if ((given[0] as { type?: string }).type === 'import') (window as unknown as { imports: number }).imports += 1;
    post.apply(this, given as Parameters<typeof post>);
  };
}

const give = (app: App): Promise<void> => app.by('file-input').setInputFiles(path.join(folder, `bench-${FACES}.glb`));
const camera = (app: App): Promise<number[]> =>
  app.page.evaluate(() => Array.from(window.__shapespline!.project([0, 0, 0, 1, 1, 1])));
const opacity = (app: App): Promise<string> =>
  app.page.locator('.picture canvas').evaluate((canvas) => getComputedStyle(canvas).opacity);
/** Waits until the first key is on the screen, with a number of vertices that no sample has. */
const whenShown = async (app: App): Promise<void> => {
  await app.page.waitForFunction(() => window.__shapespline!.positions().length > 3 * 40_000);
};

test('the first key of a large file is shown until its motion is ready', async ({ app }) => {
  const letGo = await held(app);
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.page.evaluate(countImports);
  letGo('import');
  await give(app);
  await whenShown(app);
  const [key, fitted] = [await app.positions(), await camera(app)];
  expect((await app.state()).source.kind).toBe('sample');
  await expect(app.by('progress')).toBeVisible();
  await expect.poll(() => opacity(app)).toBe('1');
  const keysOpacity = (): Promise<string> =>
    app.page.locator('.key-strip').evaluate((strip) => getComputedStyle(strip).opacity);
  await expect.poll(keysOpacity).toBe('0.4');
  letGo('encode');
  await expect.poll(async () => (await app.state()).source.kind, { timeout: 60_000 }).toBe('files');
  await expect.poll(keysOpacity).toBe('1');
  expect((await app.state()).play.playing).toBe(true);
  expect(difference(await camera(app), fitted)).toBeLessThan(1);
  expect(difference(await app.positionsAt(0), key)).toBeLessThan(1e-5 * diagonal(key));
  expect(await app.page.evaluate(() => (window as unknown as { imports: number }).imports)).toBe(1);
  await app.expectNoProblems();
});

test('the open shape is dimmed and paused until then, and returns on Cancel', { tag: '@all' }, async ({ app }) => {
  const letGo = await held(app);
  await app.open({ hash: '#sample=cactus&play=1' });
  const [before, vertices] = [await camera(app), (await app.positions()).length];
  await give(app);
  await expect.poll(async () => Number(await opacity(app))).toBeLessThan(0.5);
  const { time } = await app.state();
  letGo('import');
  await whenShown(app);
  expect((await app.state()).time).toBe(time);
  await app.by('cancel').click();
  await expect.poll(async () => (await app.positions()).length).toBe(vertices);
  expect(await camera(app)).toEqual(before);
  expect(await opacity(app)).toBe('1');
  // Playback continues.
  await expect.poll(async () => (await app.state()).time).not.toBe(time);
  expect((await app.state()).source).toEqual({ kind: 'sample', id: 'cactus' });
  const t = 0.4;
  const drawn = await app.positionsAt(t);
  const exact = await app.page.evaluate(async (at) => Array.from(await window.__shapespline!.evaluate(at)), t);
  expect(difference(drawn, exact)).toBe(0);
  await app.expectNoProblems();
});
