/** A reset page equals a loaded one. Tests that share a page rely on this. */
import { expect, test } from './support.ts';
import type { App } from './support.ts';

/** Everything visible and selectable, the focus, and the browser's storage. */
async function seen(app: App) {
  const page = await app.page.evaluate(() => {
    // Measured times, which also determine the number of points in a curve.
    const measured = (one: Element): boolean => one.closest('[data-testid="status-ms"], .facts, .gallery') !== null;
    const told = (one: HTMLElement): string => {
      const { value = '', checked = false, disabled = false } = one as HTMLInputElement;
      const own = [...one.childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
      const attributes = ['aria-pressed', 'aria-expanded', 'aria-current', 'aria-valuetext', 'title', 'open'];
      return JSON.stringify([
        one.dataset['testid'] ?? `${one.tagName}.${one.getAttribute('class') ?? ''}`,
        own.map(({ textContent }) => textContent).join(''),
        ...[value, checked, disabled],
        attributes.map((name) => one.getAttribute(name)),
      ]);
    };
    const all = [...document.querySelectorAll<HTMLElement>('body *')].filter((one) => !measured(one));
    return {
      visible: all.filter((one) => one.checkVisibility({ visibilityProperty: true })).map(told),
      fields: [...document.querySelectorAll<HTMLInputElement>('input, select')]
        .filter((one) => one.dataset['testid'] && one.type !== 'file' && !one.closest('[hidden], dialog'))
        .map((one) => `${one.dataset['testid']} ${one.value} ${one.checked}`),
      open: document.querySelectorAll('dialog[open], details[open]').length,
      scrolled: all.filter(({ scrollTop, scrollLeft }) => scrollTop + scrollLeft > 0).map(told),
      toast: document.querySelector('[data-testid="toast"]')!.textContent,
      focus: document.activeElement === document.body,
      scheme: document.documentElement.style.colorScheme,
      address: location.hash,
      title: document.title,
      kept: { ...localStorage },
      state: window.__shapespline!.state,
      positions: Array.from(window.__shapespline!.positions()),
      screen: Array.from(window.__shapespline!.project([0, 0, 0, 1, 1, 1])),
    };
  });
  const projects = await app.page.evaluate(
    () =>
      new Promise<number>((done) => {
        const opening = indexedDB.open('shapespline');
        opening.onsuccess = () => {
          const { result } = opening;
          if (!result.objectStoreNames.contains('remembered')) return done(0);
          const counting = result.transaction('remembered').objectStore('remembered').count();
          counting.onsuccess = () => {
            result.close();
            done(counting.result);
          };
        };
      }),
  );
  return { ...page, projects };
}

/** Waits until all automatic content is complete. */
async function complete(app: App): Promise<void> {
  await app.settled();
  await expect(app.by('speed-curve')).toBeVisible();
  await expect(app.page.locator('.key-list img[src]')).toHaveCount(3);
  await expect(app.by('faces')).toBeAttached();
  await expect.poll(() => app.page.evaluate(() => location.hash)).toContain('sample=cactus');
  // Charts are drawn once they are visible.
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await app.analysed();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(1);
  await app.page.locator('.side').evaluate((side) => side.scrollTo(0, 0));
  await app.nextFrame();
}

/** What is seen once two looks in a row are equal. Under load, some content appears late. */
async function seenAtRest(app: App) {
  let before = await seen(app);
  await expect(async () => {
    const now = await seen(app);
    const then = before;
    before = now;
    expect(now).toEqual(then);
  }).toPass({ intervals: [300], timeout: 20_000 });
  return before;
}

test('after many changes, the reset page equals a first visit', async ({ app }) => {
  test.slow();
  await app.open();
  await complete(app);
  const fresh = await seenAtRest(app);
  const { page } = app;
  const pose = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`;
  const given = (name: string, x: number) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(pose(x)) });

  // Opens files of the user, which are stored, edits them and changes the time.
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2), given('c.obj', -0.1)]);
  await expect(app.by('remember')).toHaveAttribute('aria-pressed', 'true');
  await app.by('boundary-hermite').check();
  await app.by('method').selectOption('cubic-vertex');
  await app.by('compare-linear').check();
  await app.by('speed').selectOption('4');
  await app.by('loop').click();
  await app.setTime(0.7);
  await app.by('add-current').click();
  await app.by('key-1-edit').click();
  await app.by('key-name').fill('other');
  await page.keyboard.press('Enter');
  // Changes the view, the theme and the clock.
  await app.by('view-right').click();
  await app.by('look-toggle').click();
  await app.by('wireframe').check();
  await app.by('floor').uncheck();
  await app.by('theme').click();
  await app.by('timeline').hover();
  await page.mouse.wheel(0, -300);
  await page.keyboard.press('Control+Home');
  // Shows charts, their values, a face and a patch.
  await app.by('plot-volume').scrollIntoViewIfNeeded();
  await app.by('volume-values').locator('summary').press('Enter');
  await app.by('face-number').fill('0');
  await app.by('face-number').press('Enter');
  await app.by('part-patch').check({ force: true });
  await app.by('patch-number').fill('1');
  await app.by('patch-number').press('Enter');
  await app.by('heat-distance').check({ force: true });
  await app.by('mesh-report').locator('summary').press('Enter');
  // Opens dialogs and causes an error and a temporary message.
  await app.by('help').click();
  await app.by('single-keys').uncheck();
  await app.by('help-close').click();
  await app.by('export').click();
  await app.by('export-kind-picture').check();
  await app.by('export-pixels').selectOption('4k');
  await app.by('export-close').click();
  await app
    .by('file-input')
    .setInputFiles({ name: 'bad.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from('?') });
  await expect(app.by('error')).toBeVisible();
  await app.by('export').click();

  await page.setViewportSize({ width: 1280, height: 720 });
  await page.mouse.move(0, 0);
  await page.evaluate(() => window.__shapespline!.reset());
  await complete(app);
  const after = await seenAtRest(app);
  const without = (a: string[], b: string[]): string[] => a.filter((one) => !b.includes(one));
  expect({ more: without(after.visible, fresh.visible), less: without(fresh.visible, after.visible) }).toEqual({
    more: [],
    less: [],
  });
  expect(after).toEqual(fresh);
  await app.by('export').click();
  await expect(app.by('export-kind-animation')).toBeChecked();
  await app.expectNoProblems();
});
