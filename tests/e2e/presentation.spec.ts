/** A lecture: the shape or a plot alone, in large type, with keyboard control, and a link for the audience. */
import { expect, test } from './support.ts';
import type { App } from './support.ts';

const presented = async (app: App): Promise<string | null> => (await app.state()).view.present;
const sizeOf = (app: App, testId: string): Promise<number> =>
  app.by(testId).evaluate((element) => parseFloat(getComputedStyle(element).fontSize));

test('X shows only the shape, in large type, and Escape restores the page', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  const small = await sizeOf(app, 'phase');
  await app.page.keyboard.press('x');
  await expect(app.by('timeline')).toBeHidden();
  for (const away of ['export', 'method', 'fit', 'play']) await expect(app.by(away)).toBeHidden();
  const [view, page] = [(await app.by('viewport').boundingBox())!, app.page.viewportSize()!];
  expect([view.width, view.height]).toEqual([page.width, page.height]);
  expect(await sizeOf(app, 'phase')).toBeGreaterThan(1.5 * small);
  // A presenter's clicker moves between keys, and the presenter's keyboard works.
  await app.page.keyboard.press('PageDown');
  expect((await app.state()).time).toBe(0.5);
  await app.page.keyboard.press(']');
  expect((await app.state()).time).toBe(1);
  await app.page.keyboard.press('PageUp');
  await expect(app.by('phase')).toContainText('At key 2');
  await app.page.keyboard.press(' ');
  expect((await app.state()).play.playing).toBe(true);
  await app.page.keyboard.press(' ');
  const compared: string[] = [];
  for (let i = 0; i < 8; i += 1) {
    await app.page.keyboard.press('c');
    compared.push((await app.state()).view.compare.join());
  }
  expect(compared).toEqual(['linear', 'cubic-vertex', 'geodesic', 'rotation-strain', 'rimd', 'lengths', 'shell', '']);
  expect((await app.state()).view.split).toBeNull();
  await app.page.keyboard.press('Escape');
  await expect(app.by('timeline')).toBeVisible();
  expect(await presented(app)).toBeNull();
  await app.expectNoProblems();
});

test('A shows one plot after the other, large, beside the shape', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2&compare=linear' });
  const seen: (string | null)[] = [];
  for (const plot of ['plane', 'volume', 'area', 'bending']) {
    await app.page.keyboard.press('a');
    seen.push(await presented(app));
    const figure = app.by(`plot-${plot}`);
    await expect(figure.locator('svg.plot .curve').first()).toBeVisible();
    await expect(app.page.locator('.figure:visible')).toHaveCount(1);
    if (plot === 'plane') expect(await sizeOf(app, 'plane-draw')).toBeGreaterThan(16);
    const { width } = (await figure.boundingBox())!;
    expect(width).toBeGreaterThan(0.55 * app.page.viewportSize()!.width);
    expect((await app.by('viewport').boundingBox())!.width).toBeGreaterThan(0.3 * app.page.viewportSize()!.width);
  }
  expect(seen).toEqual(['plane', 'volume', 'area', 'bending']);
  await app.page.keyboard.press('a');
  expect(await presented(app)).toBe('shape');
  await app.page.mouse.move(300, 300);
  await app.page.mouse.move(310, 300);
  await app.by('leave-presentation').click();
  expect(await presented(app)).toBeNull();
});

test('a link opens the lecture mode, and its QR code contains the link', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.25&present=volume' });
  await expect(app.by('timeline')).toBeHidden();
  await expect(app.by('plot-volume').locator('.curve').first()).toBeVisible();
  await app.page.keyboard.press('q');
  await expect(app.by('qr-link')).toContainText('present=volume');
  await expect(app.by('qr-link')).toContainText('t=0.25');
  const link = await app.by('qr-link').textContent();
  await expect(app.by('qr')).toBeVisible();
  // The QR code encodes this link, with the quiet zone that scanners need, dark on light in both themes.
  const [, size] = /^0 0 (\d+) \d+$/.exec((await app.by('qr').getAttribute('viewBox'))!)!;
  const modules = Number(size) - 8;
  expect((modules - 17) % 4).toBe(0);
  expect(modules).toBeGreaterThan(25);
  await app.by('qr-close').click();
  await expect(app.by('link-dialog')).toBeHidden();
  expect(await presented(app)).toBe('volume');
  await app.page.goto('about:blank');
  await app.page.goto(link!);
  await app.started();
  expect(await presented(app)).toBe('volume');
});

test('can be started with the mouse, and is listed in the help', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.by('help').click();
  await expect(app.by('help-dialog')).toContainText('Presentation mode: only the shape, with large type');
  await expect(app.by('help-dialog')).toContainText('QR code of the link');
  await app.by('help-close').click();
  await app.by('look-toggle').click();
  await app.by('present').click();
  expect(await presented(app)).toBe('shape');
  await expect(app.by('timeline')).toBeHidden();
  await app.page.keyboard.press('Escape');
  await app.by('plot-volume').scrollIntoViewIfNeeded();
  await app.by('enlarge-volume').click();
  expect(await presented(app)).toBe('volume');
});
