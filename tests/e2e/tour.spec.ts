import type { GuidePage } from '../../web/app/guide/guide-page.ts';
import { TOUR } from '../../web/app/guide/tour.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import type { App } from './support.ts';
import { expect, test } from './support.ts';

const QUAD = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`;
const given = (name: string, x: number) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(QUAD(x)) });

const title = (app: App) => app.by('guide').getByRole('heading');
const fragment = (app: App): string => new URL(app.page.url()).hash;

/** Expects the page of the guide, with its link's state. */
async function expectPage(app: App, step: GuidePage): Promise<void> {
  const link = readPermalink(step.state)!;
  await expect(title(app)).toHaveText(step.title);
  await expect.poll(async () => (await app.state()).source).toEqual({ kind: 'sample', id: link.sample });
  await app.settled();
  const { doc, view, play, time } = await app.state();
  expect(view.compare).toEqual(link.view.compare ?? []);
  expect(view.colouring).toBe(link.view.colouring ?? view.colouring);
  expect(play.between).toEqual(link.between);
  expect(time).toBe(link.time);
  expect(doc.motion.boundary).toBe(link.motion.boundary ?? 'natural');
  if (link.keys) expect(doc.keys.map(({ pose, time: at }) => [pose, at])).toEqual(link.keys);
  await expect.poll(() => fragment(app)).toBe(`#${step.link}`);
}

const expectStep = (app: App, index: number): Promise<void> => expectPage(app, TOUR[index]!);

test('a link opens a step, and its numbers match the engine', async ({ app }) => {
  await app.open({ hash: '#tour=3' });
  await expectStep(app, 2);
  const { patches } = await app.stats();
  await expect(app.by('guide-live')).toHaveText(`20,568 faces in ${patches.toLocaleString('en')} patches.`);
  await app.by('guide-previous').click();
  await expectStep(app, 1);
  await app.setTime(0.25);
  const volumes = await app.page.locator('.tile-label').allTextContents();
  const [ours, blended] = volumes.map((text) => Math.round(Number(/volume ([\d.]+)\s%/.exec(text)![1])));
  expect(blended).toBeLessThan(60);
  await expect(app.by('guide-live')).toHaveText(`Volume now: ${blended} % blended, ${ours} % in shape space.`);
});

test('in the eighth step, a face far beyond the keys is inverted, but not with logarithmic stretch', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ hash: '#tour=8' });
  await expect(app.by('guide-live')).toHaveText(
    /has -\d+ % of its width in the reference pose: it would be inside out/,
  );
  await app.by('stretch-log').check();
  await expect(app.by('guide-live')).toHaveText(
    /has [1-9]\d* % of its width in the reference pose: it only becomes narrower/,
  );
  await app.expectNoProblems();
});

test('earlier content returns with its edits, and undo does not include the tour', async ({ app }) => {
  await app.open();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.by('boundary-hermite').check();
  await app.settled();
  const before = await app.state();
  await app.page.evaluate(() => (location.hash = '#tour=4'));
  await expectStep(app, 3);
  await app.by('guide-next').click();
  await expectStep(app, 4);
  await app.page.keyboard.press('Escape');
  await expect(app.by('guide')).toHaveCount(0);
  await expect.poll(async () => (await app.state()).source).toEqual(before.source);
  await app.settled();
  expect((await app.state()).doc).toEqual(before.doc);
  expect((await app.state()).play).toEqual(before.play);
  await app.by('undo').click();
  await expect.poll(async () => (await app.state()).doc.motion.boundary).toBe('natural');
  await expect(app.by('undo')).toHaveAttribute('title', /open a\.obj/);
});

test('closed while its page is being opened, it restores the content and the focus', async ({ app }) => {
  await app.open();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const { source, doc } = await app.state();
  let arrive = (): void => undefined;
  const held = new Promise<void>((done) => (arrive = done));
  let asked = 0;
  await app.page.route(/samples\/twisted-bar/, async (route) => {
    asked += 1;
    await held;
    await route.continue().catch(() => undefined); // the page is no longer waiting for it
  });
  await app.by('help').focus();
  await app.page.keyboard.press('Enter');
  await app.by('help-tour').focus();
  await app.page.keyboard.press('Enter');
  await expectStep(app, 0);
  await expect(title(app)).toBeFocused();
  await app.by('guide-next').focus();
  await app.page.keyboard.press('Enter');
  await expect(title(app)).toHaveText(TOUR[1]!.title);
  await expect.poll(() => asked).toBeGreaterThan(0);
  await app.page.keyboard.press('Escape');
  await app.page.keyboard.press('Escape'); // the user presses keys quickly
  await expect(app.by('guide')).toHaveCount(0);
  await expect(app.by('help')).toBeFocused();
  arrive();
  await expect.poll(async () => (await app.state()).source).toEqual(source);
  await app.settled();
  expect((await app.state()).source).toEqual(source);
  expect((await app.state()).doc).toEqual(doc);
  await expect.poll(() => fragment(app)).toBe('');
});

