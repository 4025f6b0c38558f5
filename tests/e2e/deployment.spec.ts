/** Publishing a new build of the page while a tab is open. */
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { writeServiceWorker } from '../../web/offline/plugin.ts';
import { App, expect, test } from './support.ts';

test.use({ ownProfile: true });

const BUILT = fileURLToPath(new URL('../../dist', import.meta.url));
const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
};

/** A single-page host: it returns the start page for missing files. */
class Host {
  readonly folder = mkdtempSync(path.join(tmpdir(), 'deployment-'));
  readonly #server: Server;

  constructor() {
    cpSync(BUILT, this.folder, { recursive: true });
    this.#server = createServer((request, response) => {
      const name = new URL(request.url ?? '/', 'http://localhost').pathname.slice(1) || 'index.html';
      const send = (file: string): void => {
        const content = readFileSync(path.join(this.folder, file));
        response
          .writeHead(200, { 'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream' })
          .end(content);
      };
      try {
        send(name);
      } catch {
        send('index.html');
      }
    });
  }

  async listen(): Promise<string> {
    await new Promise<void>((ready) => this.#server.listen(0, 'localhost', ready));
    return `http://localhost:${(this.#server.address() as AddressInfo).port}/`;
  }

  /** The next build: every file with a digest in its name is renamed, and files of the last build are gone. */
  deploy(mark: string): void {
    const assets = path.join(this.folder, 'assets');
    const names = readdirSync(assets).map((name) => [name, name.replace(/\.(\w+)$/, `${mark}.$1`)] as const);
    for (const [from, to] of names) renameSync(path.join(assets, from), path.join(assets, to));
    const texts = [...names.map(([, to]) => path.join('assets', to)), 'index.html', 'play.html'];
    for (const file of texts.filter((name) => /\.(js|css|html)$/.test(name))) {
      const full = path.join(this.folder, file);
      writeFileSync(
        full,
        names.reduce((text, [from, to]) => text.replaceAll(from, to), readFileSync(full, 'utf8')),
      );
    }
    writeServiceWorker(this.folder);
  }

  close(): void {
    this.#server.close();
    this.#server.closeAllConnections();
    rmSync(this.folder, { recursive: true, force: true });
  }
}

const entry = (app: App): Promise<string> =>
  app.page.evaluate(() => document.querySelector<HTMLScriptElement>('script[type="module"]')!.src);

const kept = (app: App): Promise<string[]> =>
  app.page.evaluate(async () => {
    const caches = await Promise.all((await window.caches.keys()).map((name) => window.caches.open(name)));
    return (await Promise.all(caches.map((cache) => cache.keys()))).flat().map(({ url }) => url);
  });

async function open(app: App, url: string): Promise<void> {
  await app.page.goto(url);
  await app.started();
}

const askForUpdate = (app: App): Promise<void> =>
  app.page.evaluate(async () => {
    await (await navigator.serviceWorker.ready).update();
  });

/** Requires a worker script and decoders that the page has not loaded so far. */
async function opensAnotherSample(app: App): Promise<void> {
  const before = await app.positions();
  await app.pick('octopus');
  await app.settled();
  await expect(app.by('error')).toBeHidden();
  expect(await app.positions()).not.toEqual(before);
}

test(
  'does not change open tabs, is offered, and replaces the old build on request',
  { tag: '@all' },
  async ({ app, context }, info) => {
    test.skip(info.project.name === 'dev', 'the development server has no service worker');
    const host = new Host();
    try {
      const url = await host.listen();
      await open(app, url);
      await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
      const other = new App(await context.newPage());
      await open(other, url);
      const first = await entry(app);
      await expect(app.by('new-version')).toBeHidden();

      host.deploy('B');
      await askForUpdate(app);
      await expect(app.by('new-version')).toBeVisible();
      await expect(other.by('new-version')).toBeVisible();
      await opensAnotherSample(app);

      await app.by('new-version-accept').click();
      await expect.poll(() => entry(app).catch(() => first)).not.toBe(first);
      const second = await entry(app);
      await expect(app.by('new-version')).toBeHidden();
      // The other tab continues, with the new service worker and the old files.
      await opensAnotherSample(other);
      expect(await entry(other)).toBe(first);
      expect(await kept(other)).toEqual(expect.arrayContaining([first, second]));
      await app.expectNoProblems();

      // The old files are removed when no page uses them.
      await other.page.close();
      await open(app, url);
      await expect.poll(async () => (await kept(app)).includes(first)).toBe(false);
      expect(await kept(app)).toContain(second);
    } finally {
      host.close();
    }
  },
);

