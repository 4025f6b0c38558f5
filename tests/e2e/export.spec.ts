/** What is taken along: it comes down, and what can come back does. */
import { readFileSync } from 'node:fs';
import type { Download, Page } from '@playwright/test';
import { ALL_FORMATS, BufferSource, EncodedPacketSink, Input } from 'mediabunny';
import { colourAt, decode } from './png.ts';
import { diagonal, difference, expect, test } from './support.ts';
import { unzip } from '../unzip.ts';
import type { App } from './support.ts';

async function exported(
  app: App,
  choose: () => Promise<void>,
): Promise<{ download: Download; bytes: Buffer; stated: string }> {
  await app.by('export').click();
  await choose();
  await app.nextFrame();
  await expect(app.by('export-size')).not.toHaveText('Estimating the size');
  const stated = await app.by('export-size').innerText();
  const [download] = await Promise.all([app.page.waitForEvent('download'), app.by('export-go').click()]);
  const bytes = readFileSync(await download.path());
  return { download, bytes, stated };
}

function statedBytes(text: string): number {
  const [, value, unit] = /about ([\d.]+) (B|kB|MB)/.exec(text)!;
  return Number(value) * { B: 1, kB: 1e3, MB: 1e6 }[unit as 'B' | 'kB' | 'MB'];
}

function verticesOf(obj: string): number[] {
  return obj
    .split('\n')
    .filter((line) => line.startsWith('v '))
    .flatMap((line) => line.split(' ').slice(1, 4).map(Number));
}

test('the animation is saved as a GLB of the stated size and opens again as the same project', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('start-speed-number').fill('2');
  await app.by('start-speed-number').press('Enter');
  await app.settled();
  const { doc } = await app.state();
  const middle = await app.positionsAt(0.3);
  const { download, bytes, stated } = await exported(app, async () => {
    await app.by('export-targets-every').check();
    await app.by('export-frames').fill('20');
    await app.by('export-frames').press('Enter');
  });
  expect(download.suggestedFilename()).toBe('cactus.glb');
  expect(bytes.subarray(0, 4).toString()).toBe('glTF');
  expect(bytes.readUInt32LE(8)).toBe(bytes.length);
  expect(Math.abs(statedBytes(stated) / bytes.length - 1)).toBeLessThan(0.1);

  await app.by('file-input').setInputFiles({ name: 'project.glb', mimeType: 'model/gltf-binary', buffer: bytes });
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const again = (await app.state()).doc;
  expect(again.keys.map((key) => key.time)).toEqual(doc.keys.map((key) => key.time));
  expect(again.motion).toEqual(doc.motion);
  expect(difference(await app.positionsAt(0.3), middle)).toBeLessThan(1e-3 * diagonal(middle));
  await app.expectNoProblems();
});

test('frames come as OBJ files in a zip', async ({ app }) => {
  await app.open();
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-animation-obj').check();
    await app.by('export-frames').fill('3');
    await app.by('export-frames').press('Enter');
  });
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const frames = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(frames.map(({ name }) => name)).toEqual(['0000.obj', '0001.obj', '0002.obj', 'cactus.mtl', 'README.txt']);
  const vertices = frames.slice(0, 3).map((frame) => verticesOf(Buffer.from(frame.bytes).toString()));
  expect(difference(vertices[0]!, await app.positionsAt(0))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
  expect(difference(vertices[2]!, await app.positionsAt(1))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
});

test('as few morph targets as the tolerance needs are exported, with the error that results', async ({ app }) => {
  await app.open();
  const targetsIn = (stated: string): number => Number(/^(\d+) morph targets/.exec(stated)![1]);
  const { bytes, stated } = await exported(app, async () => {});
  expect(stated).toMatch(/^\d+ morph targets, off by at most 0\.0\d+ % of the diagonal between them, about /);
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString());
  expect(json.meshes[0].primitives[0].targets).toHaveLength(targetsIn(stated));
  expect(json.meshes[0].extras.targetNames).toHaveLength(targetsIn(stated));
  expect(json.nodes[0].name).toBe('cactus');
  expect(json.extras.shapespline.mesh.error).toBeLessThan(1e-3);

  const rough = await exported(app, async () => {
    await app.by('export-tolerance').fill('1');
    await app.by('export-tolerance').press('Enter');
  });
  expect(targetsIn(rough.stated)).toBeLessThan(targetsIn(stated));
  const small = await exported(app, () => app.by('export-compression-meshopt').check());
  expect(small.bytes.length).toBeLessThan(0.6 * rough.bytes.length);
  await app.expectNoProblems();
});

