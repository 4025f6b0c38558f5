/** Shapes off the curve in the shape plane: a dragged point, a drawn path, and curves to compare with. */
import { type App, diagonal, difference, expect, test } from './support.ts';

const weights = async (app: App): Promise<number[]> => {
  const cells = await app.by('blend-weights').locator('.number-cell').allInnerTexts();
  return cells.map((text) => Number.parseFloat(text.replace('\u2212', '-')) / 100);
};

/** The point's position on the page. */
async function pointAt(app: App): Promise<{ x: number; y: number }> {
  const box = (await app.by('plane-point').locator('.now').boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

async function openPlane(app: App, hash = '#sample=cactus'): Promise<void> {
  await app.open({ hash });
  await app.setTime(0.25);
  await app.by('plot-plane').scrollIntoViewIfNeeded();
  await app.analysed();
}

async function drag(app: App, dx: number, dy: number): Promise<void> {
  const { x, y } = await pointAt(app);
  await app.page.mouse.move(x, y);
  await app.page.mouse.down();
  await app.page.mouse.move(x + dx, y + dy, { steps: 3 });
  await app.page.mouse.up();
  await app.settled();
}

test('the point is dragged off the curve: another shape with its weights, and Escape restores the motion', async ({
  app,
}) => {
  await openPlane(app);
  const motion = await app.positions();
  await drag(app, 10, -50);
  const off = await app.positions();
  expect(difference(off, motion)).toBeGreaterThan(0.01 * diagonal(motion));
  const shown = await weights(app);
  expect(shown).toHaveLength(3);
  expect(shown.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 2);
  await expect(app.by('phase')).toHaveText('Off the curve: a mixture of the keys');

  await app.page.keyboard.press('Escape');
  await app.settled();
  expect(await app.positions()).toEqual(motion);
  await expect(app.by('blend-weights')).toBeHidden();
  await expect(app.by('phase')).toHaveText('Between keys 1 and 2');
  await app.expectNoProblems();
});

test('dropped on a key, the point gives that key; changing the time restores the motion', async ({ app }) => {
  await openPlane(app);
  const [key, shape] = [await app.positionsAt(1), await app.positionsAt(0.25)];
  const [from, to] = [await pointAt(app), (await app.by('plot-plane').locator('circle.key').last().boundingBox())!];
  await drag(app, to.x + to.width / 2 - from.x + 3, to.y + to.height / 2 - from.y - 2);
  expect(await weights(app)).toEqual([0, 0, 1]);
  expect(difference(await app.positions(), key)).toBeLessThan(1e-5 * diagonal(key));
  await app.setTime(0.25);
  await expect(app.by('blend-weights')).toBeHidden();
  expect(await app.positions()).toEqual(shape);
});

test('arrow keys move the point without moving the time', async ({ app }) => {
  await openPlane(app);
  const motion = await app.positions();
  await app.by('plane-point').press('Shift+ArrowUp');
  await app.settled();
  expect(difference(await app.positions(), motion)).toBeGreaterThan(0.01 * diagonal(motion));
  expect((await app.state()).time).toBe(0.25);
  await expect(app.by('plot-plane').getByRole('status')).toContainText('Off the curve: key 1');
  await app.by('plane-back').click();
  await app.settled();
  expect(await app.positions()).toEqual(motion);
});

test('a drawn path plays', { tag: '@all' }, async ({ app }) => {
  await openPlane(app);
  const motion = await app.positions();
  await app.by('plane-draw').click();
  const plane = (await app.by('plot-plane').locator('svg.plot').boundingBox())!;
  const at = (x: number, y: number): [number, number] => [plane.x + plane.width * x, plane.y + plane.height * y];
  await app.page.mouse.move(...at(0.3, 0.4));
  await app.page.mouse.down();
  await app.page.mouse.move(...at(0.5, 0.2), { steps: 5 });
  await app.page.mouse.move(...at(0.7, 0.5), { steps: 5 });
  await app.page.mouse.up();
  await app.settled();
  // with reduced motion, the path waits at its start
  const start = await weights(app);
  await app.by('plane-play').click();
  await expect(app.by('plane-play')).toHaveText('Stop');
  await expect(app.by('plane-play')).toHaveText('Play path', { timeout: 10_000 });
  await app.settled();
  const end = await weights(app);
  expect(end[2]! - start[2]!).toBeGreaterThan(0.1);
  expect((await app.state()).time).toBe(0.25);
  await app.page.keyboard.press('Escape');
  await app.settled();
  expect(await app.positions()).toEqual(motion);
  await app.expectNoProblems();
});

test('vertex blends are drawn with their distance from the plane, and the sampled minimum with its distance from the spline', async ({
  app,
}) => {
  await openPlane(app, '#sample=cactus&compare=linear');
  await expect(app.by('plot-plane').locator('path.curve.linear')).toBeVisible();
  const text = await app.by('plane-notes').innerText();
  expect(Number(/up to ([\d.]+)\s%/.exec(text)![1])).toBeGreaterThan(1);
  await app.by('minimised').check();
  const samples = app.by('plot-plane').locator('circle.sample');
  await app.by('minimised-samples').fill('7');
  await app.by('minimised-samples').press('Enter');
  await expect(samples).toHaveCount(7);
  await expect(app.by('minimised-samples')).toHaveValue('7');
  await expect(app.by('plane-notes')).toContainText(/at most [\d.]+\s%/);
  await app.by('minimised').uncheck();
  await expect(samples).toHaveCount(0);
});
