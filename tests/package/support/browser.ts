/** Hosts of pages, and Chromium, whose requests to any other host are recorded and refused. */
import { readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import path from 'node:path';
import { type Browser, type BrowserContextOptions, type Page, chromium } from '@playwright/test';
import { afterAll, beforeAll, expect } from 'vitest';
import { findBrowser } from '../../../wasm/toolchain/chromium.mjs';
import type { Outcome } from './project.ts';

const TYPES: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.glb': 'model/gltf-binary',
};

const servers: Server[] = [];

/** A time limit longer than any step on a busy machine. */
const WAIT_MS = 90_000;

async function listen(server: Server, name: string): Promise<string> {
  servers.push(server);
  await new Promise<void>((ready) => server.listen(0, name, ready));
  return `http://${name}:${(server.address() as AddressInfo).port}/`;
}

/**
 * Serves the first of the folders that has a file. `headers` go with every response; `spare` is the response for
 * missing files, as on single-page hosts.
 */
export function host(
  folders: string[],
  { name = 'localhost', headers = {}, spare }: { name?: string; headers?: Record<string, string>; spare?: string } = {},
): Promise<string> {
  const server = createServer((request, response) => {
    const wanted = new URL(request.url ?? '/', 'http://localhost').pathname.slice(1) || 'index.html';
    for (const folder of folders) {
      try {
        const content = readFileSync(path.join(folder, wanted));
        const type = TYPES[path.extname(wanted)] ?? 'text/plain';
        return void response.writeHead(200, { 'content-type': type, ...headers }).end(content);
      } catch {
        // the next folder may have the file
      }
    }
    if (spare) response.writeHead(200, { 'content-type': 'text/html', ...headers }).end(spare);
    else response.writeHead(404, { 'content-type': 'text/plain', ...headers }).end('not found');
  });
  return listen(server, name);
}

let browser: Browser;
let proxy: string;
/** Requested URLs on other hosts. */
const elsewhere: string[] = [];

beforeAll(async () => {
  const refusing = createServer((request, response) => {
    elsewhere.push(request.url ?? '');
    response.writeHead(502).end();
  });
  refusing.on('connect', (request, socket) => {
    elsewhere.push(request.url ?? '');
    socket.end('HTTP/1.1 502 no\r\n\r\n');
  });
  proxy = await listen(refusing, '127.0.0.1');
  browser = await chromium.launch({
    executablePath: findBrowser(chromium) ?? undefined,
    args: [
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--no-first-run',
      ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
    ],
  });
});

afterAll(async () => {
  await browser?.close();
  for (const server of servers.splice(0)) {
    server.closeAllConnections();
    server.close();
  }
});

/** Requests to other hosts since the last call. */
export const askedElsewhere = (): string[] => elsewhere.splice(0);

/** A page in a new browser context, which the caller closes. */
export async function newPage(options: BrowserContextOptions = {}): Promise<Page> {
  askedElsewhere();
  const context = await browser.newContext({ proxy: { server: proxy, bypass: 'localhost,127.0.0.1' }, ...options });
  const page = await context.newPage();
  // A development server prepares files while the page waits.
  page.setDefaultTimeout(WAIT_MS);
  return page;
}

/** The page's final text. Also checks that no other host received a request. */
export async function outcomeOf(url: string): Promise<Outcome> {
  const page = await newPage();
  try {
    const errors: string[] = [];
    page.on('pageerror', (error) => void errors.push(String(error)));
    await page.goto(url);
    const outcome = (await saidOn(page)) ?? { error: `nothing was said; ${errors.join('; ')}` };
    expect(askedElsewhere()).toEqual([]);
    return outcome;
  } finally {
    await page.context().close();
  }
}

/** A development server may reload the page at any time after finding its dependencies. */
async function saidOn(page: Page): Promise<Outcome | null> {
  for (const end = Date.now() + WAIT_MS; Date.now() < end && !page.isClosed(); ) {
    const timeout = Math.max(1, end - Date.now());
    const said = page.waitForFunction(() => (window as { outcome?: unknown }).outcome, undefined, { timeout });
    const outcome = await said.then((handle) => handle.jsonValue() as Promise<Outcome>).catch(() => null);
    if (outcome) return outcome;
  }
  return null;
}
