/** Common parts of the end-to-end tests: the page with its hook, and real inputs if available. */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { test as base, expect } from '@playwright/test';
import type { BrowserContext, ConsoleMessage, Locator, Page, Request } from '@playwright/test';
import type { SequenceStats } from '../../web/engine/api/types.ts';
import type { AppState } from '../../web/model/state.ts';
import type {} from '../../web/app/test-hook.ts';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const generator = path.join(repository, 'build/cmake-wasm/shapespline_meshes.js');
const dataFolder = process.env['SHAPESPLINE_DATA'] ?? path.join(repository, '..', 'shared', 'data');

/** Path of a real input; null if the folder is missing. With SHAPESPLINE_DATA_REQUIRED=1 the input must exist. */
export function realFile(name: string): string | null {
  const file = path.join(dataFolder, name);
  if (existsSync(file)) return file;
  if (process.env['SHAPESPLINE_DATA_REQUIRED'] === '1') throw new Error(`${file} is missing`);
  return null;
}

export interface OpenOptions {
  /** Opens the page as on a first visit, on a separate page. */
  first?: boolean;
  search?: string;
  hash?: string;
  sample?: string;
}

/** Browser messages caused by the test environment: no service worker, no GPU compositing. */
const OF_THE_TESTS = /Service Worker registration blocked by Playwright|GPU stall due to ReadPixels/;

const GUIDE = /^#(tour|figure)=/;

export class App {
  readonly problems: string[] = [];
  readonly requests: string[] = [];
  private opened = false;
  private readonly onConsole = (message: ConsoleMessage): void => {
    if (['error', 'warning'].includes(message.type()) && !OF_THE_TESTS.test(message.text()))
      this.problems.push(`${message.type()}: ${message.text()}`);
  };
  private readonly onException = (error: Error): void => void this.problems.push(`exception: ${error.message}`);
  private readonly onRequest = (request: Request): void => void this.requests.push(request.url());

  /** `shared`: an earlier test may have opened the app on this page. */
  constructor(
    readonly page: Page,
    private readonly shared = false,
  ) {
    page.on('console', this.onConsole).on('pageerror', this.onException).on('request', this.onRequest);
  }

  /** Further events on the page belong to another test. */
  leave(): void {
    const { page } = this;
    page.off('console', this.onConsole).off('pageerror', this.onException).off('request', this.onRequest);
  }

  /**
   * Opens the page with empty storage and waits for the first shape, without playback by default. The first call of a
   * test resets an open page instead of loading it.
   */
  async open({ first = false, search = '', hash = '', sample }: OpenOptions = {}): Promise<this> {
    const fragment = sample ? `#sample=${sample}` : hash;
    const again = this.opened;
    this.opened = true;
    if (!again && this.shared) {
      if (search === '' && !GUIDE.test(fragment) && (await this.reset(fragment))) return this;
      // The guide restores the earlier content; URL options take effect only when the page is loaded.
      const { origin } = new URL(this.page.url());
      await this.page.goto('about:blank');
      if (origin !== 'null') await forget(this.page, origin);
    }
    if (!first)
      await this.page.addInitScript(() => {
        if (location.protocol !== 'about:') localStorage.setItem('shapespline.visited', '1');
      });
    await this.page.goto(`./${search}${fragment}`);
    await this.started();
    return this;
  }

  /** Returns whether a reset was possible: the loaded page is the app, without URL options. */
  private async reset(fragment: string): Promise<boolean> {
    return this.page.evaluate(async (to) => {
      if (!window.__shapespline || location.search !== '') return false;
      await window.__shapespline.reset(to);
      return true;
    }, fragment);
  }

  /** Reloads the page once nothing would be lost, and waits for its first shape. */
  async reload(): Promise<void> {
    const asks = (): Promise<boolean> =>
      this.page.evaluate(() => !window.dispatchEvent(new Event('beforeunload', { cancelable: true })));
    await expect.poll(asks).toBe(false);
    await this.page.reload();
    await this.started();
  }

  /** Waits for the first shape of a page being loaded. */
  async started(): Promise<void> {
    await this.page.waitForFunction(() => window.__shapespline !== undefined);
    await this.page.evaluate(() => window.__shapespline!.ready);
    await this.settled();
  }

