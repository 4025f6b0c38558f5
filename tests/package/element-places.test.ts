/**
 * The element in restricted environments: pages with Trusted Types, frames without an origin, pages without observers.
 * Only a browser has these policies and origins.
 */
import path from 'node:path';
import type { Page } from '@playwright/test';
import { afterEach, expect, it } from 'vitest';
import { askedElsewhere, host, newPage } from './support/browser.ts';
import { KEYS, POLICY, openElements, refused, told, useElements, when } from './support/element.ts';
import { newProject, packageIn } from './support/project.ts';

useElements();

const ONE = `<shape-spline id="a" src="${KEYS}" loading="eager" controls></shape-spline>`;
const TRUSTED = `${POLICY}; require-trusted-types-for 'script'`;

it.each([
  ['any policy', TRUSTED],
  ['its own policy alone', `${TRUSTED}; trusted-types shapespline`],
])('works where Trusted Types are required, with %s', async (_, policy) => {
  const page = await openElements(ONE, { policy });
  expect((await when(page, 'load'))!['vertices']).toBeGreaterThan(0);
  expect(await refused(page)).toEqual([]);
});

it('names the policy to list if Trusted Types are required and its policy is not listed', async () => {
  const page = await openElements(ONE, { policy: `${TRUSTED}; trusted-types others` });
  const { code, message } = (await when(page, 'error'))!;
  expect(code).toBe('not-loaded');
  expect(message).toMatch(/does not list this package's Trusted Types policy: add shapespline to its trusted-types\./);
});

it('reports that the policy refuses the worker', async () => {
  const page = await openElements(ONE, { policy: POLICY.replace('worker-src blob: LIBRARY', "worker-src 'none'") });
  const { message } = (await when(page, 'error'))!;
  expect(message).toMatch(/The page's policy blocks the worker: put worker\.js .* or allow blob: in its worker-src\./);
});

/** A page without an origin requires these headers. */
const CORS = { 'access-control-allow-origin': '*' };
let open: Page | null = null;
afterEach(async () => {
  await open?.context().close();
  expect(askedElsewhere()).toEqual([]);
});

/** The element of `entry` in a frame sandboxed without allow-same-origin. */
async function inFrame(forModels: Record<string, string> = CORS): Promise<{ type: string; text: string }> {
  const project = await newProject();
  const folder = path.join(project, 'public');
  const note = `for (const type of ['load', 'error'])
    document.addEventListener(type, ({ target, detail }) =>
      target.localName === 'shape-spline' && parent.postMessage({ type, text: detail.message ?? '' }, '*'), true);`;
  const library = await host([packageIn(project)], { name: '127.0.0.1', headers: CORS });
  const models = await host([folder], { headers: forModels });
  const sources = KEYS.split(' ').map((name) => models + name);
  const inner = `<!doctype html><title>In</title><script>${note}</script>
    <script type="module" src="${library}cdn.js"></script>
    <shape-spline src="${sources.join(' ')}" loading="eager" controls style="width: 300px"></shape-spline>`;
  const outer = `<!doctype html><title>Out</title>
    <script>addEventListener('message', ({ data }) => (window.said = data));</script>
    <iframe sandbox="allow-scripts" src="in.html" width="400" height="400"></iframe>`;
  const pages = await newProject({ 'public/in.html': inner, 'public/out.html': outer });
  const address = await host([path.join(pages, 'public')]);
  open = await newPage();
  await open.goto(`${address}out.html`);
  const said = await open.waitForFunction(() => (window as { said?: unknown }).said);
  return (await said.jsonValue()) as { type: string; text: string };
}

it('works in a sandboxed frame without an origin', async () => {
  expect(await inFrame()).toEqual({ type: 'load', text: '' });
});

it('reports that such a frame also needs CORS headers for the models', async () => {
  const { type, text } = await inFrame({});
  expect([type, text]).toEqual(['error', expect.stringMatching(/Could not fetch .*pose-0\.glb.*CORS headers/)]);
});

it('works on a page without observers and media preferences', async () => {
  const page = await openElements(ONE.replace('loading="eager"', ''), {
    before: () => {
      for (const name of ['IntersectionObserver', 'ResizeObserver', 'matchMedia'])
        delete (globalThis as Record<string, unknown>)[name];
    },
  });
  expect((await when(page, 'load'))!['vertices']).toBeGreaterThan(0);
  expect(await told(page, 'error')).toEqual([]);
});
