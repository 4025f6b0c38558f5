/**
 * Pages with <shape-spline> as a page author writes them: the one-file build on another host, on a page whose policy
 * allows scripts and styles of these two hosts and nothing inline. Element events and policy violations are recorded.
 */
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import type { BrowserContextOptions, Page } from '@playwright/test';
import { afterEach, beforeAll, expect, inject } from 'vitest';
import type { ShapeSplineElement } from '../../../web/embed/shape-spline.ts';
import { askedElsewhere, host, newPage } from './browser.ts';
import { newProject, packageIn } from './project.ts';

export interface Told {
  type: string;
  id: string;
  bubbles: boolean;
  detail: Record<string, unknown> | null;
}

declare global {
  interface Window {
    told: Told[];
    refused: string[];
    /** The WebGL contexts of the page. */
    contexts: WebGL2RenderingContext[];
  }
}

export interface Setting extends BrowserContextOptions {
  /** Replaces the policy in the package's README. */
  policy?: string;
  /** Runs before any other code of the page. */
  before?: () => void;
  /** Position of the script in the body, relative to the markup. */
  script?: 'first' | 'none';
  /** URL of the package's files. */
  library?: string;
}

/** The policy in the package's README. */
export const POLICY =
  "default-src 'none'; script-src 'self' LIBRARY 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; " +
  "connect-src 'self' LIBRARY; worker-src blob: LIBRARY; frame-src 'self'";

export const KEYS = 'pose-0.glb pose-1.glb';
const CORS = { 'access-control-allow-origin': '*' };
let folder = '';
let library = '';
let pages = 0;
const open: Page[] = [];
const problems: string[] = [];

/** Call in every file that uses this module. */
export function useElements(): void {
  beforeAll(async () => {
    library = await host([packageIn(inject('installed'))], { name: '127.0.0.1', headers: CORS });
    folder = path.join(await newProject(), 'public');
  });
  afterEach(async () => {
    for (const page of open.splice(0)) await page.context().close();
    expect(problems.splice(0)).toEqual([]);
    expect(askedElsewhere()).toEqual([]);
  });
}

export const write = (name: string, content: string | Uint8Array): void =>
  writeFileSync(path.join(folder, name), content);

export async function openElements(markup: string, setting: Setting = {}): Promise<Page> {
  const { policy = POLICY, before, script = 'first', library: from = library, ...context } = setting;
  const name = `page-${++pages}.html`;
  const tag = script === 'first' ? `<script type="module" src="${from}cdn.js"></script>` : '';
  write(
    'styles.css',
    'html { color-scheme: light dark } body { margin: 0; font: 16px sans-serif } #gap { display: block; height: 4000px }',
  );
  write(
    name,
    `<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>A page</title>` +
      `<link rel="stylesheet" href="styles.css">${tag}<body>${markup}`,
  );
  const headers = { 'content-security-policy': policy.replaceAll('LIBRARY', new URL(library).origin) };
  const address = await host([folder], { headers });
  const page = await newPage({ viewport: { width: 600, height: 800 }, ...context });
  open.push(page);
  page.on('pageerror', (error) => void problems.push(error.message));
  await page.addInitScript(note);
  if (before) await page.addInitScript(before);
  await page.goto(address + name);
  return page;
}

export const libraryAddress = (): string => library;

function note(): void {
  window.told = [];
  window.refused = [];
  window.contexts = [];
  document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
    window.refused.push(`${violatedDirective} ${blockedURI}`),
  );
  const types = 'load error progress play pause timeupdate seeked loopend keychange'.split(' ');
  for (const type of types) {
    document.addEventListener(
      type,
      (event) => {
        const { target, bubbles, detail } = event as CustomEvent<Told['detail']>;
        if (target instanceof Element && target.localName === 'shape-spline')
          window.told.push({ type, id: target.id, bubbles, detail });
      },
      { capture: true },
    );
  }
  const getContext = HTMLCanvasElement.prototype.getContext as (...words: unknown[]) => unknown;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...words: unknown[]) {
    const context = getContext.apply(this, words);
    if (context instanceof WebGL2RenderingContext && !window.contexts.includes(context)) window.contexts.push(context);
    return context;
  } as never;
}

/** Events of one kind that an element has sent so far. */
export const told = (page: Page, type: string, id = 'a'): Promise<Told['detail'][]> =>
  page.evaluate(
    ([what, whose]) => window.told.filter((one) => one.type === what && one.id === whose).map(({ detail }) => detail),
    [type, id] as const,
  );

/** Detail of the first event of that kind. */
export async function when(page: Page, type: string, id = 'a', count = 1): Promise<Told['detail']> {
  await page.waitForFunction(
    ([what, whose, times]) =>
      window.told.filter((one) => one.type === what && one.id === whose).length >= (times as number),
    [type, id, count] as const,
  );
  return (await told(page, type, id))[count - 1]!;
}

/** Runs a function in the page with the element. */
export const on = <T, A = null>(
  page: Page,
  work: (shape: ShapeSplineElement, words: A) => T | Promise<T>,
  words: A = null as A,
  id = 'a',
): Promise<T> =>
  page
    .evaluateHandle((name) => document.getElementById(name) as ShapeSplineElement, id)
    .then((shape) => shape.evaluate(work as never, words) as Promise<T>);

/** Frames that the element computed and drew, once the numbers are stable for half a second. */
export async function statsAtRest(page: Page, id = 'a'): Promise<object> {
  const stats = (): Promise<object> => on(page, (shape) => ({ ...shape.stats, t: shape.currentTime }), null, id);
  let last = await stats();
  const rests = async (): Promise<boolean> => {
    const before = last;
    await page.waitForTimeout(500);
    last = await stats();
    return JSON.stringify(last) === JSON.stringify(before);
  };
  await expect.poll(rests, { timeout: 30_000 }).toBe(true);
  return last;
}

export const seek = (page: Page, t: number, id = 'a'): Promise<void> =>
  on(page, (shape, time) => shape.seek(time), t, id);

/** The canvas image, as text. */
export const picture = (page: Page, id = 'a'): Promise<string> =>
  on(page, (shape) => shape.shadowRoot!.querySelector('canvas')!.toDataURL(), null, id);

export const refused = (page: Page): Promise<string[]> => page.evaluate(() => window.refused);
