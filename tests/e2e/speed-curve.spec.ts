/** The timeline also shows speed, overshoot, and the shape at the time under the mouse. */
import { expect, test } from './support.ts';
import type { App } from './support.ts';

/** Heights of the speed curve over the whole timeline, 0 at the bottom. */
async function heights(app: App): Promise<number[]> {
  const d = (await app.by('speed-curve').locator('.speed-line').getAttribute('d')) ?? '';
  return [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, , y]) => 100 - Number(y));
}

/** Page position of a time on the timeline, in the middle of its track. */
async function placeOf(app: App, t: number): Promise<{ x: number; y: number }> {
  const { x, y, width, height } = (await app.by('timeline').locator('.track').boundingBox())!;
  return { x: x + ((t + 0.4) / 1.8) * width, y: y + height / 2 };
}

test('the curve in the track shows the speed of the chosen method in shape space', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  await expect(app.by('speed-curve')).toBeVisible();
  expect((await heights(app)).length).toBeGreaterThan(100);
  // The geodesic has constant speed between keys.
  await app.by('method').selectOption('geodesic');
  await app.settled();
  await expect.poll(async () => new Set((await heights(app)).map((y) => y.toFixed(0))).size).toBeLessThanOrEqual(3);
  await app.expectNoProblems();
});

test('the mouse over the timeline shows a preview of the shape there, and the main view does not change', async ({
  app,
}) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  const [peek, picture] = [app.by('time-peek'), app.by('time-peek').locator('img')];
  await expect(peek).toBeHidden();
  const before = await app.positions();
  const [near, far] = [await placeOf(app, 0.3), await placeOf(app, 0.9)];
  await app.page.mouse.move(near.x, near.y - 12);
  await expect(peek).toContainText('0.30');
  await expect(peek).toContainText('mean speed');
  await expect(picture).toHaveAttribute('src', /^data:image\/png/);
  const first = await picture.getAttribute('src');
  await app.page.mouse.move(far.x, far.y - 12, { steps: 3 });
  await expect(peek).toContainText('0.90');
  await expect(picture).not.toHaveAttribute('src', first!);
  expect((await app.state()).time).toBe(0.2);
  expect(await app.positions()).toEqual(before);
  // The image is completely visible, above the timeline at the mouse's position.
  const [card, track] = [(await peek.boundingBox())!, (await app.by('timeline').boundingBox())!];
  expect(card.y + card.height).toBeLessThanOrEqual(track.y);
  expect(Math.abs(card.x + card.width / 2 - far.x)).toBeLessThan(2);
  // It is hidden during a drag.
  await app.page.mouse.down();
  await expect(peek).toBeHidden();
  await app.page.mouse.move(near.x, near.y, { steps: 3 });
  await expect(peek).toBeHidden();
  await app.page.mouse.up();
  await app.page.mouse.move(near.x + 9, near.y - 12);
  await expect(peek).toBeVisible();
  await app.page.mouse.move(near.x, 200);
  await expect(peek).toBeHidden();
  await app.expectNoProblems();
});

test('touching the timeline shows no preview', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&t=0.2' });
  const { x, y } = await placeOf(app, 0.6);
  await app.by('timeline').dispatchEvent('pointermove', { pointerType: 'touch', clientX: x, clientY: y });
  await app.nextFrame();
  await expect(app.by('time-peek')).toBeHidden();
});