test.describe('while it is loaded', () => {
  test.use({ fresh: true });

  test('requested before anything is open, it opens, and then restores the content that was being loaded', {
    tag: '@all',
  }, async ({ app }) => {
    const heldBack = async (what: RegExp) => {
      let arrive = (): void => undefined;
      const held = new Promise<void>((done) => (arrive = done));
      const asked = app.page.waitForRequest(what);
      await app.page.route(what, async (route) => {
        await held;
        await route.continue().catch(() => undefined); // the page is no longer waiting for it
      });
      return { asked, arrive };
    };
    const leave = async (): Promise<void> => {
      await app.page.keyboard.press('Escape');
      await expect(app.by('guide')).toHaveCount(0);
    };
    const list = await heldBack(/samples\.json/);
    await app.page.goto('./');
    await list.asked;
    await app.page.waitForFunction(() => window.__shapespline !== undefined);
    await app.page.evaluate(() => (location.hash = '#tour=2'));
    list.arrive();
    await app.started();
    await expectStep(app, 1);
    await leave();
    await expect.poll(async () => (await app.state()).source).toEqual({ kind: 'sample', id: 'column' });
    expect((await app.state()).view.compare).toEqual(['linear']);
    const octopus = await heldBack(/samples\/octopus/);
    await app.page.goto('about:blank');
    await app.page.goto('./#sample=octopus');
    await octopus.asked;
    await app.page.evaluate(() => (location.hash = '#tour=2'));
    await expectStep(app, 1);
    octopus.arrive();
    await leave();
    await expect.poll(async () => (await app.state()).source).toEqual({ kind: 'sample', id: 'octopus' });
    // Closing the guide restores files opened before the link.
    const late = await heldBack(/samples\.json/);
    await app.page.goto('about:blank');
    await app.page.goto('./');
    await late.asked;
    await app.page.waitForFunction(() => window.__shapespline !== undefined);
    await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
    await expect.poll(async () => (await app.state()).source.kind).toBe('files');
    await app.page.evaluate(() => (location.hash = '#tour=2'));
    late.arrive();
    await expectStep(app, 1);
    await leave();
    await expect.poll(async () => (await app.state()).source.kind).toBe('files');
    await app.expectNoProblems();
  });
});

test('the Back button of the browser leaves the tour, and Forward returns to it', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await expect.poll(() => fragment(app)).toBe('');
  const { source, doc } = await app.state();
  await app.page.evaluate(() => (location.hash = '#tour=7'));
  await expectStep(app, 6);
  await app.page.goBack();
  await expect(app.by('guide')).toHaveCount(0);
  await expect.poll(async () => (await app.state()).source).toEqual(source);
  await app.settled();
  expect((await app.state()).doc).toEqual(doc);
  await app.page.goForward();
  await expectStep(app, 6);
  await app.reload();
  await expectStep(app, 6);
  await app.expectNoProblems();
});

test('the panel that a step mentions is visible, although plots above it are loaded later', {
  tag: '@all',
}, async ({ app }) => {
  for (const [link, part] of [
    ['tour=3', 'faces'],
    ['tour=5', 'plot-bending'],
  ] as const) {
    await app.open({ hash: `#${link}` });
    const side = (await app.page.locator('.side').boundingBox())!;
    const from = async (): Promise<number> => ((await app.by(part).boundingBox())?.y ?? NaN) - side.y;
    await expect(app.by('plot-bending').locator('path.curve').first()).toBeAttached();
    await expect.poll(from, `${link}: below the row of names`).toBeGreaterThan(0);
    await expect.poll(from, `${link}: not further down`).toBeLessThan(0.6 * side.height);
  }
  // The user's scroll position stays when the content changes.
  await app.page.locator('.side').hover();
  await app.page.mouse.wheel(0, -4000);
  await expect.poll(() => app.page.locator('.side').evaluate((side) => side.scrollTop)).toBeLessThan(200);
  await app.by('compare-cubic-vertex').uncheck();
  await app.settled();
  expect(await app.page.locator('.side').evaluate((side) => side.scrollTop)).toBeLessThan(200);
});

