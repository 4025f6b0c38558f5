/**
 * One walk with axe through the page's states: a wide page, a phone, dialogs, charts, the guide, a lecture. Checking
 * the whole page takes a second, so only a state's new parts are checked.
 */
import { expectAccessible } from './axe.ts';
import type { App } from './support.ts';
import { expect, test } from './support.ts';

/** Checks all rules in the light theme, and again those that may differ in the dark theme. */
async function expectAccessibleInBoth(app: App, parts: string[] = []): Promise<void> {
  await app.page.emulateMedia({ colorScheme: 'light' });
  await expectAccessible(app, { parts });
  await app.page.emulateMedia({ colorScheme: 'dark' });
  await expectAccessible(app, { parts, rules: ['color-contrast'] });
}

test('a wide page with everything open', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('compare-linear').check();
  await app.settled();
  await app.by('look-toggle').click();
  await expectAccessibleInBoth(app);
});

test('the gallery, the clock and the editor of a key', async ({ app }) => {
  await app.open();
  await app.by('sample').click();
  await expectAccessible(app, { parts: ['.app-header'] });
  await app.page.keyboard.press('Escape');
  await app.by('clock-toggle').click();
  await expect(app.by('clock')).toBeVisible();
  await expectAccessible(app, { parts: ['[data-testid="clock"]'] });
  await app.page.keyboard.press('Escape');
  await app.by('key-0-edit').click();
  await expect(app.by('key-editor')).toBeVisible();
  await expectAccessibleInBoth(app, ['[data-testid="key-editor"]']);
});

test('dialogs and messages', async ({ app }) => {
  await app.open();
  for (const dialog of ['export', 'help']) {
    await app.by(dialog).click();
    await expect(app.by(`${dialog}-dialog`)).toBeVisible();
    await expectAccessibleInBoth(app, [`[data-testid="${dialog}-dialog"]`]);
    await app.by(`${dialog}-close`).click();
  }
  await app
    .by('file-input')
    .setInputFiles({ name: 'bad.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from('<html>') });
  await expect(app.by('error')).toBeVisible();
  await expectAccessibleInBoth(app, ['[data-testid="error"]']);
});

test('a phone: two motions beside a divider, and its sheets', async ({ app }) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await app.open({ hash: '#sample=twisted-bar&compare=linear&split=0.5&floor=0&t=0.25' });
  await expect(app.by('divider')).toBeVisible();
  await expectAccessible(app);
  for (const [tab, part] of [
    ['tab-keys', '.key-strip'],
    ['tab-analysis', '.side'],
  ] as const) {
    await app.by(tab).click();
    await expect(app.page.locator(part)).toBeVisible();
    await expectAccessible(app, { parts: [part, '.tabs'] });
  }
});

test('charts of faces and patches with their values', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance&boundary=hermite' });
  const parts = ['[data-testid="panel-analysis"]', '.colour-bar'];
  await app.by('face-number').fill('3');
  await app.by('face-number').press('Enter');
  await expect(app.by('plot-face-rotation').locator('path.curve').first()).toBeVisible();
  for (const plot of ['face-rotation', 'distance']) await app.by(`${plot}-values`).locator('summary').press('Enter');
  await expectAccessibleInBoth(app, parts);
  await app.by('part-patch').check({ force: true });
  await app.by('patch-number').fill('2');
  await app.by('patch-number').press('Enter');
  await expect(app.by('plot-patch-rotation').locator('path.curve').first()).toBeVisible();
  await expectAccessible(app, { parts: ['[data-testid="faces"]'] });
});

test('the comparison of ghost sizes', { tag: '@all' }, async ({ app }) => {
  test.slow();
  await app.open({ hash: '#sample=twisted-bar' });
  await app.by('ghost').check();
  await app.by('ghost-difference').check();
  await app.settled();
  await app.by('study-start').click();
  await expect(app.by('study-verdict')).toBeVisible({ timeout: 120_000 });
  for (const summary of await app.by('study').locator('summary').all()) await summary.press('Enter');
  await expectAccessibleInBoth(app, ['[data-testid="panel-ghost"]', '.colour-bar']);
});

test('the guide with the playground, and on a projector', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#tour=6' });
  await expect(app.page.frameLocator('.framed').getByTestId('curve-notice')).not.toBeEmpty();
  await app.settled();
  await expectAccessibleInBoth(app);
  await app.page.keyboard.press('x');
  await expect(app.by('timeline')).toBeHidden();
  await app.page.keyboard.press('a');
  await expect(app.page.locator('.figure:visible svg.plot .curve').first()).toBeVisible();
  await expectAccessible(app);
});
