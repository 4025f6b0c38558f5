/** The playground: dragging, typing, playing, links, saving, screen readers, and the connection to the app. */
import { readFileSync } from 'node:fs';
import { AxeBuilder } from '@axe-core/playwright';
import type { Locator, Page } from '@playwright/test';
import { App, expect, test } from './support.ts';

// The test uses another page than the app.
test.use({ fresh: true });

class Playground {
  readonly problems: string[] = [];

  constructor(readonly page: Page) {
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type()) && !/Service Worker/.test(message.text()))
        this.problems.push(message.text());
    });
    page.on('pageerror', (error) => this.problems.push(error.message));
  }

  async open(hash = ''): Promise<this> {
    await this.page.goto(`./play.html${hash}`);
    await expect(this.by('curve-notice')).not.toBeEmpty();
    return this;
  }

  by(testId: string): Locator {
    return this.page.getByTestId(testId);
  }

  async value(key: number): Promise<number> {
    return Number(await this.by(`key-${key}-value`).inputValue());
  }

  async time(key: number): Promise<number> {
    return Number(await this.by(`key-${key}-time`).inputValue());
  }

  async drag(target: Locator, x: number, y: number): Promise<void> {
    const box = (await target.boundingBox())!;
    const [left, top] = [box.x + box.width / 2, box.y + box.height / 2];
    await this.page.mouse.move(left, top);
    await this.page.mouse.down();
    await this.page.mouse.move(left + x / 2, top + y / 2);
    await this.page.mouse.move(left + x, top + y);
    await this.page.mouse.up();
  }

  /** The drawn outline of a curve. */
  line(layer: string): Promise<string | null> {
    return this.page.locator(`.curve-figure .curve.${layer}`).last().getAttribute('d');
  }

  async expectAccessible(rules?: string[]): Promise<void> {
    const axe = new AxeBuilder({ page: this.page });
    const { violations } = await (rules ? axe.withRules(rules) : axe).analyze();
    expect(
      violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => String(target)).join(' | ')}`),
    ).toEqual([]);
  }
}

/** Waits for this many drawn frames. */
const frames = (page: Page, count: number): Promise<void> =>
  page.evaluate(async (left) => {
    for (let i = 0; i < left; i += 1) await new Promise(requestAnimationFrame);
  }, count);

test('a dragged key carries the curve, its numbers and the system along', async ({ page }) => {
  const play = await new Playground(page).open();
  const before = await play.line('natural');
  const [value, time] = [await play.value(2), await play.time(2)];
  await play.drag(play.by('key-2'), 40, -60);
  expect(await play.value(2)).toBeGreaterThan(value + 0.05);
  expect(await play.time(2)).toBeGreaterThan(time + 0.01);
  expect(await play.line('natural')).not.toBe(before);
  await expect(play.by('curve-notice')).toContainText('Moving key 3 changes the whole curve');
  await expect(play.by('said')).toContainText('Key 3 of 5');
  await expect(page).toHaveURL(/#keys=/);
  // Pointing at a row of the system highlights its key.
  await play.by('system-row-3').hover();
  await expect(play.by('key-3')).toHaveClass(/lit/);
  await expect(play.by('system-notice')).toContainText('key 4');
  expect(play.problems).toEqual([]);
});

test('curves are switched on one by one, and the natural spline has the least bending', async ({ page }) => {
  const play = await new Playground(page).open();
  const bending = async (layer: string): Promise<number> => Number(await play.by(`bending-${layer}`).textContent());
  const natural = await bending('natural');
  for (const layer of ['hermite', 'periodic', 'catmull-rom']) {
    await play.by(`layer-${layer}`).check();
    expect(await play.line(layer)).toBeTruthy();
    expect(await bending(layer)).toBeGreaterThan(natural);
  }
  await play.by('layer-linear').check();
  await expect(play.by('bending-linear')).toHaveText('∞');
  await expect(play.by('slope-notice')).toContainText('jumps at the keys: Straight lines');
  await expect(play.by('bend-notice')).toContainText('Catmull-Rom');

  await play.by('layer-samples').check();
  const within = async (): Promise<number> =>
    Number(/within ([\d.]+)/.exec((await play.by('curve-notice').textContent())!)![1]);
  await play.by('samples').fill('5');
  await expect(page.locator('.curve-figure .sample')).toHaveCount(5);
  await play.by('samples').fill('10');
  await expect(page.locator('.curve-figure .sample')).toHaveCount(10);
  for (const dot of ['.curve-figure .sample', '.layer .sample']) {
    const [fill, text] = await page
      .locator(dot)
      .first()
      .evaluate((one) => [getComputedStyle(one).fill, getComputedStyle(document.body).color]);
    expect(fill, `${dot} is seen as text is`).toBe(text);
  }
  const coarse = await within();
  await play.by('samples').fill('60');
  await expect(page.locator('.curve-figure .sample')).toHaveCount(60);
  expect(await within()).toBeLessThan(coarse / 5);

  await play.by('layer-shaped').check();
  const plain = await play.line('shaped');
  await play.by('tension').fill('0.8');
  await expect.poll(() => play.line('shaped')).not.toBe(plain);
  await expect(play.by('curve-notice')).toContainText('Tension 0.8');
  expect(play.problems).toEqual([]);
});

test('the handles at the ends change the speeds, with mouse and keyboard', async ({ page }) => {
  const play = await new Playground(page).open('#show=hermite');
  const handle = page.getByRole('slider', { name: 'Speed at the first key' }).first();
  const before = await play.line('hermite');
  await play.drag(page.locator('.end-handle .grip-mark').first(), 30, -50);
  await expect.poll(() => play.by('start-speed').inputValue()).not.toBe('1');
  await handle.focus();
  for (let presses = 0; presses < 40; presses += 1) await page.keyboard.press('ArrowDown');
  await expect(play.by('start-speed')).toHaveValue('0');
  expect(await play.line('hermite')).not.toBe(before);
  // Several events may arrive before the page is drawn.
  await handle.evaluate((element) => {
    const press = (): boolean => element.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true }));
    for (let presses = 0; presses < 5; presses += 1) press();
  });
  await expect(play.by('start-speed')).toHaveValue('0.5');
});

test('works with the keyboard, with typed numbers, and in two dimensions', async ({ page }) => {
  const play = await new Playground(page).open();
  await play.by('key-1').focus();
  const [value, time] = [await play.value(1), await play.time(1)];
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect.poll(() => play.value(1)).toBeGreaterThan(value);
  await expect.poll(() => play.time(1)).toBeLessThan(time - 0.05);
  await expect(play.by('key-1')).toHaveAttribute('aria-valuetext', /^value 0\.\d+ at time 0\.1/);
  await play.by('add-key').click();
  await expect(play.by('key-5')).toBeVisible();
  await play.by('key-2').focus();
  await page.keyboard.press('Delete');
  await expect(play.by('key-5')).toHaveCount(0);
  await play.by('key-2-value').fill('0.6');
  await page.keyboard.press('Enter');
  await expect(play.by('key-2')).toHaveAttribute('aria-valuenow', '0.6000');

  const times = async (): Promise<number[]> => Promise.all([0, 1, 2, 3, 4].map((key) => play.time(key)));
  await play.by('dimensions-plane').check();
  await expect(play.by('key-2-across')).toBeVisible();
  const byHand = await play.line('natural');
  await play.by('spacing').selectOption('difference');
  await expect.poll(() => play.line('natural')).not.toBe(byHand);
  const byDistance = await times();
  await play.by('spacing').selectOption('even');
  await expect.poll(times).toEqual([0, 0.25, 0.5, 0.75, 1]);
  expect(byDistance).not.toEqual([0, 0.25, 0.5, 0.75, 1]);
  await play.drag(play.by('key-2'), 30, 20);
  await expect(play.by('key-2-across')).not.toHaveValue('0.3');
  expect(play.problems).toEqual([]);
});

test('the URL contains the whole state, and invalid URLs do no harm', async ({ page, context }) => {
  const play = await new Playground(page).open();
  await play.by('layer-periodic').check();
  await play.by('ends-periodic').check();
  await play.by('dimensions-plane').check();
  await play.drag(play.by('key-3'), -20, 30);
  await expect(page).toHaveURL(/plane=1/);
  const drawn = await play.line('periodic');
  const other = new Playground(await context.newPage());
  // Links have five digits, and the URL is updated shortly after.
  const numbers = (line: string | null): number[] => (line ?? '').match(/-?[\d.]+/g)!.map(Number);
  await expect(async () => {
    await other.page.goto('about:blank');
    await other.open(new URL(page.url()).hash);
    const [a, b] = [numbers(drawn), numbers(await other.line('periodic'))];
    expect(b).toHaveLength(a.length);
    a.forEach((number, index) => expect(Math.abs(number - b[index]!)).toBeLessThan(0.5));
  }).toPass();
  await expect(other.by('layer-periodic')).toBeChecked();
  await expect(other.by('ends-periodic')).toBeChecked();
  await other.open('#keys=NaN,1 2,3&samples=1e9&show=everything&t=Infinity');
  await expect(other.by('key-4')).toBeVisible();
  expect(other.problems).toEqual([]);
});

test('saves self-contained images, and the numbers of the curve', async ({ page }) => {
  const play = await new Playground(page).open('#show=linear natural');
  const saved = async (testId: string): Promise<{ name: string; bytes: Buffer }> => {
    const [file] = await Promise.all([page.waitForEvent('download'), play.by(testId).click()]);
    return { name: file.suggestedFilename(), bytes: readFileSync((await file.path())!) };
  };
  const svg = await saved('curve-svg');
  expect(svg.name).toBe('shapespline-curve.svg');
  const text = svg.bytes.toString();
  expect(text).not.toMatch(/class=|style=|var\(|system-ui/);
  expect(text).toMatch(/^<svg[^>]* width="170mm"/);
  expect(text).toMatch(/>Time t<\/text>.*rotate\(-90\)"[^>]*>Value</);
  const shown = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([source], { type: 'image/svg+xml' }));
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext('2d')!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let green = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 1]! > data[i]! + 60 && data[i + 1]! > data[i + 2]! + 20) green += 1;
    return { width: image.width, green };
  }, text);
  expect(shown.width).toBeGreaterThan(300);
  expect(shown.green, 'pixels of the natural spline').toBeGreaterThan(500);
  const png = await saved('weights-png');
  expect(png.bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(png.bytes.readUInt32BE(16)).toBeGreaterThan(1000);
  const csv = (await saved('curve-csv')).bytes.toString().trim().split('\n');
  expect(csv[0]).toBe('time,Straight lines,Natural cubic');
  expect(csv).toHaveLength(202);
  const middle = csv.map((row) => row.split(',').map(Number)).find(([t]) => Math.abs(t! - 0.5) < 1e-9)!;
  expect(middle[1]).toBeCloseTo(0.35, 6);
  expect(middle[2]).toBeCloseTo(0.35, 6);
  await play.by('weights-values').locator('summary').click();
  await expect(play.by('weights-values').locator('tbody tr')).toHaveCount(9);
  expect((await saved('system-csv')).bytes.toString()).toContain('key,m1,m2,m3,m4,m5,right side,slope');
  expect(play.problems).toEqual([]);
});

test('with reduced motion, nothing moves until the user starts it', async ({ page }) => {
  const play = await new Playground(page).open();
  const line = await play.line('natural');
  await frames(page, 40);
  expect(await play.line('natural')).toBe(line);
  await expect(play.by('scene')).toBeHidden();
  await play.by('demonstration').click();
  await expect(play.by('scene')).toBeVisible();
  await expect(play.by('layer-linear')).toBeChecked();
  await play.by('demonstration').click();
  await expect(play.by('scene')).toBeHidden();
});

test('it plays until the first touch, unless the user prefers reduced motion', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  const play = await new Playground(page).open();
  await expect(play.by('scene')).toHaveText('1 of 7');
  const moving = await play.line('linear');
  await expect.poll(() => play.line('linear')).not.toBe(moving);
  await page.locator('.curve-figure').click({ position: { x: 20, y: 20 } });
  await expect(play.by('scene')).toBeHidden();
  await frames(page, 2); // the pending frame is drawn
  const rests = await play.line('linear');
  await frames(page, 20);
  expect(await play.line('linear')).toBe(rests);
  expect(play.problems).toEqual([]);
});

test('axe finds nothing, in the light theme on a phone and in the dark one on a screen', { tag: '@all' }, async ({
  page,
}) => {
  const play = new Playground(page);
  const over = (): Promise<number> => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  await page.setViewportSize({ width: 320, height: 900 });
  await play.open('#show=linear natural samples catmull-rom hermite periodic shaped&plane=1');
  await play.by('curve-values').locator('summary').click();
  await play.expectAccessible();
  expect(await over(), 'wider than a phone').toBeLessThanOrEqual(0);
  await page.setViewportSize({ width: 1024, height: 900 });
  await page.emulateMedia({ colorScheme: 'dark' });
  await play.expectAccessible(['color-contrast']);
  expect(await over(), 'wider than a screen').toBeLessThanOrEqual(0);
});

test('contrast themes keep the curves and the selection visible', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  const play = await new Playground(page).open('#show=linear natural');
  const stroke = (layer: string): Promise<string> =>
    page
      .locator(`.curve-figure .curve.${layer}`)
      .last()
      .evaluate((line) => getComputedStyle(line).stroke);
  expect(await stroke('linear')).not.toBe(await stroke('natural'));
  await play.by('system-row-1').focus();
  await expect(play.by('system-row-1')).toHaveCSS('outline-style', 'solid');
});

test('shows an angle of the shape that is open in another tab, and sends times and ends back', { tag: '@all' }, async ({
  page,
  context,
}) => {
  const play = await new Playground(page).open();
  await expect(play.by('no-shape')).toBeVisible();
  const app = await new App(await context.newPage()).open({ sample: 'cactus' });
  await app.by('help').click();
  await expect(app.by('playground')).toHaveAttribute('href', './play.html');
  await app.by('help-close').click();
  await page.bringToFront();
  await play.open();
  await expect(play.by('take-real')).toBeVisible();
  await play.by('take-real').click();
  const { doc } = await app.state();
  await expect(play.by('figure-curve')).toContainText('Angle between patches');
  await expect(play.by(`key-${doc.keys.length - 1}`)).toBeVisible();
  await expect(play.by(`key-${doc.keys.length}`)).toHaveCount(0);
  const times = await Promise.all(doc.keys.map((_, key) => play.time(key)));
  expect(times).toEqual(doc.keys.map(({ time }) => time));
  const values = await Promise.all(doc.keys.map((_, key) => play.value(key)));
  expect(Math.max(...values) - Math.min(...values)).toBeGreaterThan(5);

  await play.by('ends-hermite').check();
  await play.by('start-speed').fill('0');
  await play.by('key-1-time').fill(String(times[1]! + 0.1 * (times[2]! - times[1]!)));
  await page.keyboard.press('Enter');
  await play.by('give-back').click();
  await expect(play.by('real-said')).toContainText('now moves like this');
  const after = (await app.state()).doc;
  expect(after.motion).toMatchObject({ boundary: 'hermite', startSpeed: 0 });
  expect(after.keys[1]!.time).toBeCloseTo(times[1]! + 0.1 * (times[2]! - times[1]!), 5);
  await app.page.bringToFront();
  await app.settled();
  await app.page.keyboard.press('Control+z');
  expect((await app.state()).doc).toEqual(doc);
  await app.expectNoProblems();
  expect(play.problems).toEqual([]);
});

test.describe('with a service worker', () => {
  test.use({ ownProfile: true });

  test('works offline after the first visit', async ({ page, context }, info) => {
    test.skip(info.project.name === 'dev', 'the development server has no service worker');
    const play = await new Playground(page).open();
    await page.evaluate(async () => {
      await navigator.serviceWorker.ready;
      if (!navigator.serviceWorker.controller)
        await new Promise((done) => navigator.serviceWorker.addEventListener('controllerchange', done, { once: true }));
    });
    await context.setOffline(true);
    await page.reload();
    await expect(play.by('curve-notice')).not.toBeEmpty();
    await play.drag(play.by('key-2'), 0, -40);
    await context.setOffline(false);
  });
});
