/** The first five seconds: a shape is shown, it moves, and the page introduces itself. */
import { colours, decode, matching, saturation } from './png.ts';
import { expect, test } from './support.ts';

test('shows the first sample with its counts and a shaded image', { tag: '@server' }, async ({ app }) => {
  await app.open();
  const { source, doc } = await app.state();
  expect(source).toEqual({ kind: 'sample', id: 'cactus' });
  expect(doc.keys.length).toBeGreaterThanOrEqual(3);
  await expect(app.by('status-keys')).toHaveText(`${doc.keys.length} keys`);
  const positions = await app.positions();
  await expect(app.by('status-vertices')).toHaveText(`${(positions.length / 3).toLocaleString('en')} vertices`);
  await expect(app.by('status-ms')).toHaveText(/^\d+(\.\d)? ms per frame$/);
  expect(positions.every(Number.isFinite)).toBe(true);

  const picture = await app.picture();
  // A lit shape has many shades of its colour and fills a large part of the image.
  expect(new Set(Array.from(colours(decode(picture)), String)).size).toBeGreaterThan(100);
  expect(matching(picture, (colour) => saturation(colour) > 40).share).toBeGreaterThan(0.02);
  await app.expectNoProblems();
});

test('without reduced motion, the sample plays until the slider is used, and opened files play at once', async ({
  app,
}) => {
  await app.page.emulateMedia({ reducedMotion: 'no-preference' });
  await app.open();
  expect((await app.state()).play.playing).toBe(true);
  await expect(app.by('welcome')).toBeVisible();
  const before = (await app.state()).time;
  await expect.poll(async () => (await app.state()).time).not.toBe(before);
  await app.by('timeline').click({ position: { x: 120, y: 30 } });
  expect((await app.state()).play.playing).toBe(false);
  await expect(app.by('welcome')).toBeHidden();
  await app.openGenerated(2000);
  expect((await app.state()).source.kind).toBe('files');
  expect((await app.state()).play.playing).toBe(true);
  const opened = (await app.state()).time;
  await expect.poll(async () => (await app.state()).time).not.toBe(opened);
  // The URL no longer names a sample, even during playback.
  await expect.poll(() => app.page.url()).not.toContain('sample');
  await app.expectNoProblems();
});

test('with reduced motion, nothing plays until the user starts it', async ({ app }) => {
  await app.open();
  expect((await app.state()).play.playing).toBe(false);
  await app.by('play').click();
  await expect.poll(async () => (await app.state()).time).toBeGreaterThan(0.02);
  await app.by('play').click();
  expect((await app.state()).play.playing).toBe(false);
});
