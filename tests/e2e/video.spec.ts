/** Videos and images, read back: duration, number of frames, size, and content. */
import type { Page } from '@playwright/test';
import { ALL_FORMATS, BufferSource, EncodedPacketSink, Input } from 'mediabunny';
import { exported, stated, type } from './exporting.ts';
import { changedShare, colourAt, decode } from './png.ts';
import type { Picture } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

interface Read {
  codec: string | null;
  width: number;
  height: number;
  seconds: number;
  stamps: number[];
}

async function read(bytes: Buffer): Promise<Read> {
  const input = new Input({ source: new BufferSource(new Uint8Array(bytes)), formats: ALL_FORMATS });
  const track = (await input.getPrimaryVideoTrack())!;
  const stamps: number[] = [];
  for await (const packet of new EncodedPacketSink(track).packets()) stamps.push(packet.timestamp);
  return {
    codec: await track.getCodec(),
    width: await track.getDisplayWidth(),
    height: await track.getDisplayHeight(),
    seconds: await input.computeDuration(),
    stamps,
  };
}

interface Tested {
  page: Page;
  bytes: Buffer;
  times: readonly number[];
}

interface Played {
  duration: number;
  ended: boolean;
  /** Start times of the shown frames, from the file. */
  stamps: number[];
  frames: Buffer[];
}

/** Seeks a video on a separate page to several times, then plays it to its end. */
async function played({ page, bytes, times }: Tested): Promise<Played> {
  const other = await page.context().newPage();
  const { frames, ...rest } = await other.evaluate(
    async ([base64, moments]) => {
      const video = document.createElement('video');
      const happens = (name: string): Promise<unknown> =>
        new Promise((resolve, reject) => {
          video.addEventListener(name, resolve, { once: true });
          video.addEventListener('error', () => reject(new Error(video.error?.message)), { once: true });
        });
      video.muted = true;
      video.src = URL.createObjectURL(await (await fetch(`data:video/any;base64,${base64}`)).blob());
      await happens('canplaythrough');
      const canvas = Object.assign(document.createElement('canvas'), {
        width: video.videoWidth,
        height: video.videoHeight,
      });
      const frames: string[] = [];
      // The seek's end event may come before its frame.
      const presented = (): Promise<number> =>
        new Promise((resolve) => {
          video.requestVideoFrameCallback((_, { mediaTime }) => resolve(mediaTime));
        });
      const stamps: number[] = [];
      for (const moment of moments) {
        const frame = presented();
        video.currentTime = moment;
        // The very first frame may be shown only now.
        let stamp = await frame;
        while (Math.abs(stamp - moment) > 0.1) stamp = await presented();
        stamps.push(stamp);
        canvas.getContext('2d')!.drawImage(video, 0, 0);
        frames.push(canvas.toDataURL('image/png').split(',')[1]!);
      }
      const ended = happens('ended');
      await video.play();
      await ended;
      return { duration: video.duration, ended: video.ended, stamps, frames };
    },
    [bytes.toString('base64'), times] as const,
  );
  await other.close();
  return { ...rest, frames: frames.map((frame) => Buffer.from(frame, 'base64')) };
}

/** Mean difference between a video frame and an image of the same region, in levels of 255. */
function meanDifference(frame: Buffer, picture: Buffer): number {
  const [a, b] = [decode(frame), decode(picture)];
  let sum = 0;
  for (let y = 0; y < a.height; y += 1) {
    for (let x = 0; x < a.width; x += 1) {
      const other = colourAt(b, x, y);
      sum += colourAt(a, x, y).reduce((most, level, i) => Math.max(most, Math.abs(level - other[i]!)), 0);
    }
  }
  return sum / (a.width * a.height);
}

async function chooseVideo(app: App, format: string, options: Record<string, string> = {}): Promise<void> {
  await app.by('export-animation-video').check();
  await app.by(`export-video-${format}`).check();
  for (const [field, value] of Object.entries(options)) await type(app, field, value);
}

