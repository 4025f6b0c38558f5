/** Accessibility: keyboard only, 360 px, contrast themes, no requests to other hosts, offline. */
import { matching } from './png.ts';
import { difference, expect, test } from './support.ts';

test('works with the keyboard alone, and the focus can always be seen', async ({ app }) => {
  await app.open();
  const { page } = app;
  const focused = (): Promise<{ id: string; outline: boolean }> =>
    page.evaluate(() => {
      const element = document.activeElement as HTMLElement;
      // The visible part of a radio button is its label's text.
      const shown =
        element instanceof HTMLInputElement && element.type === 'radio' ? element.nextElementSibling! : element;
      const style = getComputedStyle(shown);
      return {
        id: element.dataset['testid'] ?? element.tagName,
        outline: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
      };
    });
  const reach = async (id: string): Promise<void> => {
    for (let presses = 0; presses < 90; presses += 1) {
      const now = await focused();
      if (now.id === id) {
        expect(now.outline, `outline of ${id}`).toBe(true);
        return;
      }
      await page.keyboard.press('Tab');
    }
    throw new Error(`Tab does not reach ${id}.`);
  };

  // From the top of the page, the keys are two Tab presses away.
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Go to the keys' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(app.by('key-0-go')).toBeFocused();
  // The keys are one tab stop; arrow keys move among them.
  await page.keyboard.press('ArrowRight');
  await expect(app.by('key-0-edit')).toBeFocused();
  await page.keyboard.press('End');
  await expect(app.by('key-2-edit')).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(app.by('key-0-go')).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(app.by('add-file')).toBeFocused();
  await reach('timeline');
  await page.keyboard.press('End');
  await page.keyboard.press('End');
  await app.settled();
  const beyond = await app.positions();
  await reach('boundary-natural');
  await page.keyboard.press('ArrowRight');
  await app.settled();
  expect((await app.state()).doc.motion.boundary).toBe('hermite');
  expect((await app.state()).time).toBeCloseTo(1.4, 9);
  expect(difference(await app.positions(), beyond)).toBeGreaterThan(0);
  await reach('start-speed');
  await page.keyboard.press('ArrowRight');
  expect((await app.state()).doc.motion.startSpeed).toBeCloseTo(0.05, 9);
  await reach('key-0-go');
  for (let step = 0; step < 3; step += 1) await page.keyboard.press('ArrowRight');
  await expect(app.by('key-1-edit')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(app.by('key-editor')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(app.by('key-editor')).toBeHidden();
  await page.keyboard.press('e');
  await expect(app.by('export-dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Shift+?');
  await expect(app.by('help-dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await page.keyboard.press('m');
  expect((await app.state()).doc.motion.method).toBe('geodesic');
  await page.keyboard.press('Control+z');
  expect((await app.state()).doc.motion.method).toBe('lri');
  await app.expectNoProblems();
});

test('single-letter shortcuts can be switched off', async ({ app }) => {
  await app.open();
  await app.by('help').click();
  await app.by('single-keys').uncheck();
  await app.by('help-close').click();
  await app.page.keyboard.press('m');
  expect((await app.state()).doc.motion.method).toBe('lri');
  await app.page.keyboard.press('ArrowRight');
  expect((await app.state()).time).toBeCloseTo(0.01, 9);
});

test.describe('at 360 px', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, ownProfile: true });

  test('everything is visible and fits', async ({ app }) => {
    await app.open();
    const { page } = app;
    const overflow = (): Promise<number> =>
      page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    expect(await overflow()).toBeLessThanOrEqual(0);
    const slider = (await app.by('timeline').boundingBox())!;
    expect(slider.width).toBeGreaterThan(280);
    expect(slider.height).toBeGreaterThanOrEqual(44);
    const picture = (await app.by('viewport').boundingBox())!;
    expect(picture.height).toBeGreaterThan(300);
    await expect(app.by('link')).toBeInViewport({ ratio: 1 });
    const before = await app.positions();
    await page.touchscreen.tap(slider.x + slider.width * 0.45, slider.y + 10);
    await app.settled();
    expect(difference(await app.positions(), before)).toBeGreaterThan(0);
    await app.by('tab-motion').tap();
    await app.by('boundary-periodic').check();
    await app.settled();
    expect((await app.state()).doc.motion.boundary).toBe('periodic');
    for (const tab of ['shape', 'analysis']) {
      await app.by(`tab-${tab}`).tap();
      await expect(app.by(`panel-${tab}`)).toBeVisible();
      expect(await overflow()).toBeLessThanOrEqual(0);
    }
    await app.by('tab-analysis').tap();
    await expect(app.by('panel-analysis')).toBeHidden();
    await app.by('tab-keys').tap();
    await expect(app.by('key-0-go')).toBeVisible();
    await app.expectNoProblems();
  });
});

test('at 360 px a message covers no text partly', async ({ app }) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await app.open();
  await app
    .by('file-input')
    .setInputFiles({ name: 'broken.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from('glTF') });
  await expect(app.by('error')).toBeVisible();
  const [status, message] = [(await app.by('status').boundingBox())!, (await app.by('error').boundingBox())!];
  expect(status.y + status.height).toBeLessThanOrEqual(message.y + 1);
  await app.by('error-close').click();
  await app.by('timeline').click(); // the welcome disappears too
  await expect(app.by('status-ms')).toBeVisible();
});

test.describe('while it is loaded', () => {
  test.use({ fresh: true });

  test('requests nothing from other hosts, under a policy that forbids inline scripts', async ({ app }) => {
    await app.open();
    const { page } = app;
    const { origin } = new URL(page.url());
    expect(app.requests.length).toBeGreaterThan(3);
    expect(app.requests.filter((url) => new URL(url).origin !== origin && !/^(data|blob):/.test(url))).toEqual([]);
    const policy = (await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content'))!;
    const scripts = /script-src ([^;]*)/.exec(policy)![1]!;
    expect(scripts.split(' ').sort()).toEqual(["'self'", "'wasm-unsafe-eval'"]);
    const ran = await page.evaluate(async () => {
      const script = document.createElement('script');
      script.textContent = 'window.injected = true';
      document.head.append(script);
      const elsewhere = await fetch('https://example.invalid/').then(
        () => true,
        () => false,
      );
      return { script: 'injected' in window, elsewhere };
    });
    expect(ran).toEqual({ script: false, elsewhere: false });
  });
});

test('contrast themes keep the timeline, the choices and the selection visible', async ({ app }) => {
  await app.page.emulateMedia({ forcedColors: 'active' });
  await app.open();
  const background = (selector: string): Promise<string> =>
    app.page
      .locator(selector)
      .first()
      .evaluate((element) => getComputedStyle(element).backgroundColor);
  const canvas = await background('.deck');
  expect(await background('.key-range')).not.toBe(canvas);
  expect(await background('.diamond')).not.toBe(canvas);
  // The timeline's three parts: between the keys, beyond them, and the keys.
  const drawn = await app.by('timeline').screenshot();
  const share = (of: (rgb: readonly [number, number, number]) => boolean): number => matching(drawn, of).share;
  expect(share(([r, g, b]) => g > r + 60 && g > b + 20)).toBeGreaterThan(0.05);
  expect(share(([r, g, b]) => r > b + 90 && g > b + 60)).toBeGreaterThan(0.02);
  expect(share(([r, g, b]) => b > r + 100 && b > g + 20)).toBeGreaterThan(0.002);
  const segment = (state: string): Promise<string> => background(`[data-testid="boundary"] input${state} + span`);
  expect(await segment(':checked')).not.toBe(await segment(':not(:checked)'));
  await expect(app.page.locator('.segments').first()).toHaveCSS('border-top-width', '1px');
  // Announcements have one text colour on one background.
  await app.page.keyboard.press('x');
  const toast = app.page.locator('.toast');
  await expect(toast).toBeVisible();
  await expect(toast).toHaveCSS('forced-color-adjust', 'none');
  expect(await toast.evaluate((one) => getComputedStyle(one).color)).not.toBe(await background('.toast'));
});

test.describe('with a service worker', () => {
  test.use({ ownProfile: true });

  test('works offline after the first visit', async ({ app, context }, info) => {
    test.skip(info.project.name === 'dev', 'the development server has no service worker');
    await app.open();
    await app.page.evaluate(() => navigator.serviceWorker.ready);
    // On a first visit, the service worker takes control of the page once its files are stored.
    await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const kept = await app.page.evaluate(async () => {
      const caches = await Promise.all((await window.caches.keys()).map((name) => window.caches.open(name)));
      return (await Promise.all(caches.map((cache) => cache.keys()))).flat().map(({ url }) => url);
    });
    expect(kept.filter((url) => /shapespline-[^/]*\.wasm$/.test(url))).toHaveLength(1);
    expect(kept.filter((url) => /\/picture\.png$|\.md$/.test(url))).toEqual([]); // only the repository uses these files
    await context.setOffline(true);
    await app.open();
    expect((await app.positions()).length).toBeGreaterThan(0);
    await app.pick('dachshund');
    await app.settled();
    await expect(app.by('error')).toBeHidden();
    await context.setOffline(false);
  });
});
