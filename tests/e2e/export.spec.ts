/** What is taken along: it comes down, and what can come back does. */
import { readFileSync } from 'node:fs';
import type { Download } from '@playwright/test';
import { diagonal, difference, expect, test } from './support.ts';
import { unzip } from '../unzip.ts';
import type { App } from './support.ts';

async function exported(
  app: App,
  choose: () => Promise<void>,
): Promise<{ download: Download; bytes: Buffer; stated: string }> {
  await app.by('export').click();
  await choose();
  await app.answered();
  await expect(app.by('export-size')).not.toHaveText('Working out the size');
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
  expect(frames.map(({ name }) => name)).toEqual(['0000.obj', '0001.obj', '0002.obj']);
  const vertices = frames.map((frame) => verticesOf(Buffer.from(frame.bytes).toString()));
  expect(difference(vertices[0]!, await app.positionsAt(0))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
  expect(difference(vertices[2]!, await app.positionsAt(1))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
});

for (const [format, start] of [
  ['glb', 'glTF'],
  ['obj', ''],
  ['ply', 'ply'],
] as const) {
  test(`the current pose is saved as ${format.toUpperCase()}`, async ({ app }) => {
    await app.open();
    const positions = await app.positionsAt(0.3);
    const { download, bytes } = await exported(app, async () => {
      await app.by('export-kind-pose').check();
      await app.by(`export-pose-${format}`).check();
    });
    expect(download.suggestedFilename()).toBe(`cactus.${format}`);
    expect(bytes.toString('latin1').startsWith(start)).toBe(true);
    if (format !== 'obj') return;
    expect(difference(verticesOf(bytes.toString()), positions)).toBeLessThan(1e-5 * diagonal(positions));
  });
}

test('the view is saved as a PNG', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, () => app.by('export-kind-picture').check());
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(bytes.length).toBeGreaterThan(5000);
});

test('the playing shape is saved as a video', async ({ app }) => {
  await app.open();
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-animation-webm').check();
    await app.by('export-duration').fill('1');
    await app.by('export-duration').press('Enter');
  });
  expect(download.suggestedFilename()).toMatch(/\.(webm|mp4)$/);
  expect(bytes.length).toBeGreaterThan(10_000);
  // EBML, the container of WebM.
  if (download.suggestedFilename().endsWith('webm')) expect(bytes.subarray(0, 4).toString('hex')).toBe('1a45dfa3');
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
  await app.by('export-animation-webm').check();
  await app.by('export-duration').fill('30');
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
