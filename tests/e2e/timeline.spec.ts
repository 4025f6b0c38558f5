/** The slider: extrapolation, snapping, keyboard, typed times, dragged keys. */
import { difference, expect, test } from './support.ts';
import type { App } from './support.ts';

async function track(app: App): Promise<{ left: number; width: number; y: number }> {
  const box = (await app.by('timeline').locator('.track').boundingBox())!;
  return { left: box.x, width: box.width, y: box.y + box.height / 2 };
}

/** Page x of a time on the slider, which spans [-0.4, 1.4] for keys over [0, 1]. */
async function xOf(app: App, t: number): Promise<number> {
  const { left, width } = await track(app);
  return left + ((t + 0.4) / 1.8) * width;
}

test('is dragged past both ends, which colour and text show', async ({ app }) => {
  await app.open();
  const { y } = await track(app);
  const seen = new Map<string, number[]>();
  await app.page.mouse.move(await xOf(app, 0.3), y);
  await app.page.mouse.down();
  for (const [t, phase] of [
    [0.3, 'between'],
    [-0.3, 'beyond'],
    [1.3, 'beyond'],
  ] as const) {
    await app.page.mouse.move(await xOf(app, t), y, { steps: 4 });
    await app.settled();
    expect((await app.state()).time).toBeCloseTo(t, 1);
    await expect(app.by('timeline')).toHaveAttribute('data-phase', phase);
    seen.set(String(t), await app.positions());
  }
  await expect(app.by('phase')).toHaveText('Beyond the last key (extrapolated)');
  await app.page.mouse.move(await xOf(app, 9), y);
  await app.settled();
  expect((await app.state()).time).toBeCloseTo(1.4, 6);
  await app.page.mouse.up();
  const [between, before, after] = [...seen.values()] as [number[], number[], number[]];
  expect(difference(between, before)).toBeGreaterThan(0.01);
  expect(difference(between, after)).toBeGreaterThan(0.01);
  expect([...before, ...after].every(Number.isFinite)).toBe(true);
  await app.expectNoProblems();
});

test('snaps to a key within reach, and not with Alt held', async ({ app }) => {
  await app.open();
  const { doc } = await app.state();
  const key = doc.keys[1]!;
  const { y } = await track(app);
  const x = (await xOf(app, key.time)) + 4;
  // The click is above the diamond, which would be dragged instead.
  await app.page.mouse.click(x, y - 22);
  expect((await app.state()).time).toBe(key.time);
  await expect(app.by('phase')).toHaveText('At key 2');
  await app.page.keyboard.down('Alt');
  await app.page.mouse.click(x, y - 22);
  await app.page.keyboard.up('Alt');
  const { time } = await app.state();
  expect(time).not.toBe(key.time);
  expect(time).toBeCloseTo(key.time, 1);
});

test('works with the keyboard', async ({ app }) => {
  await app.open();
  const slider = app.by('timeline');
  await app.setTime(0.3);
  await slider.focus();
  const press = async (key: string): Promise<number> => {
    await app.page.keyboard.press(key);
    return (await app.state()).time;
  };
  expect(await press('Home')).toBe(0);
  expect(await press('ArrowRight')).toBeCloseTo(0.01, 9);
  expect(await press('Shift+ArrowRight')).toBeCloseTo(0.11, 9);
  expect(await press('ArrowLeft')).toBeCloseTo(0.1, 9);
  expect(await press(']')).toBe((await app.state()).doc.keys[1]!.time);
  expect(await press('End')).toBe(1);
  expect(await press('End')).toBeCloseTo(1.4, 9);
  await expect(slider).toHaveAttribute('aria-valuetext', /^1\.400 s, Beyond the last key/);
  expect(await press('[')).toBe(1);
  expect(await press('Home')).toBe(0);
  expect(await press('Home')).toBeCloseTo(-0.4, 9);
  await expect(slider).toHaveAttribute('aria-valuemin', '-0.4');
  await expect(slider).toHaveAttribute('aria-valuemax', '1.4');
  await app.page.keyboard.press('Space');
  expect((await app.state()).play.playing).toBe(true);
  await app.page.keyboard.press('Space');
});

test('accepts a typed time and restores the old time for invalid text', async ({ app }) => {
  await app.open();
  const field = app.by('time');
  await field.fill('0.42');
  await field.press('Enter');
  expect((await app.state()).time).toBeCloseTo(0.42, 9);
  await field.fill('77');
  await field.press('Enter');
  expect((await app.state()).time).toBeCloseTo(3, 9);
  await field.fill('');
  await field.press('Enter');
  expect((await app.state()).time).toBeCloseTo(3, 9);
  await expect(field).toHaveValue('3.000');
});

test('a key is dragged to another time without a new encoding', async ({ app }) => {
  await app.open();
  const before = await app.stats();
  const halfway = await app.positionsAt(0.25);
  const { y } = await track(app);
  const from = await xOf(app, (await app.state()).doc.keys[1]!.time);
  await app.page.mouse.move(from, y);
  await app.page.mouse.down();
  await app.page.mouse.move(await xOf(app, 0.7), y, { steps: 8 });
  await app.page.mouse.up();
  await app.settled();
  expect((await app.state()).doc.keys[1]!.time).toBeCloseTo(0.7, 1);
  expect(difference(await app.positionsAt(0.25), halfway)).toBeGreaterThan(0.01);
  const after = await app.stats();
  expect([after.encodeMs, after.factorMs]).toEqual([before.encodeMs, before.factorMs]);
  await app.by('undo').click();
  await app.settled();
  expect((await app.state()).doc.keys[1]!.time).toBe(0.5);
  expect(await app.positionsAt(0.25)).toEqual(halfway);
});

test('a click on the timeline shows no focus ring, the next key press does', async ({ app }) => {
  await app.open();
  const slider = app.by('timeline');
  const box = (await slider.locator('.track').boundingBox())!;
  await app.page.mouse.click(box.x + box.width / 3, box.y + box.height / 2);
  await expect(slider).toBeFocused();
  await expect(slider).toHaveCSS('outline-style', 'none');
  await app.page.keyboard.press('ArrowRight');
  await expect(slider).toHaveCSS('outline-style', 'solid');
});
