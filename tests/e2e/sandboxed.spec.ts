/**
 * The built pages in a frame without an origin: `sandbox` without allow-same-origin, as a frame's attribute or in the
 * host's policy. Only a browser has such frames.
 */
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import type { Frame } from '@playwright/test';
import { guards, serve } from '../../wasm/toolchain/serve.mjs';
import { expect, test } from './support.ts';

// The hosts are the test's own.
test.use({ fresh: true });

const BUILT = fileURLToPath(new URL('../../dist', import.meta.url));
const CORS = { 'access-control-allow-origin': '*' };
const servers: Server[] = [];
test.afterEach(() => {
  for (const server of servers.splice(0)) server.close().closeAllConnections();
});

async function host(headers: Record<string, string>): Promise<string> {
  const { url, server } = await serve(BUILT, { port: 5300, tries: 200, headers });
  servers.push(server);
  return url;
}

/** A page of another host that shows the URL in a frame. */
async function framing(url: string, sandbox: string): Promise<string> {
  const page = `<!doctype html><title>Out</title><iframe sandbox="${sandbox}" src="${url}" width="1200" height="700"></iframe>`;
  const server = createServer((_, response) => response.writeHead(200, { 'content-type': 'text/html' }).end(page));
  servers.push(server);
  await new Promise<void>((ready) => server.listen(0, 'localhost', ready));
  return `http://localhost:${(server.address() as AddressInfo).port}/`;
}

async function verticesIn(frame: Frame): Promise<number> {
  await frame.waitForFunction(() => window.__shapespline !== undefined);
  return frame.evaluate(async () => {
    await window.__shapespline!.ready;
    // A shape that is replaced meanwhile has no counters.
    await window.__shapespline!.settled();
    return (await window.__shapespline!.stats())?.weldedVertices ?? 0;
  });
}

test('the page starts under a policy with sandbox', async ({ page }) => {
  const policy = `${guards['content-security-policy']}; sandbox allow-scripts`;
  const url = await host({ ...guards, ...CORS, 'content-security-policy': policy });
  await page.goto(url);
  expect(await page.evaluate(() => globalThis.origin)).toBe('null');
  expect(await verticesIn(page.mainFrame())).toBeGreaterThan(0);
  await page.goto(`${url}play.html`);
  await expect(page.getByText('The bent ruler')).toBeVisible();
});

test('the page starts in a sandboxed frame, and opens files', async ({ page }) => {
  await page.goto(await framing(await host(CORS), 'allow-scripts'));
  const frame = page.frames()[1]!;
  expect(await verticesIn(frame)).toBeGreaterThan(4);
  const obj = (z: number): string => `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 ${z}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n`;
  const files = [1, 2].map((z) => ({ name: `${z}.obj`, mimeType: 'model/obj', buffer: Buffer.from(obj(z)) }));
  await frame.getByTestId('file-input').setInputFiles(files);
  await expect.poll(() => verticesIn(frame)).toBe(4);
});

for (const name of ['index.html', 'play.html', 'embed/examples/index.html'])
  test(`${name} says so where its scripts cannot run`, async ({ page }) => {
    await page.goto(await framing(`${await host({})}${name}`, 'allow-scripts'));
    await expect(page.frames()[1]!.getByText(/scripts cannot run here\. Open .* in its own tab/)).toBeVisible();
    if (name.startsWith('embed')) return;
    await page.goto(await framing(`${await host({})}${name}`, ''));
    expect(await page.frames()[1]!.locator('body').innerText()).toContain('This page needs JavaScript');
  });
