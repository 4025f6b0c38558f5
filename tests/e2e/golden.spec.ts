/**
 * The page's main states against pictures of them. Both are shrunk to an eighth first, so that other fonts and other
 * software renderers pass and a missing panel, a wrong colour or a shape elsewhere does not. After a wanted change:
 * `npm test -- e2e golden --update-snapshots=all`, and look at what has changed.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { changedShare, shrink } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const folder = fileURLToPath(new URL('./golden', import.meta.url));
const SHRUNK = 8;
/** Levels of 255 by which a shrunk pixel may differ, and the share of pixels that may differ by more. */
const LEVELS = 28;
const SHARE = 0.06;

async function shrunk(app: App): Promise<Buffer> {
  await app.settled();
  // The speed of the motion is asked for when frames leave time.
  await expect(app.by('pace')).toBeVisible();
  // The time that a frame takes is another one every time.
  await app.page.addStyleTag({ content: '[data-testid="status-ms"], .facts { visibility: hidden }' });
  return shrink(await app.page.screenshot({ animations: 'disabled' }), SHRUNK);
}

const states: {
  name: string;
  width: number;
  height: number;
  scheme: 'light' | 'dark';
  reach(app: App): Promise<unknown>;
}[] = [
  { name: 'between', width: 1280, height: 800, scheme: 'light', reach: (app) => app.setTime(0.25) },
  { name: 'beyond-dark', width: 1280, height: 800, scheme: 'dark', reach: (app) => app.setTime(1.3) },
  {
    name: 'side-by-side',
    width: 1280,
    height: 800,
    scheme: 'light',
    reach: async (app) => {
      await app.by('compare-linear').check();
      await app.setTime(0.25);
    },
  },
  { name: 'phone', width: 360, height: 740, scheme: 'light', reach: (app) => app.setTime(0.5) },
];

test.describe('looks as it did', () => {
  for (const { name, width, height, scheme, reach } of states) {
    test(name, async ({ app }, info) => {
      test.skip(info.project.name === 'dev', 'one picture of each state is enough');
      await app.page.setViewportSize({ width, height });
      await app.page.emulateMedia({ colorScheme: scheme, reducedMotion: 'reduce' });
      await app.open();
      await reach(app);
      const now = await shrunk(app);
      const file = path.join(folder, `${name}.png`);
      if (info.config.updateSnapshots === 'all') {
        mkdirSync(folder, { recursive: true });
        writeFileSync(file, now);
        return;
      }
      expect(existsSync(file), `${name}.png is there`).toBe(true);
      await info.attach(`${name}.png`, { body: now, contentType: 'image/png' });
      expect(changedShare(readFileSync(file), now, LEVELS)).toBeLessThan(SHARE);
      // The comparison tells states apart.
      for (const other of states) {
        const golden = path.join(folder, `${other.name}.png`);
        if (other.name !== name && existsSync(golden))
          expect(changedShare(readFileSync(golden), now, LEVELS), other.name).toBeGreaterThan(SHARE);
      }
    });
  }
});
