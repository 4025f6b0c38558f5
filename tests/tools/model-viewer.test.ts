/**
 * <model-viewer> in Chromium plays our files as on a web page, and its image matches the computed surface. Its script
 * is self-contained and uses no network.
 */
import { fileURLToPath } from 'node:url';
import { type Browser, chromium, type Page } from '@playwright/test';
import { Triangle, Vector3 } from 'three';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';
import { developmentGuards, serve } from '../../wasm/toolchain/serve.mjs';
import { changedShare } from '../e2e/png.ts';
import { paintedMotion, type Made } from './made.ts';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const executablePath = findBrowser(chromium);
const args = [
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
];

/** The used part of the element; https://modelviewer.dev/docs describes the rest. */
interface ModelViewer extends HTMLElement {
  src: string;
  loaded: boolean;
  availableAnimations: string[];
  duration: number;
  currentTime: number;
  play(): void;
  pause(): void;
  positionAndNormalFromPoint(x: number, y: number): { position: { x: number; y: number; z: number } } | null;
}

let made: Made;
let browser: Browser;
let served: Awaited<ReturnType<typeof serve>>;

beforeAll(async () => {
  if (!executablePath) return;
  made = await paintedMotion();
  served = await serve(repository, { port: 4290, headers: developmentGuards });
  browser = await chromium.launch({ executablePath, args });
});
afterAll(async () => {
  await browser?.close();
  served?.server.close();
});

interface Viewer {
  page: Page;
  /** Errors of the page, and requested URLs on other machines. */
  complaints: string[];
  /** Shows a time without playing; resolves when drawn. */
  showAt(seconds: number): Promise<void>;
}

async function opened(bytes: Uint8Array): Promise<Viewer> {
  const page = await browser.newPage({ viewport: { width: 420, height: 420 } });
  const complaints: string[] = [];
  page.on('pageerror', ({ message }) => complaints.push(message));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  await page.route(
    (url) => url.protocol !== 'blob:' && url.protocol !== 'data:' && url.origin !== new URL(served.url).origin,
    (route) => {
      complaints.push(route.request().url());
      return route.abort();
    },
  );
  await page.route('**/made.glb', (route) =>
    route.fulfill({ body: Buffer.from(bytes), contentType: 'model/gltf-binary' }),
  );
  // The package has this file under another name, for which servers send no script type.
  await page.route('**/meshopt_decoder.js', (route) =>
    route.fulfill({
      path: `${repository}node_modules/meshoptimizer/meshopt_decoder.cjs`,
      contentType: 'text/javascript',
    }),
  );
  await page.goto(`${served.url}tests/tools/model-viewer.html`);
  await page.evaluate(async () => {
    await customElements.whenDefined('model-viewer');
    const viewer = document.querySelector('model-viewer') as ModelViewer;
    const loaded = new Promise((resolve, reject) => {
      viewer.addEventListener('load', resolve, { once: true });
      viewer.addEventListener(
        'error',
        (event) => reject(new Error(JSON.stringify((event as unknown as CustomEvent).detail))),
        {
          once: true,
        },
      );
    });
    viewer.src = 'made.glb';
    await loaded;
  });
  const showAt = (seconds: number): Promise<void> =>
    page.evaluate(async (time) => {
      const viewer = document.querySelector('model-viewer') as ModelViewer;
      viewer.play();
      viewer.pause();
      viewer.currentTime = time;
      for (let i = 0; i < 3; i += 1) await new Promise(requestAnimationFrame);
    }, seconds);
  return { page, complaints, showAt };
}

/** Surface points seen through a grid of pixels. */
function shownPoints(page: Page): Promise<[number, number, number][]> {
  return page.evaluate(() => {
    const viewer = document.querySelector('model-viewer') as ModelViewer;
    const { left, top, width, height } = viewer.getBoundingClientRect();
    const points: [number, number, number][] = [];
    for (let i = 1; i < 48; i += 1)
      for (let j = 1; j < 48; j += 1) {
        const hit = viewer.positionAndNormalFromPoint(left + (i * width) / 48, top + (j * height) / 48);
        if (hit) points.push([hit.position.x, hit.position.y, hit.position.z]);
      }
    return points;
  });
}

/** The largest distance of some points from the surface at a time. */
async function offSurface(points: [number, number, number][], seconds: number): Promise<number> {
  const positions = await made.at(seconds);
  const { faces } = made.keys.info;
  const corner = (v: number): Vector3 => new Vector3().fromArray(positions, 3 * v);
  const triangles = Array.from(
    { length: faces.length / 3 },
    (_, f) => new Triangle(corner(faces[3 * f]!), corner(faces[3 * f + 1]!), corner(faces[3 * f + 2]!)),
  );
  const closest = new Vector3();
  const off = points.map((point) => {
    const at = new Vector3(...point);
    return Math.min(...triangles.map((triangle) => triangle.closestPointToPoint(at, closest).distanceTo(at)));
  });
  return Math.max(...off);
}

describe.skipIf(!executablePath)('<model-viewer>', () => {
  it.each([
    ['as few targets as needed', {}],
    ['the keys and in-betweens', { targets: 'principal' }],
    ['meshopt', { compression: 'meshopt' }],
  ] as const)('plays a GLB with %s', async (_, options) => {
    const { page, complaints, showAt } = await opened(await made.glb(options));
    await showAt(0);
    const { animations, duration } = await page.evaluate(() => {
      const viewer = document.querySelector('model-viewer') as ModelViewer;
      return { animations: viewer.availableAnimations, duration: viewer.duration };
    });
    expect(animations).toHaveLength(1);
    expect(duration).toBeCloseTo(1, 5);
    const pictures: Buffer[] = [];
    for (const seconds of [0, 0.3, 0.77]) {
      await showAt(seconds);
      pictures.push(await page.screenshot());
      const points = await shownPoints(page);
      expect(points.length).toBeGreaterThan(20);
      // The file's tolerance plus the rounding to 16 bits.
      expect(await offSurface(points, seconds)).toBeLessThan(1.1e-3 * made.diagonal);
    }
    expect(changedShare(pictures[0]!, pictures[1]!)).toBeGreaterThan(0.01);
    expect(changedShare(pictures[1]!, pictures[2]!)).toBeGreaterThan(0.01);
    const before = await page.evaluate(() => {
      const viewer = document.querySelector('model-viewer') as ModelViewer;
      viewer.play();
      return viewer.currentTime;
    });
    await expect
      .poll(() => page.evaluate(() => (document.querySelector('model-viewer') as ModelViewer).currentTime))
      .not.toBe(before);
    expect(complaints).toEqual([]);
    await page.close();
  });
});