test('a step contains the playground, in which an angle of the shape can be dragged', async ({ app }) => {
  await app.open({ hash: '#tour=6' });
  await expectStep(app, 5);
  const play = app.page.frameLocator('.framed');
  await expect(play.getByTestId('figure-curve')).toContainText('Angle between patches');
  await expect(play.locator('.play-header')).toBeHidden();
  const keys = (await app.state()).doc.keys.length;
  await expect(play.getByTestId(`key-${keys - 1}`)).toBeVisible();
  const line = (): Promise<string | null> => play.locator('.curve-figure .curve.natural').last().getAttribute('d');
  const before = await line();
  const dot = (await play.getByTestId('key-1').boundingBox())!;
  await app.page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
  await app.page.mouse.down();
  await app.page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2 - 30, { steps: 3 });
  await app.page.mouse.up();
  await expect.poll(line).not.toBe(before);
  // The shape uses the values, and the options return with the next page.
  await play.getByTestId('ends-hermite').check();
  await play.getByTestId('give-back').click();
  await expect.poll(async () => (await app.state()).doc.motion.boundary).toBe('hermite');
  await app.by('guide-next').click();
  await expectStep(app, 6);
  await expect(app.page.locator('.framed')).toHaveCount(0);
  await expect(app.by('panel-motion')).toBeVisible();
  await app.expectNoProblems();
});

test('on a projector a step is large and has no buttons, and a clicker turns the pages', { tag: '@all' }, async ({
  app,
}) => {
  await app.page.setViewportSize({ width: 1024, height: 768 });
  await app.open({ hash: '#tour=2' });
  await expectStep(app, 1);
  const sizeOf = (selector: string): Promise<number> =>
    app.page.locator(selector).evaluate((one) => parseFloat(getComputedStyle(one).fontSize));
  const small = await sizeOf('.guide-sentence');
  await app.page.keyboard.press('x');
  await expect(app.by('timeline')).toBeHidden();
  for (const away of ['guide-next', 'guide-close']) await expect(app.by(away)).toBeHidden();
  expect(await sizeOf('.guide-sentence')).toBeGreaterThan(1.2 * small);
  expect(await sizeOf('.guide h2')).toBeGreaterThan(24);
  const [told, shape] = [(await app.by('guide').boundingBox())!, (await app.by('viewport').boundingBox())!];
  expect(told.x + told.width).toBeLessThanOrEqual(shape.x + 1);
  expect(shape.width).toBeGreaterThan(0.55 * 1024);
  expect(await app.page.locator('.guide-scroll').evaluate((one) => one.scrollHeight - one.clientHeight)).toBeLessThan(
    2,
  );
  // The step's own plot comes first, beside its text.
  await app.page.keyboard.press('a');
  expect((await app.state()).view.present).toBe('volume');
  await expect(app.by('plot-volume').locator('svg.plot .curve').first()).toBeVisible();
  await expect(app.page.locator('.guide-sentence')).toBeVisible();
  expect(await app.page.locator('.guide-scroll').evaluate((one) => one.scrollHeight - one.clientHeight)).toBeLessThan(
    2,
  );
  await app.page.keyboard.press('PageDown');
  await expectStep(app, 2);
  expect((await app.state()).view.present).toBe('shape');
  await expect(app.by('timeline')).toBeHidden();
  await app.page.keyboard.press('PageUp');
  await expectStep(app, 1);
  await app.page.keyboard.press('Escape');
  await expect(app.by('timeline')).toBeVisible();
  await expectStep(app, 1);
  await app.page.keyboard.press('Escape');
  await expect(app.by('guide')).toHaveCount(0);
  await app.expectNoProblems();
});

