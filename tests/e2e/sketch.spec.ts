/** What moves while large files are opened: an approximate shape, then the exact one, or what was open before. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

// What a service worker answers cannot be held.
test.use({ contextOptions: { reducedMotion: 'no-preference', serviceWorkers: 'block' }, ownProfile: true });

const generator = fileURLToPath(new URL('../../build/cmake-wasm/shapespline_samples.js', import.meta.url));
const FACES = 200_000;
let folder = '';
test.beforeAll(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'shapespline-sketch-'));
  execFileSync(process.execPath, [generator, '--bench', String(FACES), folder], { stdio: 'ignore' });
});
test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** The work on the large mesh waits at its first report until it is let go; its sketch is made by another worker. */
async function held(app: App): Promise<() => void> {
  let free = false;
  await app.page.route(/engine\.worker.*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `(${waitAtReport.toString()})(${FACES});\n${await response.text()}` });
  });
  await app.page.route('**/may-go-on', (route) => route.fulfill({ body: String(free) }));
  return () => {
    free = true;
  };
}

/** In a worker. */
function waitAtReport(faces: number): void {
  const post = self.postMessage.bind(self) as (message: { type: string }, options: object) => void;
  let waits = false;
  self.addEventListener('message', ({ data }: MessageEvent<{ type: string; faces?: Uint32Array }>) => {
    waits ||= data.type === 'create' && data.faces?.length === 3 * faces;
  });
  self.postMessage = ((message: { type: string }, options: object) => {
    post(message, options);
    while (waits && message.type === 'progress') {
      const request = new XMLHttpRequest();
      request.open('GET', new URL('may-go-on', self.location.origin), false);
      request.send();
      waits = request.responseText !== 'true';
    }
  }) as typeof self.postMessage;
}

const drop = (app: App): Promise<void> => app.by('file-input').setInputFiles(path.join(folder, `bench-${FACES}.glb`));
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

test('a large file moves before its motion is made, and exactly from there on', { tag: '@all' }, async ({ app }) => {
  const letGo = await held(app);
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.page.evaluate(watch);
  await drop(app);
  await whenSketched(app);
  const fitted = await camera(app);
  await app.page.waitForFunction(() => {
    const { seen } = window as unknown as { seen: Seen[] };
    return new Set(seen.map(({ sketch }) => sketch).filter((time) => time !== null)).size > 1;
  });
  letGo();
  await expect.poll(async () => (await app.state()).source.kind, { timeout: 60_000 }).toBe('files');
  expect((await app.state()).play.playing).toBe(true);
  const there = await camera(app);
  for (const [i, x] of there.entries()) expect(Math.abs(x - fitted[i]!)).toBeLessThan(2);
  const seen = await app.page.evaluate(() => (window as unknown as { seen: Seen[] }).seen);
  const sketches = seen.filter(({ sketch }) => sketch !== null);
  // What is open is what was open, the time goes on, and the page says what it is.
  expect(new Set(sketches.map(({ source }) => source))).toEqual(new Set(['sample']));
  const [first] = sketches;
  for (const { sketch, stage } of sketches) if (sketch !== first!.sketch) expect(stage).toContain('approximate');
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
