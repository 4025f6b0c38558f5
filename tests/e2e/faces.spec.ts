/** Heat maps on the surface, and the coordinates of a face that is clicked. */
import { decode } from './png.ts';
import { type App, expect, test } from './support.ts';

/** Of the shape's middle on the screen: mean red, green and blue. */
async function middleColour(app: App): Promise<[number, number, number]> {
  const { data, width, height } = decode(await app.picture());
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (let y = Math.round(height * 0.4); y < height * 0.6; y += 1)
    for (let x = Math.round(width * 0.48); x < width * 0.52; x += 1, count += 1)
      for (let c = 0; c < 3; c += 1) sum[c]! += data[4 * (y * width + x) + c]!;
  return sum.map((value) => value / count) as [number, number, number];
}

/** The largest amount now, or the mean. */
const now = async (app: App, which: 'at most' | 'mean' = 'at most'): Promise<number> => {
  const text = await app.by('colour-bar-now').innerText();
  return Number(new RegExp(`${which} ([\\d.]+)`).exec(text)![1]);
};

test('the heat map of rotation follows the time, and its colours the numbers', async ({ app }) => {
  await app.open({ hash: '#sample=twisted-bar&colour=rotation' });
  const bar = app.by('colour-bar');
  await app.setTime((await app.state()).doc.keys.at(-1)!.time);
  await app.settled();
  await expect(bar).toContainText('Rotation');
  expect(await now(app)).toBeGreaterThan(60);
  const turned = await middleColour(app);
  await app.setTime((await app.state()).doc.keys[0]!.time);
  await app.settled();
  expect(await now(app)).toBeLessThan(1);
  const still = await middleColour(app);
  // viridis: none of it is violet, more of it is green and yellow
  expect(still[2]).toBeGreaterThan(still[1]);
  expect(turned[1]).toBeGreaterThan(still[1] + 20);
  await app.by('heat-none').check({ force: true });
  await app.settled();
  await expect(bar).toBeHidden();
  await app.expectNoProblems();
});

test('stretch is coloured on every motion that is shown: the blend stretches, ours hardly', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear' });
  await app.by('heat-stretch').check({ force: true });
  await app.setTime(0.25);
  await app.settled();
  await expect(app.by('colour-bar')).toContainText('Stretch');
  expect((await app.state()).view.colouring).toBe('stretch');
  const ours = await now(app, 'mean');
  await app.open({ hash: '#sample=cactus&method=linear&colour=stretch' });
  await app.setTime(0.25);
  await app.settled();
  expect(await now(app, 'mean')).toBeGreaterThan(1.5 * ours);
});

test('a face that is clicked shows its coordinates over time, with dots at the keys', async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  await app.by('faces').scrollIntoViewIfNeeded();
  await app.setTime(0.25);
  const [x, y] = await app.page.evaluate(() => {
    const all = window.__shapespline!.positions();
    const places = window.__shapespline!.project(all);
    // the middle of what is seen
    let [sx, sy] = [0, 0];
    for (let i = 0; i < places.length; i += 2) [sx, sy] = [sx + places[i]!, sy + places[i + 1]!];
    return [(2 * sx) / places.length, (2 * sy) / places.length] as const;
  });
  const box = (await app.by('viewport').boundingBox())!;
  await app.page.mouse.click(box.x + x, box.y + y);
  await expect(app.by('plot-face-rotation')).toBeVisible();
  await expect(app.by('face-patch')).toHaveText(/^of patch \d+$/);
  await expect(app.by('plot-face-rotation').locator('circle.dot')).toHaveCount(9);
  const first = await app.by('face-number').inputValue();
  await app.by('face-number').fill('3');
  await app.by('face-number').press('Enter');
  await expect(app.by('face-number')).not.toHaveValue(first);
  await expect(app.by('plot-face-stretch').locator('path.curve')).toHaveCount(3);
  // Beside other ends than natural ones, the natural spline is drawn, too.
  await app.by('boundary-hermite').check();
  await app.by('start-speed-number').fill('0');
  await app.by('start-speed-number').press('Enter');
  await app.settled();
  const curves = app.by('plot-face-rotation').locator('path.curve');
  await expect(curves).toHaveCount(6);
  const [natural, own] = await Promise.all([0, 3].map((index) => curves.nth(index).getAttribute('d')));
  expect(natural).not.toBe(own);
  await expect(app.by('plot-face-rotation')).toContainText('natural');
  await app.expectNoProblems();
});

test('distance to the first motion is coloured and drawn over time, with the KG error', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance' });
  await app.setTime(0.25);
  await app.settled();
  const bar = app.by('colour-bar');
  await expect(bar).toContainText('% of the diagonal');
  const apart = await app.page.evaluate(() => {
    const [a, b] = [window.__shapespline!.positions(0), window.__shapespline!.positions(1)];
    const far = Array.from({ length: a.length / 3 }, (_, v) =>
      Math.hypot(...[0, 1, 2].map((axis) => a[3 * v + axis]! - b[3 * v + axis]!)),
    );
    return far.reduce((most, one) => Math.max(most, one), 0) / (far.reduce((sum, one) => sum + one, 0) / far.length);
  });
  expect((await now(app)) / (await now(app, 'mean'))).toBeCloseTo(apart, 0);
  await app.by('faces').scrollIntoViewIfNeeded();
  await expect(app.by('distance-kg')).toHaveText(/KG error [\d.]+\s%/);
  const kg = Number(/KG error ([\d.]+)/.exec(await app.by('distance-kg').innerText())![1]);
  expect(kg).toBeGreaterThan(1);
  expect(kg).toBeLessThan(50);
  await app.by('distance-values').locator('summary').click();
  const shown = app.by('distance-values').locator('tbody tr');
  // The table is loaded when it is opened.
  await expect(shown).not.toHaveCount(0);
  const rows = await shown.allInnerTexts();
  const means = new Map(rows.map((row) => row.split(/\s+/).map(Number) as [number, number]));
  // Both pass through the keys.
  for (const { time } of (await app.state()).doc.keys) expect(means.get(time)).toBeLessThan(0.1);
  expect(Math.max(...means.values())).toBeGreaterThan(1);
  await app.setTime((await app.state()).doc.keys[1]!.time);
  await app.settled();
  expect(await now(app)).toBeLessThan(0.1);
  await app.by('heat-none').check({ force: true });
  await expect(app.by('plot-distance')).toBeHidden();
  await app.settled();
  await expect(bar).toBeHidden();
  await app.expectNoProblems();
});