async function size(app: App, width: number, height: number): Promise<void> {
  await app.by('export-pixels').selectOption('own');
  await type(app, 'export-width', String(width));
  await type(app, 'export-height', String(height));
}

test('the playing shape is saved as MP4: every frame is its shape, at its time', async ({ app }) => {
  // Odd and small, because software renders and encodes it.
  await app.page.setViewportSize({ width: 801, height: 601 });
  await app.open();
  const {
    download,
    bytes,
    stated: text,
  } = await exported(app, () => chooseVideo(app, 'mp4', { 'export-duration': '0.5' }));
  expect(text).toMatch(/^15 frames, 0.5 s, /);
  expect(download.suggestedFilename()).toBe('cactus.mp4');
  await app.expectNoProblems();

  const video = await read(bytes);
  const canvas = (await app.page.locator('.picture canvas').boundingBox())!;
  expect(video.codec).toBe('avc');
  expect(video.width).toBe(canvas.width - (canvas.width % 2));
  expect(video.height).toBe(canvas.height - (canvas.height % 2));
  expect(video.stamps).toHaveLength(15);
  video.stamps.forEach((stamp, frame) => expect(stamp).toBeCloseTo(frame / 30, 6));
  expect(video.seconds).toBeCloseTo(0.5, 6);

  // The middles of three frames, two of them neighbours; the animation runs from 0 to 1.
  const numbers = [8, 7, 0];
  const times = numbers.map((frame) => (frame + 0.5) / 30);
  const { duration, ended, stamps: shown, frames } = await played({ page: app.page, bytes, times });
  expect(duration).toBeCloseTo(0.5, 6);
  expect(ended).toBe(true);
  shown.forEach((stamp, index) => expect(stamp).toBeCloseTo(numbers[index]! / 30, 6));
  const pictures: Buffer[] = [];
  for (const frame of numbers) {
    await app.setTime(frame / 15);
    pictures.push(await app.picture());
  }
  for (const [index, frame] of frames.entries()) {
    const differences = pictures.map((picture) => meanDifference(frame, picture));
    expect(differences.indexOf(Math.min(...differences)), differences.join(' ')).toBe(index);
  }
});

test('several choices made before the next frame all take effect', async ({ app }) => {
  await app.open();
  const text = await stated(app, async () => {
    await chooseVideo(app, 'webm', { 'export-duration': '0.4', 'export-rate': '10' });
    await app.by('export-pixels').selectOption('own');
    await app.page.evaluate(() => {
      for (const [field, value] of Object.entries({ width: '320', height: '240', from: '0.2', to: '0.6' })) {
        const input = document.querySelector<HTMLInputElement>(`[data-testid=export-${field}]`)!;
        input.value = value;
        input.dispatchEvent(new Event('change'));
      }
    });
  });
  expect(text).toBe('4 frames, 0.4 s, 320 × 240 pixels');
  await expect(app.by('export-from')).toHaveValue('0.2');
  await expect(app.by('export-to')).toHaveValue('0.6');
});

interface Gif {
  width: number;
  height: number;
  /** Hundredths of a second, from the file. */
  delays: number[];
  loops: boolean;
}

/** The blocks of a GIF, following its specification. */
function readGif(bytes: Buffer): Gif {
  expect(bytes.toString('latin1', 0, 6)).toBe('GIF89a');
  const table = (flags: number): number => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  const gif: Gif = { width: bytes.readUInt16LE(6), height: bytes.readUInt16LE(8), delays: [], loops: false };
  let at = 13 + table(bytes[10]!);
  const skipBlocks = (): void => {
    while (bytes[at] !== 0) at += bytes[at]! + 1;
    at += 1;
  };
  while (bytes[at] !== 0x3b) {
    if (bytes[at] === 0x21) {
      const label = bytes[at + 1];
      if (label === 0xf9) gif.delays.push(bytes.readUInt16LE(at + 4));
      if (label === 0xff) gif.loops = bytes.toString('latin1', at + 3, at + 14) === 'NETSCAPE2.0';
      at += 2;
    } else {
      expect(bytes[at]).toBe(0x2c);
      at += 11 + table(bytes[at + 9]!);
    }
    skipBlocks();
  }
  expect(at).toBe(bytes.length - 1);
  return gif;
}

