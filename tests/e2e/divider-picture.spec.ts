/**
 * The animated image of the main README, drawn by the page: a twisted bar on both sides of the divider, from key to key
 * and back. To retake it: `npm test -- e2e divider-picture --update-snapshots=all`.
 */
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import gifenc from 'gifenc';
import { changedShare, decode, shrink } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

// In Node gifenc is a CommonJS module.
const { GIFEncoder, applyPalette, quantize } = gifenc;

test.use({ sharpness: 1, fresh: true });

const file = fileURLToPath(new URL('../../public/divider.gif', import.meta.url));
/** Drawn at twice the stored size, because the test browser draws without antialiasing. */
const FINER = 2;
const SIZE = { width: FINER * 640, height: FINER * 400 };
const STATE = '#sample=twisted-bar&compare=linear&split=0.5';
/** Number of times from the first key to the last; the way back repeats the times in between. */
const TIMES = 18;
const DELAY_MS = 80;
const MAX_BYTES = 1e6;
const COLOURS = 128;
const [SHRUNK, LEVELS] = [4, 40];

async function openAlone(app: App): Promise<void> {
  await app.page.setViewportSize(SIZE);
  await app.open({ hash: STATE });
  await app.page.keyboard.press('x');
  await app.by('stage').waitFor({ state: 'hidden' });
  await app.page.keyboard.press('f');
  await app.page.addStyleTag({ content: '.toast { display: none; }' });
  await app.settled();
}

async function drawn(app: App, index: number): Promise<Buffer> {
  const { keys } = (await app.state()).doc;
  const [first, last] = [keys[0]!.time, keys.at(-1)!.time];
  await app.setTime(first + ((last - first) * index) / (TIMES - 1));
  await app.settled();
  return shrink(await app.page.screenshot(), FINER);
}

/** One palette for all frames keeps still pixels equal, which compresses well. */
function gifOf(pictures: readonly Buffer[]): Uint8Array {
  const frames = pictures.map((picture) => decode(picture));
  const { width, height } = frames[0]!;
  const sample = new Uint8ClampedArray(frames.length * width * height * 4);
  frames.forEach(({ data }, i) => sample.set(data, i * width * height * 4));
  const palette = quantize(sample, COLOURS);
  const indexed = frames.map(({ data }) => applyPalette(new Uint8ClampedArray(data), palette));
  const gif = GIFEncoder();
  for (const index of [...indexed, ...indexed.slice(1, -1).reverse()])
    gif.writeFrame(index, width, height, { palette, delay: DELAY_MS });
  gif.finish();
  return gif.bytes();
}

/** A frame of the stored image as PNG, and the number of frames. */
async function stored(app: App, index: number): Promise<{ count: number; picture: Buffer }> {
  const { count, url } = await app.page.evaluate(
    async ({ text, frameIndex }) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const decoder = new ImageDecoder({ data: bytes, type: 'image/gif' });
      await decoder.completed;
      const { image } = await decoder.decode({ frameIndex });
      const canvas = Object.assign(document.createElement('canvas'), {
        width: image.displayWidth,
        height: image.displayHeight,
      });
      canvas.getContext('2d')!.drawImage(image, 0, 0);
      return { count: decoder.tracks.selectedTrack!.frameCount, url: canvas.toDataURL('image/png') };
    },
    { text: readFileSync(file).toString('base64'), frameIndex: index },
  );
  return { count, picture: Buffer.from(url.split(',')[1]!, 'base64') };
}

test('the animated image of the README matches the page', { tag: '@all' }, async ({ app }, info) => {
  test.setTimeout(120_000);
  await openAlone(app);
  if (info.config.updateSnapshots === 'all') {
    const pictures: Buffer[] = [];
    for (let index = 0; index < TIMES; index += 1) pictures.push(await drawn(app, index));
    writeFileSync(file, gifOf(pictures));
  }
  expect(statSync(file).size).toBeLessThan(MAX_BYTES);
  const now = await drawn(app, 5);
  const off = async (index: number): Promise<number> =>
    changedShare(shrink((await stored(app, index)).picture, SHRUNK), shrink(now, SHRUNK), LEVELS);
  expect((await stored(app, 0)).count).toBe(2 * TIMES - 2);
  const near = await off(5);
  expect(near).toBeLessThan(0.02);
  expect(await off(TIMES - 1)).toBeGreaterThan(2 * near);
});
