/**
 * Each of the paper's figures as its preset shows it, compared with the stored image in `figures/`: the guide, the
 * stage and the panels separately. After an intended change: `SHAPESPLINE_ALL=1 npm test -- e2e figure-pictures
 * --update-snapshots=all`, and check the differences.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { FIGURES } from '../../web/app/guide/figures.ts';
import type { GuidePage } from '../../web/app/guide/guide-page.ts';
import { changedParts, partsOf, SHRUNK } from './kept-picture.ts';
import { shrink } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const folder = fileURLToPath(new URL('./figures', import.meta.url));
/** The images are stored at half their size. */
const KEPT = 2;

const PARTS = { guide: '.guide', stage: 'main', options: '.side', timeline: '[data-testid="timeline"]' };
/** Figures with charts of measured times, or with as many points as the machine has time for. */
const TIMED = ['figure=8', 'figure=9'];
/** Fig. 2a is a separate page. */
const PLAYGROUND = 'figure=2a';

/** The time shown by each stored figure, and a test that its content is complete. */
const MOMENTS: Readonly<Record<string, { t: number; ready?(app: App): Promise<void> }>> = {
  'figure=1': {
    t: 0.56,
    async ready(app) {
      await expect(app.by('film-labels').locator('span')).not.toHaveCount(0);
      // The picture cannot show this curve, because it coincides with another.
      await expect(app.by('plot-plane').locator('path.curve.shell')).toHaveCount(1);
    },
  },
  'figure=2a': { t: 0.4 },
  'figure=2b': {
    t: 0.7,
    ready: (app) => expect(app.by('plot-plane').locator('.sample')).toHaveCount(24),
  },
  'figure=3': { t: 0.5 },
  'figure=4': { t: -0.4 },
  'figure=5': { t: 0.6 },
  'figure=6': { t: 0.3 },
  'figure=7': { t: 0.25, ready: (app) => expect(app.by('colour-bar-now')).toContainText('at most') },
  'figure=8': { t: 0.3, ready: (app) => expect(app.by('plot-ghost-time')).toBeVisible({ timeout: 170_000 }) },
  'figure=9': {
    t: 0.25,
    async ready(app) {
      await expect(app.by('plot-bending').locator('.unit')).toContainText('edge lengths', { timeout: 90_000 });
      await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(3);
    },
  },
  'figure=10': { t: 0.3 },
};

/** Measured values, which differ between runs. */
const MEASURED = '[data-testid="status-ms"], [data-testid="guide-live"], .facts { visibility: hidden }';

async function pictureOf(app: App, { link, panel, part, beside }: GuidePage): Promise<Buffer> {
  await app.page.setViewportSize({ width: 1280, height: 800 });
  if (link === PLAYGROUND) {
    await app.page.goto(beside!.href);
    await expect(app.page.locator('.play-figure path').first()).toBeVisible();
  } else {
    const { t, ready } = MOMENTS[link]!;
    await app.open({ hash: `#${link}` });
    await app.setTime(t);
    await app.settled();
    await ready?.(app);
    await expect(app.by('speed-curve')).toBeVisible();
    // Plots above the visible plot, and their legend, are loaded later.
    if (panel === 'analysis') await app.analysed();
    if (part) await app.by(part).evaluate((one) => one.scrollIntoView());
  }
  await app.page.addStyleTag({ content: MEASURED });
  await app.nextFrame();
  return app.page.screenshot({ animations: 'disabled' });
}

for (const page of FIGURES)
  test(`matches its stored image: ${page.title}`, { tag: '@all' }, async ({ app }, info) => {
    test.slow();
    const { link } = page;
    const now = await pictureOf(app, page);
    const file = path.join(folder, `${link.replace('=', '-')}.png`);
    if (info.config.updateSnapshots === 'all') {
      mkdirSync(folder, { recursive: true });
      writeFileSync(file, shrink(now, KEPT));
      return;
    }
    expect(existsSync(file), `${file} is there`).toBe(true);
    await info.attach(path.basename(file), { body: now, contentType: 'image/png' });
    const { options, ...others } = PARTS;
    const selectors: Record<string, string> =
      link === PLAYGROUND ? { page: '.play-figure' } : TIMED.includes(link) ? others : { ...others, options };
    const [kept, seen] = [shrink(readFileSync(file), SHRUNK / KEPT), shrink(now, SHRUNK)];
    expect(changedParts(kept, seen, await partsOf(app, selectors)), 'what looks different').toEqual([]);
  });