/** A GIF decoded by the browser: frames as PNG, and their durations in milliseconds. */
async function decodedGif(page: Page, bytes: Buffer): Promise<{ frames: Buffer[]; milliseconds: number[] }> {
  const { frames, milliseconds } = await page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const decoder = new ImageDecoder({ data, type: 'image/gif' });
    await decoder.tracks.ready;
    await decoder.completed;
    const frames: string[] = [];
    const milliseconds: number[] = [];
    for (let frameIndex = 0; frameIndex < decoder.tracks.selectedTrack!.frameCount; frameIndex += 1) {
      const { image } = await decoder.decode({ frameIndex });
      const canvas = Object.assign(document.createElement('canvas'), {
        width: image.displayWidth,
        height: image.displayHeight,
      });
      canvas.getContext('2d')!.drawImage(image, 0, 0);
      milliseconds.push(image.duration! / 1000);
      frames.push(canvas.toDataURL('image/png').split(',')[1]!);
      image.close();
    }
    return { frames, milliseconds };
  }, bytes.toString('base64'));
  return { frames: frames.map((frame) => Buffer.from(frame, 'base64')), milliseconds };
}

test.describe('with code that is loaded on demand', () => {
  test.use({ fresh: true });

  test('a GIF has the right frames, durations and colours', { tag: '@all' }, async ({ app }) => {
    await app.open();
    const code = (): string[] => app.requests.filter((url) => /(gif-encoder|video-encoder|video)-[^/]*\.js$/.test(url));
    expect(code()).toEqual([]);
    const {
      download,
      bytes,
      stated: text,
    } = await exported(app, async () => {
      await chooseVideo(app, 'gif', { 'export-duration': '0.5', 'export-rate': '30' });
      await size(app, 320, 240);
    });
    // The encoder is fetched only now.
    expect(code().filter((url) => url.includes('gif-encoder'))).toHaveLength(1);
    expect(code().filter((url) => !url.includes('gif-encoder'))).toEqual([]);
    expect(text).toBe('15 frames, 0.5 s, 320 × 240 pixels');
    expect(download.suggestedFilename()).toBe('cactus.gif');
    const gif = readGif(bytes);
    expect([gif.width, gif.height, gif.loops]).toEqual([320, 240, true]);
    expect(gif.delays).toHaveLength(15);
    expect(new Set(gif.delays)).toEqual(new Set([3, 4]));
    expect(gif.delays.reduce((sum, delay) => sum + delay)).toBe(50);

    const { frames, milliseconds } = await decodedGif(app.page, bytes);
    expect(frames).toHaveLength(15);
    expect(milliseconds).toEqual(gif.delays.map((delay) => 10 * delay));
    for (const [frame, picture] of frames.entries())
      if (frame > 0) expect(changedShare(frames[frame - 1]!, picture), `frame ${frame}`).toBeGreaterThan(0.005);

    // The video frame is compared with a PNG of the same size.
    await app.setTime(7 / 15);
    const { bytes: picture } = await exported(app, async () => {
      await app.by('export-kind-picture').check();
      await app.by('export-pixels').selectOption('own');
      await app.by('export-transparent').uncheck();
    });
    const [near, far] = [meanDifference(frames[7]!, picture), meanDifference(frames[0]!, picture)];
    expect(near).toBeLessThan(3);
    expect(far).toBeGreaterThan(2 * near);
  });
});

