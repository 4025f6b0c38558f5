/** One shape, two motions on either side of a divider: the start of a first visit, and a way to compare. */
import { colourAt, decode } from './png.ts';
import type { Picture } from './png.ts';
import { difference, expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const SPLIT = '#sample=twisted-bar&compare=linear&split=0.5&floor=0&t=0.25';

async function pictureOf(app: App): Promise<Picture> {
  return decode(await app.picture());
}

/** Share of different pixels between two images, in a range of their width. */
function changed(a: Picture, b: Picture, from: number, to: number): number {
  expect([a.width, a.height]).toEqual([b.width, b.height]);
  const [left, right] = [Math.ceil(from * a.width), Math.floor(to * a.width)];
  let count = 0;
  for (let y = 0; y < a.height; y += 1) {
    for (let x = left; x < right; x += 1) {
      const other = colourAt(b, x, y);
      if (colourAt(a, x, y).some((level, channel) => Math.abs(level - other[channel]!) > 12)) count += 1;
    }
  }
  return count / ((right - left) * a.height);
}

const share = async (app: App): Promise<number | null> => (await app.state()).view.split;
const volumes = async (app: App): Promise<number[]> => {
  const texts = await app.page.locator('.tile-label .volume b').allTextContents();
  return texts.map(parseFloat);
};

test('each side shows its own motion up to the divider', async ({ app }) => {
  await app.open({ hash: SPLIT });
  const both = await pictureOf(app);
  await app.by('divider').press('Home');
  expect(await share(app)).toBeCloseTo(0.02, 6);
  const right = await pictureOf(app);
  await app.by('divider').press('End');
  expect(await share(app)).toBeCloseTo(0.98, 6);
  const left = await pictureOf(app);
  // Beside the grip, only the motion differs.
  expect(changed(both, left, 0.03, 0.47)).toBeLessThan(1e-4);
  expect(changed(both, right, 0.53, 0.97)).toBeLessThan(1e-4);
  expect(changed(left, right, 0.03, 0.97)).toBeGreaterThan(0.02);
  expect(changed(both, left, 0.53, 0.97)).toBeGreaterThan(0.02);
  // The two views draw the two motions.
  expect(difference(await app.positions(0), await app.positions(1))).toBeGreaterThan(0.3);
  await app.expectNoProblems();
});

test('a shape outside its side counts as out of view, unless the divider was moved over it', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ hash: SPLIT });
  const hint = app.by('fit-hint');
  await expect(hint).toBeHidden();
  await app.by('divider').press('End');
  await app.settled();
  await expect(hint).toBeHidden();
  // Only a changed URL is opened.
  await expect.poll(() => app.page.evaluate(() => location.hash)).toContain('split=0.98');
  await app.open({ hash: SPLIT });
  const { x, y, width, height } = (await app.by('viewport').boundingBox())!;
  await app.page.mouse.move(x + 0.9 * width, y + 0.3 * height);
  await app.page.mouse.down({ button: 'right' });
  await app.page.mouse.move(x + 0.45 * width, y + 0.3 * height, { steps: 5 });
  await app.page.mouse.up({ button: 'right' });
  expect(await share(app)).toBeCloseTo(0.5, 6);
  await expect(hint).toBeVisible();
  await hint.click();
  await expect(hint).toBeHidden();
  await app.expectNoProblems();
});

test('is dragged with mouse and touch, and announced to screen readers', async ({ app }) => {
  await app.open({ hash: SPLIT });
  const divider = app.by('divider');
  await expect(divider).toHaveAttribute('role', 'slider');
  await expect(divider).toHaveAttribute('aria-valuenow', '50');
  await expect(divider).toHaveAttribute('aria-valuetext', /Morph targets.*50 %.*Shape spline/);
  const host = (await app.by('viewport').boundingBox())!;
  const y = host.y + 0.2 * host.height;
  const camera = (await app.state()).view.camera;
  await app.page.mouse.move(host.x + 0.5 * host.width, y);
  await app.page.mouse.down();
  await app.page.mouse.move(host.x + 0.3 * host.width, y, { steps: 4 });
  await app.page.mouse.up();
  expect(await share(app)).toBeCloseTo(0.3, 2);
  expect((await app.state()).view.camera).toEqual(camera);
  await divider.press('ArrowRight');
  expect(await share(app)).toBeCloseTo(0.32, 2);
  await divider.press('Shift+ArrowLeft');
  expect(await share(app)).toBeCloseTo(0.22, 2);
  await expect(divider).toHaveAttribute('aria-valuenow', '22');
  expect((await app.state()).time).toBe(0.25);
  // Several key presses can arrive before the page is redrawn.
  await divider.evaluate((element) => {
    for (const key of ['ArrowRight', 'ArrowRight', 'ArrowLeft', 'ArrowRight', 'ArrowLeft'])
      element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
  });
  expect(await share(app)).toBeCloseTo(0.24, 2);
  await divider.press('ArrowLeft');
  // The same drag with touch input.
  const session = await app.page.context().newCDPSession(app.page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x: number): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] });
  const at = (part: number): number => host.x + part * host.width;
  await touch('touchStart', at(0.22));
  await touch('touchMove', at(0.4));
  await touch('touchMove', at(0.6));
  await touch('touchEnd', at(0.6));
  await expect.poll(() => share(app)).toBeCloseTo(0.6, 2);
  await app.expectNoProblems();
});