test('keys and in-betweens come with a table of weights and drivers for Blender', async ({ app }) => {
  await app.open();
  const { download, bytes } = await exported(app, () => app.by('export-targets-principal').check());
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const files = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(files.map(({ name }) => name)).toEqual(['cactus.glb', 'cactus.csv', 'cactus.py']);
  expect(Buffer.from(files[1]!.bytes).toString()).toMatch(/^slider,.*"in-between 1"/);
});

for (const format of ['pc2', 'mdd'] as const) {
  test(`a point cache comes as ${format.toUpperCase()} beside its OBJ`, async ({ app }) => {
    await app.open();
    const { bytes } = await exported(app, async () => {
      await app.by(`export-animation-${format}`).check();
      await app.by('export-frames').fill('5');
      await app.by('export-frames').press('Enter');
    });
    const files = await unzip(new Blob([new Uint8Array(bytes)]));
    expect(files.map(({ name }) => name)).toEqual(
      expect.arrayContaining([`cactus.${format}`, 'cactus.obj', 'README.txt']),
    );
    const obj = verticesOf(Buffer.from(files.find(({ name }) => name === 'cactus.obj')!.bytes).toString());
    const cache = Buffer.from(files[0]!.bytes);
    const header = format === 'pc2' ? 32 : 8 + 4 * 5;
    expect(cache.length).toBe(header + 5 * 4 * obj.length);
    const first = obj.map((_, i) =>
      format === 'pc2' ? cache.readFloatLE(header + 4 * i) : cache.readFloatBE(header + 4 * i),
    );
    expect(difference(first, obj)).toBeLessThan(1e-6 * diagonal(obj));
  });
}

for (const [format, start] of [
  ['glb', 'glTF'],
  ['ply', 'ply'],
] as const) {
  test(`the current pose is saved as ${format.toUpperCase()}`, async ({ app }) => {
    await app.open();
    await app.setTime(0.3);
    const { download, bytes } = await exported(app, async () => {
      await app.by('export-kind-pose').check();
      await app.by(`export-pose-${format}`).check();
    });
    expect(download.suggestedFilename()).toBe(`cactus.${format}`);
    expect(bytes.toString('latin1').startsWith(start)).toBe(true);
  });
}

test('the current pose is saved as OBJ, with its materials', async ({ app }) => {
  await app.open();
  const positions = await app.positionsAt(0.3);
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-kind-pose').check();
    await app.by('export-pose-obj').check();
  });
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const files = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(files.map(({ name }) => name)).toEqual(expect.arrayContaining(['cactus.obj', 'cactus.mtl']));
  const obj = Buffer.from(files.find(({ name }) => name === 'cactus.obj')!.bytes).toString();
  expect(obj).toMatch(/^mtllib cactus\.mtl$/m);
  expect(difference(verticesOf(obj), positions)).toBeLessThan(1e-5 * diagonal(positions));
});

test('the view is saved as a PNG', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, () => app.by('export-kind-picture').check());
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(bytes.length).toBeGreaterThan(5000);
});

interface Tested {
  page: Page;
  bytes: Buffer;
  times: readonly number[];
}

interface Played {
  duration: number;
  ended: boolean;
  /** Where the frames that were shown begin, as the file says. */
  stamps: number[];
  frames: Buffer[];
}