test('a turntable rotates once in the duration shown by the dialog, and restores the view', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  const camera = await app.page.evaluate(() => window.__shapespline!.state.view.camera);
  const text = await stated(app, async () => {
    await app.by('export-kind-picture').check();
    await app.by('export-picture-turntable').check();
  });
  expect(text).toMatch(/^180 frames, 6 s, /);
  await expect(app.by('export-duration')).toHaveValue('6');
  await app.by('export-close').click();
  const {
    download,
    bytes,
    stated: said,
  } = await exported(app, async () => {
    await app.by('export-video-webm').check();
    await type(app, 'export-duration', '0.8');
    await type(app, 'export-rate', '10');
    await size(app, 320, 240);
  });
  expect(said).toBe('8 frames, 0.8 s, 320 × 240 pixels');
  expect(download.suggestedFilename()).toBe('cactus.webm');
  const video = await read(bytes);
  expect([video.codec, video.width, video.height]).toEqual(['vp9', 320, 240]);
  // WebM counts milliseconds.
  expect(video.stamps).toHaveLength(8);
  video.stamps.forEach((stamp, frame) => expect(stamp).toBeCloseTo(frame / 10, 2));
  expect(video.seconds).toBeCloseTo(0.8, 2);
  const { frames } = await played({ page: app.page, bytes, times: [0.05, 0.25, 0.45, 0.75] });
  for (const frame of [1, 2, 3]) expect(changedShare(frames[0]!, frames[frame]!)).toBeGreaterThan(0.03);
  // After one turn, the view is nearly the initial one.
  expect(meanDifference(frames[3]!, frames[0]!)).toBeLessThan(meanDifference(frames[2]!, frames[0]!));
  expect((await app.state()).view.camera).toEqual(camera);
});

test.describe('without WebCodecs', () => {
  test.use({ fresh: true });

  test('without WebCodecs, the browser’s recorder makes the video, with corrected times and length', {
    tag: '@all',
  }, async ({ app, page }) => {
    await page.addInitScript(() => Reflect.deleteProperty(window, 'VideoEncoder'));
    await app.open();
    const { download, bytes } = await exported(app, async () => {
      await app.by('export-animation-video').check();
      await type(app, 'export-duration', '0.5');
      await size(app, 320, 240);
    });
    expect(download.suggestedFilename()).toBe('cactus.webm');
    const video = await read(bytes);
    expect(video.codec).toBe('vp9');
    expect([video.width, video.height]).toEqual([320, 240]);
    expect(video.seconds).toBeCloseTo(0.5, 2);
    const { duration, ended, frames } = await played({ page, bytes, times: [0.02, 0.45] });
    expect(duration).toBeCloseTo(0.5, 2);
    expect(ended).toBe(true);
    expect(changedShare(frames[0]!, frames[1]!)).toBeGreaterThan(0.02);
  });
});

test('cancelling a long video restores the page', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await stated(app, () => chooseVideo(app, 'mp4', { 'export-duration': '300' }));
  await app.by('export-go').click();
  await expect(app.by('stage')).toHaveText(/^Frame [\d,]+ of 9,000/);
  await expect(app.by('stage')).toHaveText(/, about \d+\s(s|min) left$/);
  await app.by('cancel').click();
  await expect(app.by('progress')).toBeHidden();
  await app.settled();
  expect((await app.state()).time).toBe(0);
  await expect(app.by('error')).toBeHidden();
});

const alphaAt = ({ width, data }: Picture, x: number, y: number): number => data[4 * (y * width + x) + 3]!;

/** Position of the first non-empty pixel in a row; -1 if none. */
function leftEnd(picture: Picture, y: number): number {
  for (let x = 0; x < picture.width; x += 1) if (alphaAt(picture, x, y) > 0) return x;
  return -1;
}