  /** Opens a generated mesh with three keys instead of the current content (tests/shapes/bench_mesh.h). */
  async openGenerated(faces: number): Promise<void> {
    const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-generated-'));
    try {
      execFileSync(process.execPath, [generator, '--bench', String(faces), folder], { stdio: 'ignore' });
      await this.by('file-input').setInputFiles(path.join(folder, `bench-${faces}.glb`));
      await expect.poll(async () => (await this.state()).source.kind).toBe('files');
      await this.settled();
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  }

  /** Opens a sample from the gallery. */
  async pick(id: string): Promise<void> {
    await this.by('sample').click();
    await this.by(`sample-card-${id}`).click();
    await expect.poll(async () => (await this.state()).source).toEqual({ kind: 'sample', id });
  }

  /** The browser's own drag and drop, which supports folders. */
  async drop(files: string[], at = { x: 400, y: 300 }): Promise<void> {
    await this.drag(['dragEnter', 'dragOver', 'drop'], files, at);
  }

  /** Drags files over a position. An element that appears there receives the second move. */
  async dragOver(files: string[], at: { x: number; y: number }): Promise<void> {
    await this.drag(['dragEnter', 'dragOver', 'dragOver'], files, at);
  }

  private async drag(
    types: readonly ('dragEnter' | 'dragOver' | 'drop')[],
    files: string[],
    at: { x: number; y: number },
  ): Promise<void> {
    const session = await this.page.context().newCDPSession(this.page);
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of types) await session.send('Input.dispatchDragEvent', { type, ...at, data });
    await session.detach();
  }

  by(testId: string): Locator {
    return this.page.getByTestId(testId);
  }

  settled(): Promise<void> {
    return this.page.evaluate(() => window.__shapespline!.settled());
  }

  /** All plots of the panel show the motion. Until then, text above a plot can still appear and move it. */
  async analysed(): Promise<void> {
    await expect(this.by('panel-analysis')).not.toHaveAttribute('data-stale');
    await expect(this.by('panel-analysis').locator('[aria-busy=true]')).toHaveCount(0);
  }

  /** The page shows a choice with the next frame; until then its controls show the old one. */
  nextFrame(): Promise<void> {
    return this.page.evaluate(
      () =>
        new Promise((done) => {
          requestAnimationFrame(() => requestAnimationFrame(() => done()));
        }),
    );
  }

  state(): Promise<AppState> {
    return this.page.evaluate(() => window.__shapespline!.state);
  }

  stats(): Promise<SequenceStats> {
    return this.page.evaluate(async () => (await window.__shapespline!.stats())!);
  }

  async setTime(t: number): Promise<void> {
    await this.page.evaluate((time) => window.__shapespline!.setTime(time), t);
  }

  /** Drawn positions, xyz interleaved. */
  async positions(view = 0): Promise<number[]> {
    return this.page.evaluate((index) => Array.from(window.__shapespline!.positions(index)), view);
  }

  async positionsAt(t: number, view = 0): Promise<number[]> {
    await this.setTime(t);
    return this.positions(view);
  }

  /** The canvas on the screen, without its overlays. */
  async picture(): Promise<Buffer> {
    await this.settled();
    const style = await this.page.addStyleTag({
      content: '.viewport > :not(.picture), .toast { visibility: hidden !important; transition: none !important }',
    });
    const clip = (await this.by('viewport').boundingBox())!;
    const shot = await this.page.screenshot({ clip });
    // The page can add elements of its own meanwhile.
    await style.evaluate((element) => (element as Element).remove());
    return shot;
  }

  async expectNoProblems(): Promise<void> {
    expect(this.problems).toEqual([]);
  }
}

interface Fixtures {
  app: App;
  /**
   * Image pixels per page pixel in each direction; half the cost of a frame is its pixels. Tests of image details use
   * 1.
   */
  sharpness: number;
  /** A separate page, for tests that watch the page load, change its functions, or need empty storage. */
  fresh: boolean;
  /** A separate browser profile, for tests with a service worker or other user settings; the slowest option. */
  ownProfile: boolean;
}

interface Shared {
  profile: BrowserContext;
  /** First page of the browser, whose process all pages share. */
  first: Page;
  /** The page shared by tests, at this sharpness. */
  page: Page | null;
  sharpness: number;
}

