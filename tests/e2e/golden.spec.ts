/**
 * Compares the page's main states with stored images: the stage and each panel separately. After an intended change:
 * `npm test -- e2e golden --update-snapshots=all`, and check the differences.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { changedParts, expectAsKept, partsOf, shrunk } from './kept-picture.ts';
import { decode, encode } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const folder = fileURLToPath(new URL('./golden', import.meta.url));

const WIDE = {
  header: '.app-header',
  stage: 'main',
  options: '.side',
  keys: '[data-testid="keys"]',
  timeline: '[data-testid="timeline"]',
  status: '[data-testid="status"]',
};
const PHONE = { header: '.app-header', stage: 'main', timeline: '[data-testid="timeline"]', tabs: '.tabs' };

const STATES: {
  name: string;
  size: [number, number];
  scheme: 'light' | 'dark';
  parts: Record<string, string>;
  reach(app: App): Promise<unknown>;
}[] = [
  { name: 'between', size: [1280, 800], scheme: 'light', parts: WIDE, reach: (app) => app.setTime(0.25) },
  { name: 'beyond-dark', size: [1280, 800], scheme: 'dark', parts: WIDE, reach: (app) => app.setTime(1.3) },
  {
    name: 'side-by-side',
    size: [1280, 800],
    scheme: 'light',
    parts: WIDE,
    reach: async (app) => {
      await app.by('compare-linear').check();
      await app.setTime(0.25);
    },
  },
  { name: 'phone', size: [360, 740], scheme: 'light', parts: PHONE, reach: (app) => app.setTime(0.5) },
];

test.describe('looks as before', () => {
  for (const { name, size, scheme, parts: selectors, reach } of STATES) {
    test(name, async ({ app }, info) => {
      await app.page.setViewportSize({ width: size[0], height: size[1] });
      await app.page.emulateMedia({ colorScheme: scheme });
      await app.open();
      await reach(app);
      await app.settled();
      // The motion's speed is requested when no frames are waiting.
      await expect(app.by('speed-curve')).toBeVisible();
      // The options are loaded after the first shape.
      if ('options' in selectors) await expect(app.by('spline-options')).toBeVisible();
      if ('keys' in selectors) await expect(app.page.locator('.key-list img[src]')).toHaveCount(3);
      // The frame time differs every time.
      const style = await app.page.addStyleTag({
        content: '[data-testid="status-ms"], .facts { visibility: hidden }',
      });
      const [now, parts] = [await shrunk(app), await partsOf(app, selectors)];
      await style.evaluate((element: Element) => element.remove());
      await info.attach(`${name}.png`, { body: now, contentType: 'image/png' });
      expectAsKept(path.join(folder, `${name}.png`), now, parts, info.config.updateSnapshots === 'all');
    });
  }
});

test('a missing panel is detected, and no other part is reported', async ({ app }) => {
  await app.page.setViewportSize({ width: 1280, height: 800 });
  await app.page.emulateMedia({ colorScheme: 'light' });
  await app.open();
  const parts = await partsOf(app, WIDE);
  const kept = readFileSync(path.join(folder, 'between.png'));
  for (const { name, x, y, width, height } of parts) {
    const picture = decode(kept);
    for (let row = y; row < y + height; row += 1)
      picture.data.fill(255, 4 * (row * picture.width + x), 4 * (row * picture.width + x + width));
    expect(changedParts(kept, encode(picture), parts)).toEqual([name]);
  }
  expect(changedParts(kept, kept, parts)).toEqual([]);
});
