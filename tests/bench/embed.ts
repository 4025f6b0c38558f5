/**
 * npm run bench -- embed [FACES,...]: one, three and ten playing elements <shape-spline> on a page, each with its own
 * motion, from the package's one-file build. Reports the total frames computed and drawn per second; then for ten
 * elements with one in view.
 */
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium, type Page } from '@playwright/test';
import type { Size, Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import { findBrowser } from '../../wasm/toolchain/chromium.mjs';
import { developmentGuards, serve } from '../../wasm/toolchain/serve.mjs';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';

const DEFAULT_SIZES: Size[] = [{ faces: 10_000, keys: null }];
const SECONDS = 5;
const WAIT_MS = 300_000;
/** The path is relative to the bundle, build/node/bench.mjs. */
const build = fileURLToPath(new URL('..', import.meta.url));
const folder = path.join(build, 'bench-embed');

interface Rates {
  computed: number;
  drawn: number;
  /** Frames of elements out of view. */
  unseen: { computed: number; drawn: number };
  /** Milliseconds per frame in the worker: the median over the elements' last frames. */
  ms: number;
}

/** Of `count` elements, `seen` are in the first screen of the page. */
function writePage(faces: number, count: number, seen: number): string {
  const elements = Array.from(
    { length: count },
    (_, i) => `<shape-spline src="bench-${faces}.glb?${i}" loading="eager" autoplay loop="bounce"></shape-spline>`,
  );
  const gap = '<div class="gap"></div>';
  const name = `${faces}-${count}-${seen}.html`;
  const style =
    'body { margin: 0 } main { display: grid; grid-template-columns: repeat(4, 1fr); gap: 4px } .gap { height: 4000px }';
  const main = (list: readonly string[]): string => `<main>${list.join('')}</main>`;
  writeFileSync(
    path.join(folder, name),
    `<!doctype html><title>Elements</title><style>${style}</style><script type="module" src="cdn.js"></script>` +
      `${main(elements.slice(0, seen))}${gap}${main(elements.slice(seen))}`,
  );
  return name;
}

async function ratesOf(page: Page, url: string, count: number, seen: number): Promise<Rates> {
  await page.goto(url);
  await page.waitForFunction(
    (all) => {
      const shapes = [...document.querySelectorAll('shape-spline')] as ShapeSplineElement[];
      return shapes.filter(({ report }) => report !== null).length === all;
    },
    count,
    { timeout: WAIT_MS },
  );
  // The first frames compile shaders and allocate memory.
  await page.waitForTimeout(2000);
  return page.evaluate(
    async ([seconds, visible]) => {
      const shapes = [...document.querySelectorAll('shape-spline')] as ShapeSplineElement[];
      const stats = () => shapes.map((shape) => shape.stats);
      const [before, start] = [stats(), performance.now()];
      await new Promise((later) => setTimeout(later, 1000 * seconds!));
      const [after, passed] = [stats(), (performance.now() - start) / 1000];
      const rate = (name: 'framesComputed' | 'framesDrawn', from: number, to: number): number =>
        after.slice(from, to).reduce((sum, one, i) => sum + one[name] - before[from + i]![name], 0) / passed;
      const rates = (from: number, to: number) => ({
        computed: rate('framesComputed', from, to),
        drawn: rate('framesDrawn', from, to),
      });
      const ms = after
        .slice(0, visible)
        .map((one) => one.ms)
        .sort((a, b) => a - b);
      return { ...rates(0, visible!), unseen: rates(visible!, shapes.length), ms: ms[Math.floor(ms.length / 2)]! };
    },
    [SECONDS, seen],
  );
}

export async function benchEmbed({ sizes }: Wanted): Promise<void> {
  const library = path.join(build, 'package');
  if (!existsSync(path.join(library, 'cdn.js'))) {
    console.error('The package is not built yet: npm run build.');
    process.exitCode = 1;
    return;
  }
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const name of readdirSync(library).filter((file) => /^cdn\.js$|\.wasm$/.test(file)))
    copyFileSync(path.join(library, name), path.join(folder, name));
  const { url, server } = await serve(folder, { port: 4276, headers: developmentGuards });
  const args = [
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ];
  const browser = await chromium.launch({ executablePath: findBrowser(chromium) ?? undefined, args });
  console.log('| faces | elements | seen | computed/s | drawn/s | unseen: computed/s, drawn/s | ms a frame |');
  console.log('|---|---|---|---|---|---|---|');
  try {
    for (const { faces } of sizes ?? DEFAULT_SIZES) {
      const generator = path.join(build, 'cmake-wasm/shapespline_meshes.js');
      execFileSync(process.execPath, [generator, '--bench', String(faces), folder], {
        stdio: ['ignore', 'ignore', 'inherit'],
      });
      for (const [count, seen] of [
        [1, 1],
        [3, 3],
        [10, 10],
        [10, 1],
      ] as const) {
        const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
        const rates = await ratesOf(page, url + writePage(faces, count, seen), count, seen);
        await page.close();
        const numbers = [rates.computed, rates.drawn].map((rate) => rate.toFixed(1)).join(' | ');
        const unseen = `${rates.unseen.computed.toFixed(1)}, ${rates.unseen.drawn.toFixed(1)}`;
        console.log(`| ${faces} | ${count} | ${seen} | ${numbers} | ${unseen} | ${rates.ms.toFixed(1)} |`);
      }
    }
  } finally {
    await browser.close();
    server.close();
  }
}