/** Seeks a video in a page of its own from moment to moment, then plays it to its end. */
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
      // The event that a seek has ended may come before its frame.
      const presented = (): Promise<number> =>
        new Promise((resolve) => {
          video.requestVideoFrameCallback((_, { mediaTime }) => resolve(mediaTime));
        });
      const stamps: number[] = [];
      for (const moment of moments) {
        const frame = presented();
        video.currentTime = moment;
        stamps.push(await frame);
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

/** Mean difference of a video's frame to a picture of the same place, in levels of 255. */
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

for (const [format, codec] of [
  ['mp4', 'avc'],
  ['webm', 'vp9'],
] as const) {
  test(`the playing shape is saved as ${format}: every frame at its time, as long as was asked`, async ({ app }) => {
    // Odd, and small: software renders and encodes it.
    await app.page.setViewportSize({ width: 801, height: 601 });
    await app.open();
    const { download, bytes, stated } = await exported(app, async () => {
      await app.by('export-animation-video').check();
      await app.by(`export-video-${format}`).check();
      await app.by('export-duration').fill('0.5');
      await app.by('export-duration').press('Enter');
    });
    expect(stated).toBe('15 frames, 0.5 s of video');
    expect(download.suggestedFilename()).toBe(`cactus.${format}`);
    await app.expectNoProblems();

    const input = new Input({ source: new BufferSource(new Uint8Array(bytes)), formats: ALL_FORMATS });
    const track = (await input.getPrimaryVideoTrack())!;
    const size = (await app.page.locator('.picture canvas').boundingBox())!;
    expect(await track.getCodec()).toBe(codec);
    expect(await track.getDisplayWidth()).toBe(size.width - (size.width % 2));
    expect(await track.getDisplayHeight()).toBe(size.height - (size.height % 2));
    const stamps: number[] = [];
    for await (const packet of new EncodedPacketSink(track).packets()) stamps.push(packet.timestamp);
    expect(stamps).toHaveLength(15);
    // WebM counts milliseconds.
    const digits = format === 'webm' ? 2 : 6;
    stamps.forEach((stamp, frame) => expect(stamp).toBeCloseTo(frame / 30, digits));
    expect(await input.computeDuration()).toBeCloseTo(0.5, digits);

    // The middles of four frames, two of them neighbours; the animation goes from 0 to 1.
    const numbers = [14, 8, 7, 0];
    const {
      duration,
      ended,
      stamps: shown,
      frames,
    } = await played({
      page: app.page,
      bytes,
      times: numbers.map((frame) => (frame + 0.5) / 30),
    });
    expect(duration).toBeCloseTo(0.5, digits);
    expect(ended).toBe(true);
    shown.forEach((stamp, index) => expect(stamp).toBeCloseTo(numbers[index]! / 30, digits));
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
}

test('where a browser has no WebCodecs its recorder makes the video', async ({ app, page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(window, 'VideoEncoder'));
  await app.open();
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-animation-video').check();
    await app.by('export-duration').fill('0.5');
    await app.by('export-duration').press('Enter');
  });
  expect(download.suggestedFilename()).toBe('cactus.webm');
  const input = new Input({ source: new BufferSource(new Uint8Array(bytes)), formats: ALL_FORMATS });
  expect(await (await input.getPrimaryVideoTrack())!.getCodec()).toBe('vp9');
});

test('the plotted numbers are saved as CSV, with version and options', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, () => app.by('export-kind-numbers').check());
  const lines = bytes.toString().trim().split('\n');
  expect(lines[0]).toMatch(/^# shapespline \d+\.\d+\.\d+$/);
  expect(lines[2]).toContain('"boundary":"natural"');
  const header = lines.find((line) => line.startsWith('time,'))!.split(',');
  expect(header).toContain('lri volume');
  const rows = lines.slice(lines.indexOf(header.join(',')) + 1).map((line) => line.split(',').map(Number));
  expect(rows.length).toBeGreaterThan(10);
  for (const row of rows) {
    expect(row.length).toBe(header.length);
    expect(row.every(Number.isFinite)).toBe(true);
  }
  expect(rows[0]![0]).toBeCloseTo(-0.4, 9);
  expect(rows.at(-1)![0]).toBeCloseTo(1.4, 9);
});

test('the patch of every face is saved as CSV', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, async () => {
    await app.by('export-kind-numbers').check();
    await app.by('export-numbers-patches').check();
  });
  const rows = bytes
    .toString()
    .trim()
    .split('\n')
    .filter((line) => /^\d/.test(line));
  const faces = Number((await app.by('status-faces').innerText()).replace(/\D/g, ''));
  expect(rows.length).toBe(faces);
  expect(new Set(rows.map((row) => row.split(',')[1])).size).toBe((await app.stats()).patches);
});

test('a long export is cancelled and leaves everything as it was', async ({ app }) => {
  await app.open();
  await app.by('export').click();
  await app.by('export-animation-video').check();
  await app.by('export-duration').fill('300');
  await app.by('export-duration').press('Enter');
  await app.by('export-go').click();
  await expect(app.by('progress')).toBeVisible();
  await app.by('cancel').click();
  await expect(app.by('progress')).toBeHidden();
  await app.settled();
  expect((await app.state()).time).toBe(0);
  await expect(app.by('error')).toBeHidden();
});

test('a link brings the whole view back', async ({ app, page }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('method').selectOption('cubic-vertex');
  await app.by('view-right').click();
  await app.setTime(0.37);
  await app.settled();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('t=0.37');
  const [state, positions] = [await app.state(), await app.positions()];
  const { hash } = new URL(page.url());
  await page.goto('about:blank');
  await app.open({ hash });
  const again = await app.state();
  expect(again.doc).toEqual(state.doc);
  expect(again.time).toBe(0.37);
  expect(await app.positions()).toEqual(positions);
  again.view.camera!.position.forEach((value, axis) =>
    expect(value).toBeCloseTo(state.view.camera!.position[axis]!, 3),
  );
});
