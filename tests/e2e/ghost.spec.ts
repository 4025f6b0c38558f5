/**
 * The ghost mesh: options, display, difference from the full solve, and the comparison of its sizes.
 */
import { readFileSync } from 'node:fs';
import { changedShare, matching } from './png.ts';
import type { Colour } from './png.ts';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const HUES = {
  accent: ([r, g, b]: Colour) => b > 150 && b - g > 60 && b - r > 60,
  purple: ([r, g, b]: Colour) => r > g + 12 && b > g + 25 && g < 110,
  green: ([r, g, b]: Colour) => g > r + 40 && g > b + 10,
};

/** Pixels of a hue. */
async function pixels(app: App, hue: keyof typeof HUES): Promise<{ count: number; share: number }> {
  return matching(await app.picture(), HUES[hue]);
}

/** Distances of the first two views' vertices in percent of the diagonal over all keys, from the engine. */
async function apart(app: App): Promise<{ percent: number[]; shown: number[] }> {
  return app.page.evaluate(() => {
    const hook = window.__shapespline!;
    const [a, b] = [hook.positions(0), hook.positions(1)];
    const percent = Array.from({ length: a.length / 3 }, (_, v) =>
      Math.hypot(a[3 * v]! - b[3 * v]!, a[3 * v + 1]! - b[3 * v + 1]!, a[3 * v + 2]! - b[3 * v + 2]!),
    );
    return { percent, shown: Array.from(hook.difference() ?? []) };
  });
}

test('a ghost mesh drives the shape when it is switched on, through the same keys', async ({ app }) => {
  await app.open();
  const full = [await app.positionsAt(1), await app.positionsAt(0.2)] as const;
  expect((await app.stats()).ghostFaces).toBe(0);
  await expect(app.by('ghost-faces')).toBeHidden();
  await app.by('ghost').check();
  await app.settled();
  const stats = await app.stats();
  expect(stats.ghostFaces).toBeGreaterThan(1900);
  expect(stats.ghostFaces).toBeLessThanOrEqual(2000);
  await expect(app.by('ghost-used')).toHaveText(new RegExp(`^${stats.ghostFaces.toLocaleString('en')} of `));
  const size = diagonal(full[0]);
  expect(difference(await app.positionsAt(1), full[0])).toBeLessThan(1e-5 * size);
  const led = difference(await app.positionsAt(0.2), full[1]);
  expect(led).toBeGreaterThan(1e-7 * size);
  expect(led).toBeLessThan(1e-2 * size);
  await app.page.keyboard.press('n');
  await app.settled();
  expect((await app.stats()).ghostFaces).toBe(0);
  expect(await app.positionsAt(0.2)).toEqual(full[1]);
  await app.expectNoProblems();
});

test('size, transfer and placement change the ghost and are in the link; vertex blends have no ghost', async ({
  app,
}) => {
  await app.open({ hash: '#sample=cactus&ghostFaces=300' });
  await app.by('ghost-faces').fill('700');
  await app.by('ghost-faces').press('Enter');
  await app.settled();
  const exact = await app.positionsAt(1);
  await app.by('transfer-paper').check();
  await app.settled();
  const paper = await app.positionsAt(1);
  expect(difference(paper, exact)).toBeGreaterThan(1e-4 * diagonal(exact));
  await app.by('placement').check();
  await app.settled();
  expect(difference(await app.positionsAt(1), paper)).toBeGreaterThan(1e-5 * diagonal(exact));
  await expect.poll(() => app.page.evaluate(() => location.hash)).toContain('placement=optimal');
  expect(await app.page.evaluate(() => location.hash)).toContain('ghostFaces=700');
  await app.by('method').selectOption('linear');
  await app.settled();
  await expect(app.by('ghost-hint')).toContainText('uses no ghost mesh');
  await expect(app.by('ghost-wire')).toBeDisabled();
  await app.expectNoProblems();
});

test('its wireframe is drawn over the shape, or it is next to the shape with lines to corresponding vertices', {
  tag: '@all',
}, async ({ app }) => {
  await app.open();
  await app.setTime(0.2);
  await app.by('ghost').check();
  const before = await app.picture();
  await app.by('ghost-wire').check();
  const wire = await app.picture();
  expect(changedShare(before, wire)).toBeGreaterThan(0.01);
  await app.by('ghost-wire').uncheck();
  expect(changedShare(before, await app.picture())).toBeLessThan(0.001);
  const none = await pixels(app, 'accent');
  await app.by('ghost-beside').check();
  const lines = await pixels(app, 'accent');
  expect(none.count).toBeLessThan(20);
  expect(lines.count).toBeGreaterThan(300);
  const ghost = await app.page.evaluate(async () => {
    const { positions, vertexOf, faces } = (await window.__shapespline!.ghost())!;
    return { positions: Array.from(positions), vertexOf: Array.from(vertexOf), faces: faces.length / 3 };
  });
  expect(ghost.faces).toBe((await app.stats()).ghostFaces);
  const drawn = await app.positions();
  const at = ghost.vertexOf.flatMap((v) => drawn.slice(3 * v, 3 * v + 3));
  expect(difference(ghost.positions, at)).toBeLessThan(0.02 * diagonal(drawn));
  await app.by('ghost-beside').uncheck();
  expect((await pixels(app, 'accent')).count).toBe(none.count);
  await app.expectNoProblems();
});

