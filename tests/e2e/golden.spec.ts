/**
 * The page's main states against pictures of them. Both are shrunk to an eighth first, so that other fonts and other
 * software renderers pass and a missing panel, a wrong colour or a shape elsewhere does not. After a wanted change:
 * `npm test -- e2e golden --update-snapshots=all`, and look at what has changed.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

const folder = fileURLToPath(new URL('./golden', import.meta.url));
const SHRUNK = 8;
/** Levels of 255 by which a shrunk pixel may differ, and the share of pixels that may differ by more. */
const LEVELS = 28;
const SHARE = 0.06;

async function shrunk(app: App): Promise<Buffer> {
  await app.settled();
  // The time that a frame takes is another one every time.
  await app.page.addStyleTag({ content: '[data-testid="status-ms"], .facts { visibility: hidden }' });
  const shot = (await app.page.screenshot({ animations: 'disabled' })).toString('base64');
  const small = await app.page.evaluate(
    async ([text, factor]) => {
      const bytes = Uint8Array.from(atob(text as string), (character) => character.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const [width, height] = [bitmap.width, bitmap.height].map((size) => Math.round(size / (factor as number))) as [
        number,
        number,
      ];
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext('2d')!;
      context.imageSmoothingQuality = 'high';
      context.drawImage(bitmap, 0, 0, width, height);
      const png = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer());
      return btoa(String.fromCharCode(...png));
    },
    [shot, SHRUNK] as const,
  );
  return Buffer.from(small, 'base64');
}

/** Share of pixels that differ; 1 where the sizes do. */
async function differing(app: App, one: Buffer, other: Buffer): Promise<number> {
  return app.page.evaluate(
    async ([a, b, levels]) => {
      const read = async (text: string): Promise<ImageData> => {
        const bitmap = await createImageBitmap(
          new Blob([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))], { type: 'image/png' }),
        );
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
        context.drawImage(bitmap, 0, 0);
        return context.getImageData(0, 0, bitmap.width, bitmap.height);
      };
      const [p, q] = [await read(a as string), await read(b as string)];
      if (p.width !== q.width || p.height !== q.height) return 1;
      let count = 0;
      for (let i = 0; i < p.data.length; i += 4) {
        if ([0, 1, 2].some((c) => Math.abs(p.data[i + c]! - q.data[i + c]!) > (levels as number))) count += 1;
      }
      return count / (p.data.length / 4);
    },
    [one.toString('base64'), other.toString('base64'), LEVELS] as const,
  );
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
      expect(await differing(app, readFileSync(file), now)).toBeLessThan(SHARE);
      // The comparison tells states apart.
      for (const other of states) {
        const golden = path.join(folder, `${other.name}.png`);
        if (other.name !== name && existsSync(golden))
          expect(await differing(app, readFileSync(golden), now), other.name).toBeGreaterThan(SHARE);
      }
    });
  }
});