interface WorkerFixtures {
  shared: Shared;
}

const VIEWPORT = { width: 1280, height: 720 };

export const test = base.extend<Fixtures, WorkerFixtures>({
  // Without autoplay the image does not change and can be compared.
  contextOptions: async ({ contextOptions }, use) => use({ ...contextOptions, reducedMotion: 'reduce' }),
  ownProfile: [false, { option: true }],
  fresh: [false, { option: true }],
  sharpness: [0.25, { option: true }],
  // Opening a page of a known site saves a process and most compilation, half the cost of opening. The first page stays
  // open, which keeps the process.
  shared: [
    async ({ browser }, use, { project }) => {
      const { baseURL } = project.use;
      const options = { baseURL, viewport: VIEWPORT, reducedMotion: 'reduce', serviceWorkers: 'block' } as const;
      const profile = await browser.newContext(options);
      const first = await profile.newPage();
      await first.goto('./icons/icon.svg');
      await use({ profile, first, page: null, sharpness: 0 });
      await profile.close();
    },
    { scope: 'worker' },
  ],
  context: async ({ browser, ownProfile, shared }, use) => {
    if (ownProfile) {
      const profile = await browser.newContext();
      await use(profile);
      return profile.close();
    }
    await use(shared.profile);
    for (const page of shared.profile.pages()) if (page !== shared.first && page !== shared.page) await page.close();
  },
  page: async ({ context, ownProfile, fresh, sharpness, shared }, use) => {
    if (!ownProfile && !fresh) {
      const page = await sharedPage(shared, sharpness);
      await use(page);
      return page.unrouteAll({ behavior: 'ignoreErrors' });
    }
    await shared.page?.close();
    shared.page = null;
    if (!ownProfile) await forget(shared.first, new URL(shared.first.url()).origin);
    await use(await drawnAt(sharpness, context));
  },
  app: async ({ page, shared }, use) => {
    const app = new App(page, page === shared.page);
    await use(app);
    app.leave();
  },
});

async function drawnAt(sharpness: number, context: BrowserContext): Promise<Page> {
  const page = await context.newPage();
  if (sharpness !== 1)
    await page.addInitScript((ratio) => Object.assign(window, { devicePixelRatio: ratio }), sharpness);
  return page;
}

/** Prepares the page as for the first test: the open page is reopened or reset. */
async function sharedPage(shared: Shared, sharpness: number): Promise<Page> {
  if (!shared.page || shared.sharpness !== sharpness || shared.page.isClosed()) {
    await shared.page?.close();
    await forget(shared.first, new URL(shared.first.url()).origin);
    shared.page = await drawnAt(sharpness, shared.profile);
    shared.sharpness = sharpness;
    return shared.page;
  }
  const { page } = shared;
  // A full-screen window cannot be resized.
  await page.evaluate(() => document.fullscreenElement && document.exitFullscreen());
  await page.setViewportSize(VIEWPORT);
  await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce', forcedColors: 'none' });
  await page.mouse.move(0, 0);
  return page;
}

/** Clears the storage of a site. */
async function forget(page: Page, origin: string): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
  await session.detach();
}

export { expect };

/** Largest distance between corresponding coordinates. */
export function difference(a: readonly number[], b: readonly number[]): number {
  expect(a.length).toBe(b.length);
  return a.reduce((most, value, index) => Math.max(most, Math.abs(value - b[index]!)), 0);
}

/** Minimum and maximum coordinate along an axis. */
export function extent(positions: readonly number[], axis: 0 | 1 | 2): [number, number] {
  const along = positions.filter((_, index) => index % 3 === axis);
  return along.reduce<[number, number]>(
    ([low, high], value) => [Math.min(low, value), Math.max(high, value)],
    [Infinity, -Infinity],
  );
}

export function diagonal(positions: readonly number[]): number {
  const size = [0, 1, 2].map((axis) => {
    const values = positions.filter((_, index) => index % 3 === axis);
    return values.reduce((a, b) => Math.max(a, b), -Infinity) - values.reduce((a, b) => Math.min(a, b), Infinity);
  });
  return Math.hypot(...size);
}

export function bytesOf(file: string): Buffer {
  return readFileSync(file);
}