test('the difference from the motion without a ghost is shown in colours, with its range', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  await app.by('ghost').check();
  await app.by('ghost-faces').fill('300');
  await app.by('ghost-faces').press('Enter');
  await app.by('transfer-paper').check();
  await app.settled();
  await app.by('ghost-difference').check();
  await app.setTime(0.7);
  await app.settled();
  await expect(app.by('tile-0')).toContainText('ghost mesh');
  await expect(app.by('tile-1')).not.toContainText('ghost mesh');
  const { percent, shown } = await apart(app);
  const [largest, most] = [Math.max(...percent), Math.max(...shown)];
  expect(most).toBeGreaterThan(0.05);
  expect(most).toBeLessThan(20);
  // The page shows the same numbers, in percent of one diagonal.
  const factor = most / largest;
  expect(shown.filter((value, v) => Math.abs(value - factor * percent[v]!) > 1e-3 * most)).toEqual([]);
  const top = parseFloat((await app.by('colour-bar').locator('.ramp-ticks span').first().textContent())!);
  expect(top).toBeGreaterThanOrEqual(most);
  expect(top).toBeLessThan(10 * most);
  await expect(app.by('colour-bar')).toContainText('% of the model’s size');
  expect((await pixels(app, 'purple')).count).toBeGreaterThan(1000);
  await app.by('transfer-exact').check();
  await app.setTime(0);
  await app.settled();
  expect(Math.max(...(await apart(app)).shown)).toBeLessThan(1e-3);
  await app.by('ghost-difference').uncheck();
  await app.settled();
  await expect(app.by('colour-bar')).toBeHidden();
  expect((await pixels(app, 'purple')).count).toBeLessThan(100);
  await app.expectNoProblems();
});

test('sizes are compared on request, with a sentence that states the numbers; the slider still works', {
  tag: '@all',
}, async ({ app }) => {
  test.slow();
  await app.open();
  await app.by('study-start').click();
  await expect(app.by('study-working')).toBeVisible();
  await app.setTime(0.33);
  expect((await app.state()).time).toBe(0.33);
  await expect(app.by('study-verdict')).toBeVisible({ timeout: 120_000 });
  const number = async (id: string): Promise<number> => parseFloat((await app.by(id).textContent())!);
  const verdict = (await app.by('study-verdict').textContent())!;
  const none = await number('study-none-exact-ms');
  const best: number[] = [];
  for (const size of [500, 1000, 2000, 3000, 5000, 10000]) {
    const [exact, paper] = [await number(`study-${size}-exact-kg`), await number(`study-${size}-paper-kg`)];
    if (size >= 2000) expect(exact).toBeLessThanOrEqual(1);
    if (size >= 2000) expect(paper).toBeLessThanOrEqual(5);
    expect(exact).toBeLessThanOrEqual(paper);
    best.push(await number(`study-${size}-exact-ms`), await number(`study-${size}-paper-ms`));
  }
  expect(verdict).toContain(`${none} ms`);
  expect(verdict).toContain(`${Math.min(...best)} ms`);
  await expect(app.by('study').locator('svg.ghost-chart')).toHaveCount(2);
  for (const plot of ['ghost-error', 'ghost-time']) await expect(app.by(`enlarge-${plot}`)).toBeVisible();
  await app.by('ghost-error-values').locator('summary').press('Enter');
  const [table] = await Promise.all([app.page.waitForEvent('download'), app.by('ghost-error-csv').press('Enter')]);
  const [head, ...rows] = readFileSync(await table.path(), 'utf8')
    .trim()
    .split('\n');
  expect(head).toContain('Faces (empty: no ghost mesh)');
  expect(rows.at(-1)).toMatch(/^,[\d.]+,[\d.]+$/);
  // Measurements belong to one motion; a different motion removes them.
  await app.by('stretch-log').check();
  await app.settled();
  await expect(app.by('study')).toBeHidden();
  await app.expectNoProblems();
});