test('on a projector the sixth step has its playground, in large type, and its link keeps the step', async ({
  app,
}) => {
  await app.page.setViewportSize({ width: 1024, height: 768 });
  await app.open({ hash: '#tour=6' });
  await expectStep(app, 5);
  await app.page.keyboard.press('x');
  await expect(app.by('timeline')).toBeHidden();
  const play = app.page.frameLocator('.framed');
  await expect(play.getByTestId('figure-curve')).toBeVisible();
  const { width } = (await app.page.locator('.framed').boundingBox())!;
  expect(width).toBeGreaterThan(0.6 * 1024);
  // The playground's pixels are larger.
  const inside = await play.locator('body').evaluate(({ ownerDocument }) => ownerDocument.defaultView!.innerWidth);
  const type = play.locator('.unit, text, label').first();
  const size = await type.evaluate((one) => parseFloat(getComputedStyle(one).fontSize));
  expect((size * width) / inside).toBeGreaterThan(15.5);
  const words = app.page.locator('.guide-body > p:visible').first();
  expect(await words.evaluate((one) => parseFloat(getComputedStyle(one).fontSize))).toBeGreaterThan(15.5);
  await app.page.keyboard.press('q');
  await expect(app.by('qr-link')).toHaveText(/#tour=6$/);
  await app.by('qr-close').click();
  await app.page.keyboard.press('Escape');
  await expect(app.by('timeline')).toBeVisible();
  await app.page.keyboard.press('q');
  await expect(app.by('qr-link')).toHaveText(/#tour=6$/);
  await app.expectNoProblems();
});

/** The guide covers no part of the shape, and its next button is visible. */
async function expectBesideShape(app: App): Promise<void> {
  const shape = (await app.by('viewport').boundingBox())!;
  const guide = (await app.by('guide').boundingBox())!;
  expect(shape.height).toBeGreaterThan(0.28 * app.page.viewportSize()!.height);
  expect(guide.x + guide.width <= shape.x + 1 || guide.y >= shape.y + shape.height - 1).toBe(true);
  const next = (await app.by('guide-next').boundingBox())!;
  expect(next.y + next.height).toBeLessThanOrEqual(guide.y + guide.height);
}

test('at 360 px, buttons and keys lead from the first step to the last', { tag: '@all' }, async ({ app }) => {
  test.slow();
  const [width, height] = [360, 740];
  await app.page.setViewportSize({ width, height });
  await app.open();
  await app.by('help').click();
  await app.by('help-tour').click();
  for (const [index] of TOUR.slice(0, -2).entries()) {
    await expectStep(app, index);
    if (index === 1) await expectBesideShape(app);
    const [frame, page] = [(await app.by('guide').boundingBox())!, (await app.by('viewport').boundingBox())!];
    expect(page.height, 'the shape is seen').toBeGreaterThan(0.28 * height);
    // The whole text can be read by scrolling.
    const formula = app.by('guide').locator('.formula figcaption');
    await formula.scrollIntoViewIfNeeded();
    const words = (await formula.boundingBox())!;
    expect(words.y + words.height).toBeLessThanOrEqual(frame.y + frame.height + 1);
    expect(words.x + words.width).toBeLessThanOrEqual(width);
    if (index === 3) await app.by('guide-next').focus();
    if (index > 3) await expect(app.by('guide-next')).toBeFocused();
    if (index < 3) await app.by('guide-next').click();
    else if (index < TOUR.length - 3) await app.page.keyboard.press('Enter');
  }
  // Quick key presses go to the end, where there is no next page.
  await app.page.keyboard.press('Enter');
  await app.page.keyboard.press('Enter');
  await expectStep(app, 9);
  await expect(title(app)).toBeFocused();
  await expect(app.by('guide-next')).toBeHidden();
  await app.page.goBack();
  await expectStep(app, 8);
  await app.by('guide-previous').click();
  await expectStep(app, 7);
  await app.expectNoProblems();
});

test('at 1024 px the guide does not cover the shape; after closing it, the first sample is open', async ({ app }) => {
  await app.page.setViewportSize({ width: 1024, height: 768 });
  await app.open({ hash: '#tour=2' });
  await expectStep(app, 1);
  await expectBesideShape(app);
  // A user who opened a link to the tour continues with the first sample, as on any first visit.
  await app.by('guide-close').click();
  await expect.poll(async () => (await app.state()).source).toEqual({ kind: 'sample', id: 'cactus' });
  expect((await app.state()).view.compare).toEqual([]);
});

test('edited files of the user return when the page is reloaded during the tour', {
  tag: '@all',
}, async ({ app }) => {
  await app.open();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.by('boundary-hermite').check();
  await app.settled();
  const { doc } = await app.state();
  await app.page.evaluate(() => (location.hash = '#tour=4'));
  await expectStep(app, 3);
  await app.reload();
  await expectStep(app, 3);
  await app.by('guide-close').click();
  await expect(app.by('guide')).toHaveCount(0);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  expect((await app.state()).doc.motion).toEqual(doc.motion);
  expect((await app.state()).doc.keys.map(({ name }) => name)).toEqual(doc.keys.map(({ name }) => name));
  await app.expectNoProblems();
});

test('opening files during the tour ends it, and they stay open', async ({ app }) => {
  await app.open({ hash: '#tour=1' });
  await expectStep(app, 0);
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.2)]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await expect(app.by('guide')).toHaveCount(0);
  await app.settled();
  expect((await app.state()).doc.keys).toHaveLength(2);
  await expect.poll(() => fragment(app)).not.toContain('tour');
});

test('a link to an unknown step opens the page as usual', async ({ app }) => {
  await app.open({ hash: '#tour=11' });
  await expect(app.by('guide')).toHaveCount(0);
  expect((await app.state()).source).toEqual({ kind: 'sample', id: 'cactus' });
  await app.expectNoProblems();
});
