/**
 * Each figure of the paper as its preset shows it, against the picture that is kept of it in `figures/`, beside what
 * the paper shows there. Both are shrunk to an eighth before they are compared. After a wanted change:
 * `npm test -- e2e figure-pictures --update-snapshots=all`, and look at what has changed.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { FIGURES } from '../../web/app/guide/figures.ts';
import { changedShare, shrink } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const folder = fileURLToPath(new URL('./figures', import.meta.url));
/** Kept at half their size. */
const KEPT = 2;
const COMPARED = 8;
const LEVELS = 28;
const SHARE = 0.06;

/** The moment that is kept of each, and what has to be there. */
const MOMENTS: Readonly<Record<string, { t: number; ready?(app: App): Promise<void> }>> = {
  'figure=1': { t: 0.56 },
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
  'figure=8': { t: 0.3, ready: (app) => expect(app.by('plot-ghost-time')).toBeVisible({ timeout: 80_000 }) },
  'figure=9': {
    t: 0.25,
    async ready(app) {
      await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(3);
      await app.by('plot-bending').scrollIntoViewIfNeeded();
    },
  },
  'figure=10': { t: 0.3 },
};

/** What another run measures differently. */
const MEASURED = '[data-testid="status-ms"], [data-testid="guide-live"], .facts { visibility: hidden }';

async function pictureOf(app: App, link: string, href: string | undefined): Promise<Buffer> {
  await app.page.setViewportSize({ width: 1280, height: 800 });
  // Fig. 2a is a page of its own.
  if (link === 'figure=2a') {
    await app.page.goto(href!);
    await expect(app.page.locator('.play-figure path').first()).toBeVisible();
  } else {
    const { t, ready } = MOMENTS[link]!;
    await app.open({ hash: `#${link}` });
    await app.setTime(t);
    await app.settled();
    await ready?.(app);
    await expect(app.by('pace')).toBeVisible();
  }
  await app.page.addStyleTag({ content: MEASURED });
  await app.nextFrame();
  return app.page.screenshot({ animations: 'disabled' });
}

for (const { link, title, beside } of FIGURES)
  test(`is seen as its kept picture: ${title}`, async ({ app }, info) => {
    test.skip(info.project.name === 'dev', 'one picture of each is enough');
    test.slow();
    const now = await pictureOf(app, link, beside?.href);
    const file = path.join(folder, `${link.replace('=', '-')}.png`);
    if (info.config.updateSnapshots === 'all') {
      mkdirSync(folder, { recursive: true });
      writeFileSync(file, shrink(now, KEPT));
      return;
    }
    expect(existsSync(file), `${file} is there`).toBe(true);
    const small = shrink(now, COMPARED);
    const kept = shrink(readFileSync(file), COMPARED / KEPT);
    await info.attach(path.basename(file), { body: now, contentType: 'image/png' });
    // Its charts hold times of this machine.
    expect(changedShare(kept, small, LEVELS)).toBeLessThan(link === 'figure=8' ? 2 * SHARE : SHARE);
  });
