/** Cost of opening a GLB in other engines, each time in a new process. */
import { execFile } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { chromium, type Page } from '@playwright/test';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';
import { developmentGuards, serve } from '../../wasm/toolchain/serve.mjs';
import type { Loaded } from './load-babylon.ts';
import { residentOf } from './process-memory.ts';

/** The path is relative to the bundle, build/node/bench.mjs. */
const babylonProgram = fileURLToPath(new URL('load-babylon.mjs', import.meta.url));
const WAIT_MS = 300_000;

export interface InThree {
  /** Seconds until the scene is loaded, and from then until its first frame. */
  seconds: number;
  /** A message if nothing was drawn. */
  firstFrame: number | string;
  /** Bytes of the morph target textures. */
  textureMB: number;
  /** Growth of all browser processes, including the textures of a software GPU. */
  memoryMB: number;
}

/** A message if the file could not be opened. */
export type Played<T> = T | string;

type InPage = Omit<InThree, 'memoryMB'> & { graphicsError: string | null };

const sum = (values: number[]): number => values.reduce((total, value) => total + value, 0);

async function loadInThree(page: Page, url: string): Promise<Played<InPage>> {
  const errors: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  page.on('crash', () => errors.push('the page crashed'));
  const loaded = page.evaluate(
    (file) => (window as never as Record<string, (url: string) => InPage>).loadInThree!(file),
    url,
  );
  const late = new Promise<string>((resolve) =>
    setTimeout(() => resolve(`not within ${WAIT_MS / 1000} s`), WAIT_MS).unref(),
  );
  const crashed = new Promise<string>((resolve) => page.once('crash', () => resolve('the page crashed')));
  const result = await Promise.race([loaded.catch((error: Error) => error.message.split('\n')[0]!), late, crashed]);
  if (typeof result === 'string') return result;
  if (result.graphicsError !== null) return { ...result, firstFrame: result.graphicsError };
  return errors[0]?.slice(0, 100) ?? result;
}

/** `file` is below `repository`, which is served. */
export async function inThree(repository: string, file: string): Promise<Played<InThree>> {
  const { url, server } = await serve(repository, { port: 4275, headers: developmentGuards });
  const args = [
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ];
  const browser = await chromium.launchServer({ executablePath: findBrowser(chromium) ?? undefined, args });
  const pid = browser.process().pid!;
  try {
    const page = await (await chromium.connect(browser.wsEndpoint())).newPage();
    await page.goto(`${url}tests/bench/three.html`);
    await page.waitForFunction(() => 'loadInThree' in window);
    const before = sum((residentOf(pid) ?? []).map(({ now }) => now));
    const loaded = await loadInThree(page, url + path.relative(repository, file).split(path.sep).join('/'));
    if (typeof loaded === 'string') return loaded;
    const peak = sum((residentOf(pid) ?? []).map((one) => one.peak));
    return { ...loaded, memoryMB: peak - before };
  } finally {
    await browser.close();
    server.close();
  }
}

export async function inBabylon(file: string): Promise<Played<Loaded>> {
  try {
    const { stdout } = await promisify(execFile)(process.execPath, [babylonProgram, file], { timeout: WAIT_MS });
    return JSON.parse(stdout.trim().split('\n').at(-1)!) as Loaded;
  } catch (error) {
    const { killed, stderr } = error as { killed?: boolean; stderr?: string };
    return killed
      ? `not within ${WAIT_MS / 1000} s`
      : (/(?:Error|FATAL ERROR): .*/.exec(stderr ?? '')?.[0] ?? 'failed').slice(0, 100);
  }
}
