/** What moves while large files are opened: an approximate shape, then the exact one, or what was open before. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ contextOptions: { reducedMotion: 'no-preference' }, ownProfile: true });

const generator = fileURLToPath(new URL('../../build/cmake-wasm/shapespline_samples.js', import.meta.url));
const FACES = 200_000;
let folder = '';
test.beforeAll(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'shapespline-sketch-'));
  execFileSync(process.execPath, [generator, '--bench', String(FACES), folder], { stdio: 'ignore' });
});
test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** The engine's workers take so much longer over it that what happens meanwhile can be looked at. */
async function slowDown(app: App, ms = 2000): Promise<void> {
  await app.page.route(/engine\.worker.*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `(${pauseBetweenStages.toString()})(${ms});\n${await response.text()}` });
  });
}

/** In a worker: from the first shape of a sketch on a moment passes with each report, `ms` in all. */
function pauseBetweenStages(ms: number): void {
  const post = self.postMessage.bind(self) as (message: { type: string }, options: object) => void;
  let left = 0;
  let begun = false;
  self.postMessage = ((message: { type: string }, options: object) => {
    post(message, options);
    if (message.type === 'sketch' && !begun) left = ms;
    begun ||= message.type === 'sketch';
    const until = performance.now() + Math.min(left, 20);
    if (message.type === 'progress') left = Math.max(left - 20, 0);
    while (message.type === 'progress' && performance.now() < until);
  }) as typeof self.postMessage;
}

const drop = (app: App): Promise<void> => app.by('file-input').setInputFiles(path.join(folder, `bench-${FACES}.glb`));
const sketched = (app: App): Promise<number | null> => app.page.evaluate(() => window.__shapespline!.sketch);
const whenSketched = async (app: App): Promise<void> => {
  await app.page.waitForFunction(() => window.__shapespline!.sketch !== null);
};
const camera = (app: App): Promise<number[]> =>
  app.page.evaluate(() => Array.from(window.__shapespline!.project([0, 0, 0, 1, 1, 1])));

/** Notes what is on the screen, some times a second. */
function watch(): void {
  const seen: Seen[] = [];
  Object.assign(window, { seen });
  setInterval(() => {
    const { sketch, state } = window.__shapespline!;
    const stage = document.querySelector('[data-testid=stage]')?.textContent ?? '';
    seen.push({ sketch, source: state.source.kind, time: state.time, stage });
  }, 40);
}

interface Seen {
  sketch: number | null;
  source: string;
  time: number;
  stage: string;
}

test('a large file moves before its motion is made, and exactly from there on', async ({ app }) => {
  await slowDown(app, 4000);
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.page.evaluate(watch);
  await drop(app);
  await whenSketched(app);
  const fitted = await camera(app);
  await expect.poll(async () => (await app.state()).source.kind, { timeout: 60_000 }).toBe('files');
  expect((await app.state()).play.playing).toBe(true);
  const there = await camera(app);
  for (const [i, x] of there.entries()) expect(Math.abs(x - fitted[i]!)).toBeLessThan(2);
  const seen = await app.page.evaluate(() => (window as unknown as { seen: Seen[] }).seen);
  const sketches = seen.filter(({ sketch }) => sketch !== null);
  // What is open is what was open, the time goes on, and the page says what it is.
  expect(new Set(sketches.map(({ source }) => source))).toEqual(new Set(['sample']));
  expect(new Set(sketches.map(({ sketch }) => sketch)).size).toBeGreaterThan(1);
  for (const { stage } of sketches) expect(stage).toContain('approximate');
  // The motion goes on from there, and has not gone far yet.
  const opened = seen.find(({ source }) => source === 'files')!;
  expect(Math.abs(opened.time - sketches.at(-1)!.sketch!)).toBeLessThan(0.25);
  expect(seen.at(-1)!.sketch).toBeNull();
  await app.setTime(0.4);
  const off = await app.page.evaluate(async () => {
    const [drawn, exact] = [window.__shapespline!.positions(), await window.__shapespline!.evaluate(0.4)];
    return drawn.length === exact.length
      ? drawn.reduce((most, x, i) => Math.max(most, Math.abs(x - exact[i]!)), 0)
      : NaN;
  });
  expect(off).toBe(0);
  await app.expectNoProblems();
});

test('cancelled while it is sketched, what was open is there again, as it was and where it was looked at', async ({
  app,
}) => {
  await slowDown(app);
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.setTime(0.3);
  const [state, positions, view] = [await app.state(), await app.positions(), await camera(app)];
  await drop(app);
  await whenSketched(app);
  expect(await app.positions()).not.toHaveLength(positions.length);
  await app.by('cancel').click();
  await expect.poll(() => sketched(app)).toBeNull();
  await app.settled();
  expect(await app.state()).toEqual(state);
  expect(await app.positions()).toEqual(positions);
  expect(await camera(app)).toEqual(view);
  await app.setTime(0.6);
  expect((await app.state()).source).toEqual({ kind: 'sample', id: 'cactus' });
  await app.expectNoProblems();
});

test('what plays while a large file is opened rests, and plays on when that is given up', async ({ app }) => {
  await slowDown(app);
  await app.open({ hash: '#sample=cactus&t=0.2&play=1' });
  await app.page.evaluate(() => document.body.focus());
  if (!(await app.state()).play.playing) await app.page.keyboard.press('Space');
  await drop(app);
  await whenSketched(app);
  const { time } = await app.state();
  await app.nextFrame();
  expect((await app.state()).time).toBe(time);
  await app.by('cancel').click();
  await expect.poll(async () => (await app.state()).time).not.toBe(time);
  await app.expectNoProblems();
});

test('what is open and asked for while another file is sketched is shown again', async ({ app }) => {
  await slowDown(app);
  await app.open({ hash: '#sample=cactus&t=0.2' });
  const positions = await app.positions();
  await drop(app);
  await whenSketched(app);
  await app.setTime(0.5);
  expect(await sketched(app)).toBeNull();
  expect(await app.positions()).toHaveLength(positions.length);
  // The file is opened all the same.
  await expect.poll(async () => (await app.state()).source.kind, { timeout: 60_000 }).toBe('files');
});
