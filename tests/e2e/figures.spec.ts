/** Every figure of the panels can be enlarged, read as numbers and saved. */
import { readFileSync } from 'node:fs';
import { exported, type as typeInto } from './exporting.ts';
import { type App, expect, test } from './support.ts';

test.use({ sharpness: 1 });

/** Shows the charts of a face or a patch. */
async function choosePart(app: App, part: string, number: string): Promise<void> {
  await app.by(`part-${part}`).check({ force: true });
  await app.by(`${part}-number`).fill(number);
  await app.by(`${part}-number`).press('Enter');
}

/** The button is pressed by key, because charts being drawn may move it away from the mouse. */
async function saved(app: App, testId: string): Promise<{ name: string; bytes: Buffer }> {
  const [file] = await Promise.all([app.page.waitForEvent('download'), app.by(testId).press('Enter')]);
  return { name: file.suggestedFilename(), bytes: readFileSync((await file.path())!) };
}

/** The plot's text, except tooltips. */
const wordsOf = (svg: string): string[] => [...svg.matchAll(/<text[^>]*>([^<]*)/g)].map(([, words]) => words!);

/** The plot in a program without style sheets and newer colour notations: its size and number of colours. */
async function opened(
  app: App,
  svg: string,
): Promise<{ width: number; height: number; colours: number; ground: number[] }> {
  expect(svg).not.toMatch(/class=|style=|var\(|color\(|rgba\(|system-ui|NaN/);
  expect(wordsOf(svg).join(' '), 'one notation of numbers').not.toMatch(/\d[eE][+\d-]|-\d/);
  return app.page.evaluate(async (source) => {
    const parsed = new DOMParser().parseFromString(source, 'image/svg+xml');
    if (parsed.querySelector('parsererror')) throw new Error('not well formed');
    const image = new Image();
    image.src = `data:image/svg+xml,${encodeURIComponent(source)}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    const context = canvas.getContext('2d')!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set<number>();
    for (let i = 0; i < data.length; i += 4) colours.add((data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!);
    return { width: canvas.width, height: canvas.height, colours: colours.size, ground: [...data.slice(0, 3)] };
  }, svg);
}

/** All text lies inside the plot, and both axes have titles. */
async function expectWhole(app: App, svg: string, plot: string): Promise<void> {
  const outside = await app.page.evaluate((source) => {
    const holder = document.body.appendChild(document.createElement('div'));
    holder.innerHTML = source;
    const picture = holder.querySelector('svg')!;
    const { left, right, top, bottom } = picture.getBoundingClientRect();
    const out = [...picture.querySelectorAll('text')].filter((one) => {
      const box = one.getBoundingClientRect();
      return box.left < left - 1 || box.right > right + 1 || box.top < top - 1 || box.bottom > bottom + 1;
    });
    const words = out.map(({ textContent }) => textContent);
    holder.remove();
    return words;
  }, svg);
  expect(outside, `${plot}: cut off`).toEqual([]);
  const words = wordsOf(svg).join('; ');
  expect(words, plot).toMatch(/Time \(s\)|First component|Faces of the ghost mesh/);
  expect(svg, plot).toMatch(/rotate\(-90\)"[^>]*>[A-Z]/);
}

/** Reads a chart, and saves it as SVG. */
async function readAndSave(app: App, plot: string): Promise<void> {
  await expect(app.by(`plot-${plot}`)).toBeVisible();
  const values = app.by(`${plot}-values`);
  await values.locator('summary').press('Enter');
  await expect(values.locator('tbody tr').nth(9), plot).toBeVisible();
  const svg = await saved(app, `${plot}-svg`);
  expect(svg.name).toBe(`shapespline-${plot}.svg`);
  const { width, height, colours } = await opened(app, svg.bytes.toString());
  // 85 mm in browser pixels.
  expect([width, height > 80, colours > 8], plot).toEqual([321, true, true]);
  expect(svg.bytes.toString(), plot).toMatch(/^<svg[^>]* width="85mm"/);
  await expectWhole(app, svg.bytes.toString(), plot);
  expect(wordsOf(svg.bytes.toString()), plot).toContain(await app.by(`plot-${plot}`).locator('strong').innerText());
  expect(svg.bytes.toString().match(/<path[^>]+stroke="rgb\(/g)?.length, plot).toBeGreaterThan(0);
}

test('values are read and saved as SVG, PNG and CSV: of the motion, a face and a patch', { tag: '@all' }, async ({
  app,
}) => {
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance' });
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(2);
  for (const plot of ['plane', 'distance']) await readAndSave(app, plot);
  for (const [part, plot] of [
    ['face', 'face-rotation'],
    ['patch', 'patch-rotation'],
  ] as const) {
    await choosePart(app, part, '3');
    await readAndSave(app, plot);
  }
  for (const last of ['distance', 'patch-rotation']) {
    const png = await saved(app, `${last}-png`);
    // 600 dots per inch.
    expect(png.bytes.readUInt32BE(16)).toBe(2008);
    const [head, ...rows] = (await saved(app, `${last}-csv`)).bytes.toString().trim().split('\n');
    expect(head!.split(',')[0]).toBe('Time');
    expect(rows.length).toBeGreaterThan(12);
    for (const row of rows) expect(row.split(',')).toHaveLength(head!.split(',').length);
  }
  await app.expectNoProblems();
});

// Only the page connects the choice, the motions, their worker, the plot, its files and the exported table.
test('bending is measured by edge lengths and angles on request, again after an edit, and not after Cancel', async ({
  app,
}) => {
  await app.open({ hash: '#sample=cactus&compare=geodesic' });
  const plot = app.by('plot-bending');
  const unit = plot.locator('.unit');
  await plot.scrollIntoViewIfNeeded();
  // Until then, the choice of the closed shape is hidden.
  await app.analysed();
  await expect(plot.locator('path.curve')).toHaveCount(2);
  await expect(app.by('bending-working'), 'shown during the analysis').toContainText('Measuring the motion');
  await expect(unit).not.toContainText('edge lengths');
  await app.by('bending-shell').press(' ');
  await app.nextFrame();
  await app.by('bending-cancel').press('Enter');
  await expect(app.by('bending-shell')).not.toBeChecked();
  await expect(app.by('bending-working')).toBeHidden();
  await expect(unit).not.toContainText('edge lengths');

  await app.by('bending-shell').press(' ');
  await expect(unit).toContainText('of edge lengths and angles', { timeout: 60_000 });
  await expect(plot).not.toHaveAttribute('data-stale');
  await app.by('bending-values').locator('summary').press('Enter');
  const [head] = (await saved(app, 'bending-csv')).bytes.toString().split('\n');
  expect(head).toContain('"Geodesic (LRI), by edge lengths and angles"');
  const svg = (await saved(app, 'bending-svg')).bytes.toString();
  expect(svg.match(/<path[^>]+stroke="rgb\(/g)).toHaveLength(2);
  expect(wordsOf(svg).join(' ')).toContain('of edge lengths and angles');
  const table = await exported(app, async () => {
    await app.by('export-kind-numbers').check();
    await typeInto(app, 'export-frames', '4');
  });
  const rows = table.bytes.toString().trim().split('\n').slice(-5);
  for (const method of ['lri', 'geodesic']) {
    const column = rows[0]!.split(',').indexOf(`${method} bending by edge lengths and angles`);
    for (const row of rows.slice(1)) expect(parseFloat(row.split(',')[column]!), method).toBeGreaterThanOrEqual(0);
  }

  const drawn = (): Promise<string | null> => plot.locator('path.curve').first().getAttribute('d');
  const before = await drawn();
  await app.by('boundary-periodic').press(' ');
  await plot.scrollIntoViewIfNeeded();
  await expect.poll(drawn, { timeout: 60_000 }).not.toBe(before);
  await expect(unit).toContainText('of edge lengths and angles');
  await app.by('bending-shell').press(' ');
  await expect(unit).not.toContainText('edge lengths');
  await app.expectNoProblems();
});

test('no plot of the previous shape is shown with the next shape', async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(1);
  await choosePart(app, 'face', '3');
  const plots = ['plane', 'bending', 'face-rotation'];
  for (const plot of plots) await expect(app.by(`plot-${plot}`).locator('.curve').first()).toBeVisible();
  /** Plots that still show the earlier shape at any time before all are redrawn. */
  const late = await app.page.evaluate(async (names) => {
    const figureOf = (name: string): Element => document.querySelector(`[data-testid="plot-${name}"]`)!;
    const drawnIn = (name: string): string =>
      [...figureOf(name).querySelectorAll('.curve, .tick-y')]
        .map((one) => one.getAttribute('d') ?? one.textContent)
        .join();
    const before = new Map(names.map((name) => [name, drawnIn(name)]));
    const seen = new Set<string>();
    location.hash = '#sample=column';
    for (let left = names; left.length > 0; await new Promise(requestAnimationFrame)) {
      left = left.filter((name) => drawnIn(name) === before.get(name));
      const { source } = window.__shapespline!.state;
      if (source.kind !== 'sample' || source.id !== 'column') continue;
      for (const name of left)
        if (figureOf(name).querySelector('svg.plot')!.checkVisibility({ visibilityProperty: true })) seen.add(name);
    }
    return [...seen];
  }, plots);
  expect(late).toEqual([]);
  for (const plot of plots) await expect(app.by(`plot-${plot}`).locator('.curve').first()).toBeVisible();
  await app.expectNoProblems();
});

test('a saved image has a legend and the background of the theme', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=geodesic,linear' });
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(3);
  for (const plot of ['plane', 'bending']) {
    await app.page.emulateMedia({ colorScheme: 'light' });
    await app.by(`${plot}-values`).locator('summary').press('Enter');
    const svg = (await saved(app, `${plot}-svg`)).bytes.toString();
    const words = wordsOf(svg);
    for (const word of ['Shape spline (LRI)', 'Geodesic (LRI)', 'Morph targets (linear)'])
      expect(
        words.filter((one) => one === word),
        `${plot}: ${word}`,
      ).toHaveLength(1);
    // On a linear axis, the geodesic's peaks would flatten the other curves.
    if (plot === 'bending') expect(words.join(' ')).toMatch(/logarithmic.* 10[⁰¹²³⁴⁵⁶⁷⁸⁹]/);
    expect(Math.min(...(await opened(app, svg)).ground), plot).toBeGreaterThan(200);
    // The file does not depend on the current time.
    const { time } = await app.state();
    await app.setTime(0.3);
    expect((await saved(app, `${plot}-svg`)).bytes.toString(), plot).toBe(svg);
    await app.setTime(time);
    await app.page.emulateMedia({ colorScheme: 'dark' });
    const dark = (await saved(app, `${plot}-svg`)).bytes.toString();
    expect(Math.max(...(await opened(app, dark)).ground), plot).toBeLessThan(60);
  }
});

test('a figure fills the screen on a key press, in large type, and then restores the focus', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance&t=0.2' });
  await choosePart(app, 'face', '3');
  for (const plot of ['plane', 'face-stretch']) {
    const figure = app.by(`plot-${plot}`);
    await figure.scrollIntoViewIfNeeded();
    await expect(figure.locator('svg.plot .curve').first(), plot).toBeVisible();
    await app.by(`enlarge-${plot}`).press('Enter');
    await expect(app.by('timeline')).toBeHidden();
    await expect(app.page.locator('.figure:visible')).toHaveCount(1);
    const [box, page] = [(await figure.boundingBox())!, app.page.viewportSize()!];
    expect(box.width, plot).toBeGreaterThan(0.55 * page.width);
    expect(box.y, plot).toBeGreaterThanOrEqual(0);
    expect(box.y + box.height, plot).toBeLessThanOrEqual(page.height);
    const least = await figure.locator('figcaption, .legend, svg.plot text').evaluateAll((all) =>
      Math.min(
        ...all
          .filter((one) => one.checkVisibility() && one.textContent !== '')
          .map((one) => {
            const scale = one instanceof SVGGraphicsElement ? one.getScreenCTM()!.a : 1;
            return scale * parseFloat(getComputedStyle(one).fontSize);
          }),
      ),
    );
    expect(least, `${plot}: the smallest type`).toBeGreaterThan(15);
    await app.page.keyboard.press('Escape');
    await expect(app.by(`enlarge-${plot}`)).toBeFocused();
  }
  await app.expectNoProblems();
});

// Only the built page joins samples, engine and chart.
test('Fig. 8 compares four shapes: the error of each falls as its ghost mesh grows', { tag: '@all' }, async ({
  app,
}) => {
  test.slow();
  await app.open({ hash: '#figure=8' });
  await expect(app.by('study-working')).toContainText(/(Octopus|Hand|Dachshund|Cactus) \(\d of 4\): /);
  await expect(app.by('plot-ghost-time')).toBeVisible({ timeout: 170_000 });
  await expect(app.by('plot-ghost-error').locator('path.curve')).toHaveCount(4);
  await app.by('ghost-error-values').locator('summary').press('Enter');
  const table = (await saved(app, 'ghost-error-csv')).bytes.toString().trim().split('\n');
  const [head, ...rows] = table.map((line) => line.split(','));
  expect(head).toEqual(['Faces of the ghost mesh', 'Octopus', 'Hand', 'Dachshund', 'Cactus']);
  expect(rows.map(([faces]) => faces)).toEqual(['500', '1000', '2000', '3000', '5000', '10000']);
  for (const [column, name] of head!.entries()) {
    if (column === 0) continue;
    const errors = rows.map((row) => row[column]!).filter((cell) => cell !== '');
    expect(errors.length, name).toBeGreaterThanOrEqual(5);
    for (const [i, error] of errors.slice(1).entries()) expect(Number(error), name).toBeLessThan(Number(errors[i]));
    expect(Number(errors.at(-1)), name).toBeGreaterThan(0);
  }
  const svg = (await saved(app, 'ghost-error-svg')).bytes.toString();
  await opened(app, svg);
  await expectWhole(app, svg, 'ghost-error');
  expect(wordsOf(svg)).toEqual(expect.arrayContaining(head!.slice(1)));
  await app.expectNoProblems();
});
