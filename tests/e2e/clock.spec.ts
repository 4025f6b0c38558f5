/** Time controls for animators: a playing range, whole frames, timeline zoom. */
import { difference, expect, test } from './support.ts';
import type { App } from './support.ts';

async function track(app: App): Promise<{ left: number; width: number; y: number }> {
  const box = (await app.by('timeline').locator('.track').boundingBox())!;
  return { left: box.x, width: box.width, y: box.y + box.height / 2 };
}

async function windowOf(app: App): Promise<[number, number]> {
  return (await app.state()).view.window ?? [-0.4, 1.4];
}

/** Page x of a time in the visible window. */
async function xOf(app: App, t: number): Promise<number> {
  const { left, width } = await track(app);
  const [low, high] = await windowOf(app);
  return left + ((t - low) / (high - low)) * width;
}

async function centreOf(app: App, selector: string): Promise<number> {
  const box = (await app.page.locator(selector).boundingBox())!;
  return box.x + box.width / 2;
}

test('two handles are dragged to set the playing range', async ({ app }) => {
  await app.open();
  const { page } = app;
  const drag = async (handle: string, from: number, to: number): Promise<void> => {
    const box = (await app.by(handle).boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + 12);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + (await xOf(app, to)) - (await xOf(app, from)), box.y + 12, {
      steps: 6,
    });
    await page.mouse.up();
  };
  await app.by('timeline').hover();
  await drag('loop-start', 0, 0.3);
  await drag('loop-end', 1, 1.2);
  const { between } = (await app.state()).play;
  expect(between![0]).toBeCloseTo(0.3, 2);
  expect(between![1]).toBeCloseTo(1.2, 2);
  expect((await app.state()).doc.keys.map((key) => key.time)).toEqual([0, 0.5, 1]);
  await expect(app.by('loop-start')).toHaveAttribute('aria-valuetext', /^0\.3/);
  // None of this edits the motion.
  await expect(app.by('undo')).toBeDisabled();
  await app.expectNoProblems();
});

test('the handles work with the keyboard, and one key resets the range', async ({ app }) => {
  await app.open();
  const { page } = app;
  const between = async (): Promise<number[] | null> => (await app.state()).play.between;
  await app.setTime(0.25);
  await page.keyboard.press('Control+Home');
  await app.setTime(0.75);
  await page.keyboard.press('Control+End');
  expect(await between()).toEqual([0.25, 0.75]);
  await app.nextFrame();
  await app.by('loop-end').focus();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Shift+ArrowLeft');
  expect((await between())![1]).toBeCloseTo(0.64, 9);
  expect((await app.state()).time).toBe(0.75);
  await page.keyboard.press('p');
  expect(await between()).toBeNull();
  await app.by('clock-toggle').click();
  await app.by('loop-from').fill('0.1');
  await app.by('loop-from').press('Enter');
  await app.by('loop-end-here').click();
  expect(await between()).toEqual([0.1, 0.75]);
  await app.by('loop-reset').click();
  expect(await between()).toBeNull();
  await expect(app.by('loop-from')).toHaveValue('0.000');
});

test('the wheel zooms about the pointer; ticks, playhead and margins follow', async ({ app }) => {
  await app.open();
  const { page } = app;
  await app.setTime(0.5);
  const x = await xOf(app, 0.5);
  const { y, width } = await track(app);
  const gap = async (): Promise<number> =>
    (await centreOf(app, '[data-testid="tick-1"]')) - (await centreOf(app, '[data-testid="tick-0"]'));
  expect(await gap()).toBeCloseTo((0.5 / 1.8) * width, 0);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -200);
  await expect.poll(async () => (await windowOf(app))[1] - (await windowOf(app))[0]).toBeLessThan(1.3);
  const [low, high] = await windowOf(app);
  await app.nextFrame();
  // The key under the pointer stays in place, and distances grow by the zoom factor.
  expect(await centreOf(app, '[data-testid="tick-1"]')).toBeCloseTo(x, 0);
  expect(await gap()).toBeCloseTo((0.5 / (high - low)) * width, 0);
  expect((await app.page.locator('.margin.before').boundingBox())!.width).toBeCloseTo(
    ((0 - low) / (high - low)) * width,
    0,
  );
  await expect(page.locator('.ruler .mark').first()).toBeVisible();
  for (let step = 0; step < 20; step += 1) await page.mouse.wheel(0, -400);
  await expect.poll(async () => 1.8 / ((await windowOf(app))[1] - (await windowOf(app))[0])).toBeGreaterThan(20);
  await app.nextFrame();
  await expect(app.by('tick-0')).toBeHidden();
  await expect(app.by('tick-1')).toBeVisible();
  await expect(page.locator('.margin.before')).toBeHidden();
  const { time } = await app.state();
  // The window is panned; the time does not change.
  const before = await windowOf(app);
  await page.keyboard.down('Shift');
  await page.mouse.wheel(0, 100);
  await page.keyboard.up('Shift');
  await expect.poll(async () => (await windowOf(app))[0]).toBeGreaterThan(before[0]);
  expect((await app.state()).time).toBe(time);
  await page.keyboard.press('0');
  expect((await app.state()).view.window).toBeNull();
  await app.nextFrame();
  await expect(app.by('tick-0')).toBeVisible();
  await app.expectNoProblems();
});

test('two fingers zoom', async ({ app }) => {
  await app.open();
  const { left, width, y } = await track(app);
  const session = await app.page.context().newCDPSession(app.page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', xs: number[]): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: xs.map((x, id) => ({ x, y, id })) });
  const middle = left + width / 2;
  await touch('touchStart', [middle - 40]);
  await touch('touchStart', [middle - 40, middle + 40]);
  for (const half of [60, 90, 120, 160]) await touch('touchMove', [middle - half, middle + half]);
  await touch('touchEnd', []);
  const [low, high] = await windowOf(app);
  expect(1.8 / (high - low)).toBeCloseTo(4, 1);
  expect((low + high) / 2).toBeCloseTo(0.5, 1);
});

test('the time field, the steps and the slider snap to whole frames', async ({ app }) => {
  await app.open();
  const { page } = app;
  await app.setTime(0.3);
  const between = await app.positions();
  await app.by('clock-toggle').click();
  await app.by('whole-frames').check();
  await app.by('fps').fill('8');
  await app.by('fps').press('Enter');
  await page.keyboard.press('Escape');
  expect((await app.state()).play.fps).toBe(8);
  await expect(app.by('time')).toHaveValue('2.4');
  await app.by('time').fill('3');
  await app.by('time').press('Enter');
  expect((await app.state()).time).toBe(3 / 8);
  await app.by('timeline').focus();
  await page.keyboard.press('ArrowRight');
  expect((await app.state()).time).toBe(4 / 8);
  await expect(app.by('timeline')).toHaveAttribute('aria-valuetext', /^frame 4, At key 2/);
  const { y } = await track(app);
  await page.mouse.click(await xOf(app, 0.3), y - 20);
  expect((await app.state()).time).toBe(2 / 8);
  await app.settled();
  expect(difference(await app.positions(), between)).toBeGreaterThan(0);
});

test('an export has the playing range', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&between=0.25,0.75&fps=8' });
  await app.by('export').click();
  await expect(app.by('export-from')).toHaveValue('0.25');
  await expect(app.by('export-to')).toHaveValue('0.75');
  await app.by('export-targets-every').check();
  await expect(app.by('export-frames')).toHaveValue('5');
  await expect(app.by('export-size')).toHaveText(/^2\ss, 5 frames/);
});