test('the cache stores only the right file under each name', { tag: '@all' }, async ({ app }, info) => {
  test.skip(info.project.name === 'dev', 'the development server has no service worker');
  const host = new Host();
  try {
    const url = await host.listen();
    await open(app, url);
    await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const wrong = await app.page.evaluate(async () => {
      const response = await fetch('./assets/index-gone.js');
      return response.headers.get('content-type');
    });
    expect(wrong).toBe('text/html');
    // A build published file by file: its file list appears before its files.
    host.deploy('C');
    rmSync(path.join(host.folder, 'assets', readdirSync(path.join(host.folder, 'assets'))[0]!));
    await askForUpdate(app).catch(() => undefined);
    await expect
      .poll(() =>
        app.page.evaluate(async () => {
          const { installing, waiting } = await navigator.serviceWorker.ready;
          return [installing, waiting];
        }),
      )
      .toEqual([null, null]);
    await expect(app.by('new-version')).toBeHidden();
    const types = await app.page.evaluate(async () => {
      const responses = await Promise.all(
        (await caches.keys()).map(async (name) => {
          const cache = await caches.open(name);
          const requests = (await cache.keys()).filter(({ url: asset }) => asset.includes('/assets/'));
          return Promise.all(
            requests.map(async (request) => (await cache.match(request))!.headers.get('content-type')),
          );
        }),
      );
      return responses.flat();
    });
    expect(types.length).toBeGreaterThan(5);
    expect(types).not.toContain('text/html');
    await open(app, url.replace(/$/, '?again'));
  } finally {
    host.close();
  }
});

/** Only a browser has a service worker with its cache and cached scripts. */
test('damaged files in the cache are fetched again, with a message', { tag: '@all' }, async ({ app }, info) => {
  test.skip(info.project.name === 'dev', 'the development server has no service worker');
  const host = new Host();
  try {
    const url = await host.listen();
    await open(app, url);
    await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await app.page.evaluate(async () => {
      for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const [i, request] of (await cache.keys()).entries()) {
          const bytes = await (await cache.match(request))!.arrayBuffer();
          const type = request.url.endsWith('.js') ? 'text/javascript' : 'text/css';
          const damaged = [
            new Response(bytes.slice(1), { headers: { 'content-type': type } }),
            new Response('', { headers: { 'content-type': type } }),
            new Response('<!doctype html>', { headers: { 'content-type': 'text/html' } }),
            new Response(bytes),
          ];
          if (request.url.includes('/assets/')) await cache.put(request, damaged[i % damaged.length]!);
        }
      }
    });
    await open(app, url);
    await expect(app.by('toast')).toContainText('damaged. It was fetched again.');
    await opensAnotherSample(app);
    await open(app, url);
    await app.settled();
    await expect(app.by('toast')).not.toContainText('damaged');
    // Pages come from the network first, which replaces their copy.
    const page = (): Promise<string> =>
      app.page.evaluate(async () => (await caches.match(location.href))?.text() ?? '');
    const whole = await page();
    expect(whole).toContain('<title>shapespline');
    for (const damaged of ['', null]) {
      await app.page.evaluate(async (text) => {
        const cache = await caches.open((await caches.keys())[0]!);
        if (text === null) await cache.delete(location.href);
        else await cache.put(location.href, new Response(text, { headers: { 'content-type': 'text/html' } }));
      }, damaged);
      expect(await page()).toBe('');
      await open(app, url);
      await expect.poll(page).toBe(whole);
    }
  } finally {
    host.close();
  }
});

test('a page whose files are gone offers to reload, with its edits', { tag: '@all' }, async ({ app }, info) => {
  test.skip(info.project.name === 'dev', 'only a build has a digest in the names of its files');
  const host = new Host();
  try {
    await app.page.addInitScript(() => delete (Navigator.prototype as { serviceWorker?: unknown }).serviceWorker);
    await open(app, await host.listen());
    const first = await entry(app);
    await app.by('boundary-hermite').check();
    await app.settled();
    host.deploy('D');
    // The export dialog is loaded on first use.
    await app.by('export').click();
    await expect(app.by('error-message')).toContainText('There is a new version of this page. Reload it');
    await app.by('error-retry').click();
    await expect.poll(() => entry(app).catch(() => first)).not.toBe(first);
    await app.started();
    expect((await app.state()).doc.motion.boundary).toBe('hermite');
  } finally {
    host.close();
  }
});
