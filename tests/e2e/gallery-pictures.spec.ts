/**
 * The gallery's images: each sample in motion, drawn by the page, with all frames side by side in one file. After an
 * intended change: `npm test -- e2e gallery-pictures --update-snapshots=all`, and check the differences.
 */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { MOMENTS, PICTURE } from '../../web/ui/gallery.ts';
import { changedShare, shrink } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

// The test hides everything except the shape permanently.
test.use({ sharpness: 1, fresh: true });

const folder = fileURLToPath(new URL('../../public/gallery', import.meta.url));
/** Scale at which the images are drawn, relative to the stored size. */
const FINER = 2;
const COMPARED = 4;
const LEVELS = 40;

/** The shape alone on a transparent background. */
const ALONE = `
  *, *::before { background: none !important; }
  body *:not(:has(canvas)):not(canvas) { visibility: hidden !important; }`;

/** Evenly spaced from the first key to the last, or over one period; never at a key, whose colour would flash. */
async function momentsOf(app: App): Promise<number[]> {
  const { keys, motion } = (await app.state()).doc;
  const [first, last] = [keys[0]!.time, keys.at(-1)!.time];
  const loops = motion.boundary === 'periodic';
  const length = loops ? (motion.period ?? ((last - first) * keys.length) / (keys.length - 1)) : last - first;
  const margin = 0.002 * length;
  const step = loops ? length / MOMENTS : (length - 2 * margin) / (MOMENTS - 1);
  return Array.from({ length: MOMENTS }, (_, i) => first + margin + step * i);
}

async function openAlone(app: App, id: string): Promise<void> {
  await app.page.setViewportSize({ width: FINER * PICTURE.width, height: FINER * PICTURE.height });
  await app.open({ hash: `#sample=${id}&floor=0` });
  await app.page.keyboard.press('x');
  await app.by('stage').waitFor({ state: 'hidden' });
  await app.page.keyboard.press('f');
  await app.settled();
  await app.page.addStyleTag({ content: ALONE });
}

async function drawn(app: App, t: number): Promise<Buffer> {
  await app.setTime(t);
  await app.settled();
  return app.page.screenshot({ omitBackground: true });
}

/** Joins the frames side by side, as WebP. */
async function strip(app: App, pictures: readonly Buffer[]): Promise<Buffer> {
  const url = await app.page.evaluate(
    async ({ texts, width, height }) => {
      const canvas = Object.assign(document.createElement('canvas'), { width: width * texts.length, height });
      const context = canvas.getContext('2d')!;
      context.imageSmoothingQuality = 'high';
      for (const [index, text] of texts.entries()) {
        const image = Object.assign(new Image(), { src: `data:image/png;base64,${text}` });
        await image.decode();
        context.drawImage(image, index * width, 0, width, height);
      }
      return canvas.toDataURL('image/webp', 0.75);
    },
    { texts: pictures.map((picture) => picture.toString('base64')), ...PICTURE },
  );
  return Buffer.from(url.split(',')[1]!, 'base64');
}

/** The share of a strip's frame that differs from an image. */
async function off(app: App, file: Buffer, index: number, picture: Buffer): Promise<number> {
  const url = await app.page.evaluate(
    async ({ text, at, width, height }) => {
      const canvas = Object.assign(document.createElement('canvas'), { width, height });
      const image = Object.assign(new Image(), { src: `data:image/webp;base64,${text}` });
      await image.decode();
      canvas.getContext('2d')!.drawImage(image, -at * width, 0);
      return canvas.toDataURL('image/png');
    },
    { text: file.toString('base64'), at: index, ...PICTURE },
  );
  const kept = Buffer.from(url.split(',')[1]!, 'base64');
  return changedShare(shrink(kept, COMPARED), shrink(picture, FINER * COMPARED), LEVELS);
}

test('the images of the gallery match the page', { tag: '@all' }, async ({ app }, info) => {
  const isUpdate = info.config.updateSnapshots === 'all';
  test.setTimeout(isUpdate ? 300_000 : 90_000);
  await app.open();
  const cards = app.page.locator('.sample-card');
  const all = await cards.evaluateAll((found) => found.map((card) => card.getAttribute('data-id')!));
  expect(all.length).toBeGreaterThanOrEqual(10);
  for (const id of isUpdate ? all : ['dachshund', 'column']) {
    const file = path.join(folder, `${id}.webp`);
    await openAlone(app, id);
    const moments = await momentsOf(app);
    if (isUpdate) {
      mkdirSync(folder, { recursive: true });
      const pictures: Buffer[] = [];
      for (const t of moments) pictures.push(await drawn(app, t));
      writeFileSync(file, await strip(app, pictures));
      continue;
    }
    const strips = readFileSync(file);
    const near = await off(app, strips, 3, await drawn(app, moments[3]!));
    const far = await off(app, strips, 11, await drawn(app, moments[3]!));
    expect(near, id).toBeLessThan(0.02);
    expect(far, id).toBeGreaterThan(2 * near);
  }
});
