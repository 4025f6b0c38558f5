/** Every figure of the panels is enlarged, read as numbers and saved in one way. */
import { readFileSync } from 'node:fs';
import type { Download } from '@playwright/test';
import { type App, expect, test } from './support.ts';

test.use({ sharpness: 1 });

async function saved(app: App, testId: string): Promise<{ name: string; bytes: Buffer }> {
  let file: Download | undefined;
  // Twice no download came on a busy machine; why is not known.
  await expect(async () => {
    [file] = await Promise.all([app.page.waitForEvent('download', { timeout: 15_000 }), app.by(testId).click()]);
  }).toPass({ timeout: 60_000 });
  return { name: file!.suggestedFilename(), bytes: readFileSync((await file!.path())!) };
}

/** What is written in it, names under the mouse apart. */
const wordsOf = (svg: string): string[] => [...svg.matchAll(/<text[^>]*>([^<]*)/g)].map(([, words]) => words!);

/** As a program that knows no style sheet and no newer colours opens it: its size, and how many colours it has. */
async function opened(
  app: App,
  svg: string,
): Promise<{ width: number; height: number; colours: number; ground: number[] }> {
  expect(svg).not.toMatch(/class=|var\(|color\(|rgba\(|NaN/);
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

test('every figure has its values to read and is saved as SVG, PNG and CSV', async ({ app }) => {
  test.slow();
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance' });
  await app.by('face-number').fill('3');
  await app.by('face-number').press('Enter');
  await expect(app.by('plot-face-rotation')).toBeVisible();
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(2);
  const always = ['plane', 'volume', 'area', 'bending', 'sliding', 'distance'];
  const patch = ['patch-angles', 'patch-rotation', 'patch-stretch'];
  for (const plot of [...always, 'face-rotation', 'face-stretch', ...patch]) {
    if (plot === patch[0]) {
      await app.by('part-patch').check({ force: true });
      await app.by('patch-number').fill('2');
      await app.by('patch-number').press('Enter');
      await expect(app.by('plot-patch-stretch')).toBeVisible();
    }
    const values = app.by(`${plot}-values`);
    await values.locator('summary').click();
    await expect(values.locator('tbody tr').nth(9), plot).toBeVisible();
    const svg = await saved(app, `${plot}-svg`);
    expect(svg.name).toBe(`shapespline-${plot}.svg`);
    const { width, height, colours } = await opened(app, svg.bytes.toString());
    expect([width, height > 80, colours > 8], plot).toEqual([272, true, true]);
    expect(wordsOf(svg.bytes.toString()), plot).toContain(await app.by(`plot-${plot}`).locator('strong').innerText());
    expect(svg.bytes.toString().match(/<path[^>]+stroke="rgb\(/g)?.length, plot).toBeGreaterThan(0);
    const png = await saved(app, `${plot}-png`);
    expect(png.bytes.readUInt32BE(16), plot).toBe(3 * 272);
    const [head, ...rows] = (await saved(app, `${plot}-csv`)).bytes.toString().trim().split('\n');
    expect(head!.split(',')[0]).toBe('Time');
    expect(rows.length, plot).toBeGreaterThan(12);
    for (const row of rows) expect(row.split(',')).toHaveLength(head!.split(',').length);
    await values.locator('summary').click();
  }
  // The volume at the first key is what percent are of.
  await app.by('volume-values').locator('summary').click();
  const first = (await app.state()).doc.keys[0]!.time;
  const csv = (await saved(app, 'volume-csv')).bytes.toString().trim().split('\n');
  const row = csv.map((line) => line.split(',').map(Number)).find(([t]) => t === first)!;
  expect(row.slice(1)).toEqual([100, 100]);
  await app.expectNoProblems();
});

test('a picture that is saved says what its curves are, on the ground of either theme', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=geodesic,linear' });
  await app.by('plot-bending').scrollIntoViewIfNeeded();
  await expect(app.by('plot-bending').locator('path.curve')).toHaveCount(3);
  for (const colorScheme of ['light', 'dark'] as const) {
    await app.page.emulateMedia({ colorScheme });
    for (const plot of ['plane', 'volume', 'bending']) {
      const values = app.by(`${plot}-values`);
      if (!(await app.by(`${plot}-svg`).isVisible())) await values.locator('summary').click();
      const svg = (await saved(app, `${plot}-svg`)).bytes.toString();
      const words = wordsOf(svg);
      for (const word of ['Shape spline (LRI)', 'Geodesic (LRI)', 'Morph targets (linear)'])
        expect(
          words.filter((one) => one === word),
          `${plot}: ${word}`,
        ).toHaveLength(1);
      const { ground } = await opened(app, svg);
      if (colorScheme === 'light') expect(Math.min(...ground), plot).toBeGreaterThan(200);
      else expect(Math.max(...ground), plot).toBeLessThan(60);
    }
  }
});

test('bending is drawn in powers of ten where the peaks of one method would leave the others flat', async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  const bending = app.by('plot-bending');
  await bending.scrollIntoViewIfNeeded();
  await expect(bending.locator('path.curve')).toHaveCount(1);
  await expect(bending.locator('.unit')).not.toContainText('logarithmic');
  await app.by('compare-geodesic').check();
  await bending.scrollIntoViewIfNeeded();
  await expect(bending.locator('path.curve')).toHaveCount(2);
  await expect(bending.locator('.unit')).toContainText('logarithmic');
  const labels = await bending.locator('.tick-y').allTextContents();
  expect(labels[0]).toMatch(/^≤ /);
  const powers = labels.map((label) => Math.log10(Number(label.replace('≤ ', ''))));
  for (const power of powers) expect(power).toBeCloseTo(Math.round(power), 9);
  // Both can be read: the spline rises above the edge, and the geodesic's peak far above it.
  const tops = await bending
    .locator('path.curve')
    .evaluateAll((curves) => curves.map((curve) => (curve as SVGPathElement).getBBox().height));
  expect(tops[0]).toBeGreaterThan(20);
  expect(tops[1]).toBeGreaterThan(tops[0]! + 15);
  // What is saved are the numbers, and the picture says how to read it.
  await app.by('bending-values').locator('summary').click();
  const csv = (await saved(app, 'bending-csv')).bytes.toString().trim().split('\n');
  const peak = Math.max(...csv.slice(1).map((row) => Number(row.split(',')[2])));
  expect(peak).toBeGreaterThan(1000);
  expect(wordsOf((await saved(app, 'bending-svg')).bytes.toString()).join(' ')).toContain('logarithmic');
});

test('the charts of ghost sizes are saved like the others', async ({ app }) => {
  test.slow();
  await app.open({ hash: '#figure=8' });
  await expect(app.by('study-verdict')).toBeVisible({ timeout: 120_000 });
  for (const plot of ['ghost-error', 'ghost-time']) {
    await app.by(`${plot}-values`).locator('summary').click();
    await expect(app.by(`${plot}-values`).locator('tbody tr').first()).toBeVisible();
    const svg = (await saved(app, `${plot}-svg`)).bytes.toString();
    expect((await opened(app, svg)).width).toBe(272);
    const names = await app.by('study').locator('.legend').first().locator('span').allInnerTexts();
    for (const name of names) expect(wordsOf(svg)).toContain(name);
    expect((await saved(app, `${plot}-png`)).bytes.readUInt32BE(16)).toBe(3 * 272);
    const [head, ...rows] = (await saved(app, `${plot}-csv`)).bytes.toString().trim().split('\n');
    expect(head).toContain('"Faces, empty without a ghost mesh"');
    expect(rows.length).toBeGreaterThan(4);
    expect(rows.at(-1)).toMatch(/^,[\d.]+,[\d.]+$/);
    await app.by(`enlarge-${plot}`).click();
    await expect(app.page.locator('.figure:visible')).toHaveCount(1);
    expect((await app.by(`plot-${plot}`).boundingBox())!.width).toBeGreaterThan(0.55 * app.page.viewportSize()!.width);
    await app.page.keyboard.press('Escape');
    await expect(app.by('timeline')).toBeVisible();
  }
  await app.expectNoProblems();
});

test('a chart of a face fills the screen like the others, but no link says so', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await app.by('face-number').fill('3');
  await app.by('face-number').press('Enter');
  await app.by('plot-face-stretch').scrollIntoViewIfNeeded();
  await app.by('enlarge-face-stretch').click();
  await expect(app.by('timeline')).toBeHidden();
  await expect(app.page.locator('.figure:visible')).toHaveCount(1);
  for (const away of ['heat-none', 'face-number', 'face-stretch-values', 'plot-face-rotation'])
    await expect(app.by(away)).toBeHidden();
  const { width } = (await app.by('plot-face-stretch').boundingBox())!;
  expect(width).toBeGreaterThan(0.55 * app.page.viewportSize()!.width);
  expect(await app.page.evaluate(() => location.hash)).not.toContain('present=');
  await app.page.keyboard.press('Escape');
  await expect(app.by('heat-none')).toBeAttached();
  await expect(app.by('plot-face-rotation')).toBeVisible();
  await app.expectNoProblems();
});

test('every figure fills the screen by key, in type that is read from afar, and gives the focus back', async ({
  app,
}) => {
  test.slow();
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance&t=0.2' });
  for (const [part, field] of [
    ['face', '3'],
    ['patch', '2'],
  ] as const) {
    await app.by(`part-${part}`).check({ force: true });
    await app.by(`${part}-number`).fill(field);
    await app.by(`${part}-number`).press('Enter');
    const own =
      part === 'face' ? ['face-rotation', 'face-stretch'] : ['patch-angles', 'patch-rotation', 'patch-stretch'];
    const shared = part === 'face' ? ['plane', 'volume', 'area', 'bending', 'sliding', 'distance'] : [];
    for (const plot of [...shared, ...own]) {
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
  }
  await app.expectNoProblems();
});