test('shows the volumes of a large shape as well', { tag: '@all' }, async ({ app }) => {
  test.slow();
  await app.open();
  await app.openGenerated(70_000);
  await app.setTime(0.25);
  await app.page.keyboard.press('s');
  await app.settled();
  await expect.poll(async () => (await volumes(app)).filter(Number.isFinite)).toHaveLength(2);
  for (const volume of await volumes(app)) {
    expect(volume).toBeGreaterThan(20);
    expect(volume).toBeLessThan(200);
  }
});

test('S shows the divider between any motion and a blend, and removes both again', async ({ app }) => {
  await app.open({ sample: 'cactus' });
  await app.page.keyboard.press('s');
  await app.settled();
  expect((await app.state()).view).toMatchObject({ split: 0.5, compare: ['linear'] });
  await expect(app.by('divider')).toBeVisible();
  await app.by('compare-linear').uncheck();
  await app.by('compare-geodesic').check();
  await app.settled();
  await expect(app.by('divider')).toHaveAttribute('aria-valuetext', /Geodesic/);
  // Three views have no divider.
  await app.by('compare-linear').check();
  await expect(app.by('divider')).toBeHidden();
  await app.by('compare-linear').uncheck();
  await app.page.keyboard.press('s');
  await app.settled();
  expect((await app.state()).view).toMatchObject({ split: null, compare: [] });
  await app.expectNoProblems();
});

test('no texts overlap at 820 px and 360 px', async ({ app }) => {
  await app.page.setViewportSize({ width: 820, height: 1180 });
  await app.open({ hash: SPLIT });
  for (const [width, height] of [
    [820, 1180],
    [360, 740],
  ] as const) {
    await app.page.setViewportSize({ width, height });
    await expect.poll(() => app.page.evaluate(() => window.innerWidth)).toBe(width);
    await app.nextFrame();
    await app.settled();
    await app.nextFrame();
    const boxes = await Promise.all(
      ['.welcome', '.tile-label:first-child', '.tile-label:last-child', '.view-buttons', '.phase'].map(
        async (selector) => (await app.page.locator(selector).boundingBox())!,
      ),
    );
    boxes.forEach((a, i) =>
      boxes.slice(i + 1).forEach((b) => {
        const overlap = a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
        expect(overlap, `${width} px: ${JSON.stringify([a, b])}`).toBe(false);
      }),
    );
  }
});

test.describe('a first visit', () => {
  test.use({ fresh: true });

  test('opens with a collapsing blend next to this method, on the first visit only', async ({ app }) => {
    await app.page.emulateMedia({ reducedMotion: 'no-preference' });
    await app.open({ first: true });
    const { view, play } = await app.state();
    expect(view).toMatchObject({ split: 0.5, compare: ['linear'] });
    expect(play.playing).toBe(true);
    await expect(app.by('divider')).toBeVisible();
    await expect(app.by('welcome')).toContainText('keeps its volume');
    await expect.poll(async () => (await volumes(app))[1]).toBeLessThan(70);
    await expect.poll(async () => (await volumes(app))[0]).toBeGreaterThan(97);
    await app.page.goto('about:blank');
    await app.open({ first: true });
    expect((await app.state()).view).toMatchObject({ split: null, compare: [] });
    await app.expectNoProblems();
  });

  test('with reduced motion, stands still at the time when the blend has collapsed', { tag: '@all' }, async ({
    app,
  }) => {
    await app.open({ first: true });
    expect((await app.state()).play.playing).toBe(false);
    const [method, blend] = await volumes(app);
    expect(blend).toBeLessThan(60);
    expect(method).toBeGreaterThan(97);
    await app.expectNoProblems();
  });
});
