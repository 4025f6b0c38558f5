/** The samples: animated cards, usable by pointer and keyboard; every sample opens and moves. */
import { MOMENTS, PICTURE } from '../../web/ui/gallery.ts';
import { changedShare } from './png.ts';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const LARGE = 'serpent';

const idsOf = (app: App): Promise<string[]> =>
  app.page.locator('.sample-card').evaluateAll((cards) => cards.map((card) => card.getAttribute('data-id')!));

test('every sample opens without a warning, and moves', { tag: '@all' }, async ({ app }) => {
  test.slow();
  await app.open();
  const ids = await idsOf(app);
  expect(ids.length).toBeGreaterThanOrEqual(6);
  for (const id of ids.filter((one) => one !== LARGE)) {
    await app.pick(id);
    await app.settled();
    await expect(app.by('error')).toBeHidden();
    const { keys } = (await app.state()).doc;
    expect(keys.length, id).toBeGreaterThanOrEqual(3);
    const [first, second] = [await app.positionsAt(keys[0]!.time), await app.positionsAt(keys[1]!.time)];
    expect(first.every(Number.isFinite)).toBe(true);
    // Halfway, the shape equals neither key and is not far from both.
    const between = await app.positionsAt((keys[0]!.time + keys[1]!.time) / 2);
    const size = diagonal(first);
    for (const key of [first, second]) {
      expect(difference(between, key), id).toBeGreaterThan(0.005 * size);
      expect(difference(between, key), id).toBeLessThan(size);
    }
    await expect(app.by('status-keys')).toHaveText(`${keys.length} keys`);
    await expect(app.by('lost'), id).toBeHidden();
  }
  await app.expectNoProblems();
});

test('a sample of more than 300,000 faces is generated in the browser instead of fetched', {
  tag: '@all',
}, async ({ app }) => {
  test.slow();
  await app.open();
  const before = app.requests.length;
  await app.pick(LARGE);
  await app.settled();
  const faces = (await app.by('status-faces').textContent())!.replace(/\D/g, '');
  expect(Number(faces)).toBeGreaterThan(300_000);
  expect(app.requests.slice(before).filter((url) => url.endsWith(`${LARGE}.glb`))).toEqual([]);
  const [a, b] = [await app.positionsAt(0), await app.positionsAt(0.25)];
  expect(difference(a, b)).toBeGreaterThan(0.01 * diagonal(a));
  await expect(app.by('lost')).toBeHidden();
  await app.expectNoProblems();
});

test('can be reached with the keyboard, marks the open sample, and closes', async ({ app }) => {
  await app.open();
  const [gallery, button] = [app.by('gallery'), app.by('sample')];
  await expect(button).toHaveText('Cactus');
  await expect(gallery).toBeHidden();
  await button.focus();
  await app.page.keyboard.press('Enter');
  await expect(gallery).toBeVisible();
  await expect(app.by('sample-card-cactus')).toBeFocused();
  await expect(app.by('sample-card-cactus')).toHaveAttribute('aria-current', 'true');
  await app.page.keyboard.press('Escape');
  await expect(gallery).toBeHidden();
  await expect(button).toBeFocused();
  await app.page.keyboard.press('Enter');
  await app.page.keyboard.press('Tab');
  await expect(app.by('sample-card-dachshund')).toBeFocused();
  await app.page.keyboard.press('Enter');
  await expect(gallery).toBeHidden();
  await expect.poll(async () => (await app.state()).source).toEqual({ kind: 'sample', id: 'dachshund' });
  await expect(button).toHaveText('Dachshund');
  await app.expectNoProblems();
});

test('without reduced motion the cards move, without opening a sample', { tag: '@all' }, async ({ app }) => {
  await app.page.emulateMedia({ reducedMotion: 'no-preference' });
  await app.open();
  await app.by('play').click();
  await app.by('sample').click();
  const card = app.by('sample-card-hand').locator('.sample-picture');
  await expect
    .poll(() => card.locator('img').evaluate((one: HTMLImageElement) => [one.naturalWidth, one.naturalHeight]))
    .toEqual([MOMENTS * PICTURE.width, PICTURE.height]);
  const first = await card.screenshot();
  await expect.poll(async () => changedShare(first, await card.screenshot())).toBeGreaterThan(0.02);
  expect((await app.state()).source).toEqual({ kind: 'sample', id: 'cactus' });
  await app.page.keyboard.press('Escape');
  await app.expectNoProblems();
});

test.describe('with counted requests', () => {
  test.use({ fresh: true });

  test('images are fetched when the cards are visible, and do not move with reduced motion', {
    tag: '@all',
  }, async ({ app }) => {
    await app.open();
    const pictures = (): number => new Set(app.requests.filter((url) => url.includes('/gallery/'))).size;
    expect(pictures()).toBe(0);
    await app.by('sample').click();
    await expect.poll(pictures).toBe((await idsOf(app)).length);
    const picture = app.by('sample-card-hand').locator('img');
    await expect.poll(() => picture.evaluate((one: HTMLImageElement) => one.naturalWidth)).toBeGreaterThan(0);
    expect(await picture.evaluate((one) => one.getAnimations().length)).toBe(0);
  });
});

test('fits at 360 px', async ({ app }) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await app.open();
  await app.by('sample').click();
  const box = (await app.by('gallery').boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(360);
  expect(box.y + box.height).toBeLessThanOrEqual(740);
  await app.by('sample-card-serpent').scrollIntoViewIfNeeded();
  await expect(app.by('sample-card-serpent')).toBeInViewport();
});