test('an image has the chosen size, without enlarged pixels', async ({ app }) => {
  await app.open();
  const { bytes, stated: text } = await exported(app, async () => {
    await app.by('export-kind-picture').check();
    await app.by('export-pixels').selectOption('4k');
    await app.by('export-crop').uncheck();
  });
  expect(text).toBe('An image of 3840 × 2160 pixels');
  const picture = decode(bytes);
  expect([picture.width, picture.height]).toEqual([3840, 2160]);
  // The image shows only the shape, without grid and shadow. Edges are not smoothed in these tests.
  const ends = Array.from({ length: 2160 }, (_, y) => leftEnd(picture, y)).filter((x) => x >= 0);
  expect(ends.length).toBeGreaterThan(800);
  expect(ends.length).toBeLessThan(1800);
  expect([0, 3839].map((x) => [alphaAt(picture, x, 0), alphaAt(picture, x, 2159)])).toEqual([
    [0, 0],
    [0, 0],
  ]);
  // An enlarged image would have steps of several pixels.
  const single = ends.filter((x, row) => row > 0 && Math.abs(x - ends[row - 1]!) === 1).length;
  const odd = ends.filter((x) => x % 2 === 1).length;
  expect(single).toBeGreaterThan(200);
  expect(odd).toBeGreaterThan(0.3 * ends.length);
  expect(odd).toBeLessThan(0.7 * ends.length);
});

test('an image is cropped to the shape, or has the floor and the background of the page', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  const cropped = await exported(app, async () => {
    await app.by('export-kind-picture').check();
    await app.by('export-pixels').selectOption('1080p');
    await app.by('export-crop').check();
  });
  expect(cropped.stated).toBe('An image, cropped from 1920 × 1080 pixels');
  const picture = decode(cropped.bytes);
  expect(picture.width).toBeLessThan(1200);
  expect(picture.height).toBeLessThan(1080);
  const drawn = { left: picture.width, right: -1, top: picture.height, bottom: -1 };
  for (let y = 0; y < picture.height; y += 1)
    for (let x = 0; x < picture.width; x += 1)
      if (alphaAt(picture, x, y) > 8)
        Object.assign(drawn, {
          left: Math.min(drawn.left, x),
          right: Math.max(drawn.right, x),
          top: Math.min(drawn.top, y),
          bottom: Math.max(drawn.bottom, y),
        });
  const margins = [drawn.left, picture.width - 1 - drawn.right, drawn.top, picture.height - 1 - drawn.bottom];
  const margin = 0.03 * Math.max(drawn.right - drawn.left, drawn.bottom - drawn.top);
  for (const one of margins) expect(Math.abs(one - margin)).toBeLessThan(3);

  const whole = await exported(app, async () => {
    await app.by('export-crop').uncheck();
    await app.by('export-transparent').uncheck();
  });
  const ground = decode(whole.bytes);
  expect([ground.width, ground.height]).toEqual([1920, 1080]);
  expect(ground.data.every((value, at) => at % 4 !== 3 || value === 255)).toBe(true);
  // With the floor's grid and the shadow, the background has several colours.
  const row = Array.from({ length: 1920 }, (_, x) => colourAt(ground, x, 900).join());
  expect(new Set(row).size).toBeGreaterThan(5);
});

test('an image of a comparison has the names of the methods', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await app.setTime(0.25);
  const single = await exported(app, async () => {
    await app.by('export-kind-picture').check();
    await app.by('export-pixels').selectOption('1080p');
  });
  await app.by('compare-linear').check();
  await app.settled();
  const both = await exported(app, async () => {});
  const picture = decode(both.bytes);
  const half = Math.floor(picture.width / 2);
  // Text over each of the two shapes: dark grey on a transparent background.
  const letters = (from: number): number => {
    let count = 0;
    for (let y = 0; y < 0.12 * picture.height; y += 1)
      for (let x = from; x < from + half; x += 1) {
        const [red, green, blue] = colourAt(picture, x, y);
        if (alphaAt(picture, x, y) > 128 && Math.max(red, green, blue) < 60) count += 1;
      }
    return count;
  };
  expect(letters(0)).toBeGreaterThan(200);
  expect(letters(half)).toBeGreaterThan(200);
  const alone = decode(single.bytes);
  const top = Array.from({ length: alone.width }, (_, x) => alphaAt(alone, x, 2)).filter((alpha) => alpha > 0);
  expect(top).toEqual([]);
  expect(picture.width).toBeGreaterThan(1.2 * (picture.height - 0.12 * picture.height) * 0.5);
});
