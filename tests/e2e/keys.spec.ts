/** The key strip: thumbnails, order, names, times, adding and removing, undo and redo; methods side by side. */
import { diagonal, difference, expect, test } from './support.ts';

test('a key is moved to another place, with undo and redo', async ({ app }) => {
  await app.open();
  const start = (await app.state()).doc;
  const first = await app.positionsAt(0);
  await app.by('key-0-edit').click();
  await app.by('key-later').click();
  await app.by('key-editor-close').click();
  await app.settled();
  const moved = (await app.state()).doc;
  expect(moved.keys.map((key) => key.pose)).toEqual([1, 0, ...start.keys.slice(2).map((key) => key.pose)]);
  expect(moved.keys.map((key) => key.time)).toEqual(start.keys.map((key) => key.time));
  expect(difference(await app.positionsAt(moved.keys[1]!.time), first)).toBeLessThan(1e-5 * diagonal(first));
  await app.page.keyboard.press('Control+z');
  await app.settled();
  expect((await app.state()).doc).toEqual(start);
  expect(await app.positionsAt(0)).toEqual(first);
  await app.page.keyboard.press('Control+Shift+z');
  expect((await app.state()).doc).toEqual(moved);
});

test('a card is dragged to another place', async ({ app }) => {
  await app.open();
  const { keys } = (await app.state()).doc;
  await app.by('key-2').dragTo(app.by('key-0'));
  await expect.poll(async () => (await app.state()).doc.keys[0]!.pose).toBe(keys[2]!.pose);
});

test('a key gets another name and time and is removed; two always remain', async ({ app }) => {
  await app.open();
  await app.by('key-1-edit').click();
  await app.by('key-name').fill('upright');
  await app.by('key-name').press('Tab');
  await app.by('key-time').fill('0.3');
  await app.by('key-time').press('Enter');
  await app.settled();
  expect((await app.state()).doc.keys[1]).toMatchObject({ name: 'upright', time: 0.3 });
  await expect(app.by('key-1-go')).toHaveAccessibleName(/upright, at 0\.300/);
  // A refused time is reported, and the field shows the time in effect.
  for (const [refused, why] of [
    ['1', 'Key 3 is already at this time.'],
    ['2e300', 'Key times can be at most 1,000,000,000 s.'],
    ['', null],
  ] as const) {
    await app.by('key-time').fill(refused);
    await app.by('key-time').press('Enter');
    if (why) await expect(app.by('toast')).toHaveText(why);
    await expect(app.by('key-time')).toHaveValue('0.300');
  }
  await app.by('key-editor-close').click();
  const count = (await app.state()).doc.keys.length;
  for (let left = count; left > 2; left -= 1) {
    await app.by('key-0-edit').click();
    await app.by('key-remove').click();
    await app.settled();
    expect((await app.state()).doc.keys.length).toBe(left - 1);
  }
  await expect(app.by('status-keys')).toHaveText('2 keys');
  await app.by('key-0-edit').click();
  await expect(app.by('key-remove')).toBeDisabled();
  await app.by('key-editor-close').click();
  while (await app.by('undo').isEnabled()) {
    await app.by('undo').click();
    await app.nextFrame();
  }
  await app.settled();
  expect((await app.state()).doc.keys.length).toBe(count);
});

test('the editor shows its key, also after a new time moves the key to another place', async ({ app }) => {
  await app.open();
  const [, second, third] = (await app.state()).doc.keys;
  await app.by('key-1-edit').click();
  await expect.poll(async () => (await app.state()).time).toBe(second!.time);
  const time = app.by('key-time');
  await time.fill('2');
  await time.press('Enter');
  await expect(app.by('key-editor').getByRole('heading')).toHaveText('Key 3');
  await expect(time).toHaveValue(/^2\.0/);
  await time.fill('-1');
  await time.press('Enter');
  await expect(app.by('key-editor').getByRole('heading')).toHaveText('Key 1');
  const { keys } = (await app.state()).doc;
  expect(keys[0]).toMatchObject({ pose: second!.pose, time: -1 });
  expect(keys[2]).toMatchObject({ pose: third!.pose, time: third!.time });
  // The playhead moves with the key.
  expect((await app.state()).time).toBe(-1);
  await expect(app.by('phase')).toContainText('At key 1');
  // The editor covers no text on a smaller screen either.
  await app.page.setViewportSize({ width: 1024, height: 768 });
  const [words, editor] = [(await app.by('phase').boundingBox())!, (await app.by('key-editor').boundingBox())!];
  expect(words.x + words.width).toBeLessThanOrEqual(editor.x);
});

test('the editor of a key receives keys wherever the focus is, and closes for other work', async ({ app }) => {
  await app.open();
  await app.by('key-1-edit').click();
  await expect(app.by('key-editor')).toBeVisible();
  await app.page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await app.page.keyboard.press('Escape');
  await expect(app.by('key-editor')).toBeHidden();
  await app.by('key-1-edit').click();
  await expect(app.by('key-editor')).toBeVisible();
  await app.page.locator('.side-nav button').nth(1).click();
  await expect(app.by('key-editor')).toBeHidden();
  await app.expectNoProblems();
  // The editor shows this shape's key, not the next one's.
  await app.by('key-1-edit').click();
  await expect(app.by('key-editor')).toBeVisible();
  await app.page.evaluate(() => (location.hash = '#sample=twisted-bar'));
  await expect.poll(async () => (await app.state()).source).toMatchObject({ id: 'twisted-bar' });
  await expect(app.by('key-editor')).toBeHidden();
});

test('one slider sets the tension of all keys, as one undo step', async ({ app }) => {
  await app.open();
  const { keys } = (await app.state()).doc;
  const t = (keys[0]!.time + 3 * keys[1]!.time) / 4;
  const loose = await app.positionsAt(t);
  const tightness = app.by('tightness-number');
  await tightness.fill('1');
  await tightness.press('Enter');
  await app.settled();
  expect((await app.state()).doc.keys.map(({ shaping }) => shaping.tension)).toEqual(keys.map(() => 1));
  const tight = await app.positionsAt(t);
  expect(difference(tight, loose)).toBeGreaterThan(1e-3 * diagonal(loose));
  await app.by('undo').click();
  await app.settled();
  expect((await app.state()).doc.keys.map(({ shaping }) => shaping.tension)).toEqual(keys.map(() => 0));
});

test('keys are spaced by their distances, and overshoot is removed', async ({ app }) => {
  await app.open();
  const before = (await app.state()).doc.keys.map(({ time }) => time);
  await app.by('space-difference').click();
  const times = async (): Promise<number[]> => (await app.state()).doc.keys.map(({ time }) => time);
  await expect.poll(times).not.toEqual(before);
  await app.by('space-even').click();
  await expect.poll(times).toEqual(before);
  await app.by('tightness-auto').click();
  await expect(app.by('toast')).toContainText('Nothing was changed');
  // Several nearly equal times make the spline overshoot.
  await app.by('key-1-edit').click();
  await app.by('key-time').fill(String(before[0]! + 0.02 * (before.at(-1)! - before[0]!)));
  await app.by('key-time').press('Enter');
  await app.settled();
  await app.by('key-editor-close').click();
  await app.by('tightness-auto').click();
  await expect
    .poll(async () => Math.max(...(await app.state()).doc.keys.map(({ shaping }) => shaping.tension)))
    .toBeGreaterThan(0);
});

test('the motion runs backwards through the same keys', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const [first, second, last] = (await app.state()).doc.keys;
  const both = first!.time + last!.time;
  const moments = [0.1, second!.time];
  const before: number[][] = [];
  for (const t of moments) before.push(await app.positionsAt(t));
  await app.setTime(1.2);
  await app.by('reverse').click();
  await app.settled();
  // The shape on the screen has not changed.
  expect((await app.state()).time).toBeCloseTo(both - 1.2, 9);
  // At its keys the reverse motion is equal. Between keys it differs slightly, because successive rotations do not
  // commute.
  for (const [index, t] of moments.entries())
    expect(difference(await app.positionsAt(both - t), before[index]!), `${t}`).toBeLessThan(
      (t === second!.time ? 1e-5 : 0.02) * diagonal(before[index]!),
    );
});

test('the shown shape becomes a key of the motion', async ({ app }) => {
  await app.open();
  const count = (await app.state()).doc.keys.length;
  const extrapolated = await app.positionsAt(1.3);
  await app.by('add-current').click();
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(count + 1);
  await app.settled();
  expect((await app.state()).doc.keys.at(-1)!.time).toBeCloseTo(1.3, 9);
  await expect(app.by('phase')).toHaveText(/^At key/);
  expect(difference(await app.positionsAt(1.3), extrapolated)).toBeLessThan(1e-5 * diagonal(extrapolated));
  await expect(app.by('add-current')).toBeDisabled();
  await app.expectNoProblems();
});

test('methods are shown side by side with the same camera and time', async ({ app }) => {
  await app.open();
  await app.setTime(0.25);
  await app.by('compare-linear').check();
  await app.settled();
  const [spline, linear] = [await app.positions(0), await app.positions(1)];
  expect(difference(spline, linear)).toBeGreaterThan(1e-3 * diagonal(spline));
  await expect(app.by('tile-0')).toContainText('Shape spline (LRI)');
  await expect(app.by('tile-1')).toContainText('Morph targets (linear)');
  const volume = async (tile: number): Promise<number> =>
    Number(/volume ([\d.]+)\s%/.exec(await app.by(`tile-${tile}`).innerText())![1]);
  // The purpose of the method: the spline keeps more of the volume than a blend of positions.
  expect(Math.abs((await volume(0)) - 100)).toBeLessThan(Math.abs((await volume(1)) - 100));
  await app.setTime(0.6);
  expect(difference(await app.positions(1), linear)).toBeGreaterThan(1e-3 * diagonal(spline));
  await app.by('compare-linear').uncheck();
  await app.settled();
  expect(await app.positions(1)).toEqual([]);
  await app.expectNoProblems();
});

test('the plots follow the motion and the cursor', async ({ app }) => {
  await app.open();
  const curve = app.by('plot-volume').locator('path.curve').first();
  // Plots are drawn once they are visible.
  await app.by('plot-volume').scrollIntoViewIfNeeded();
  await expect(curve).toHaveAttribute('d', /^M[\d.]+ [\d.]+L/);
  const before = await curve.getAttribute('d');
  const cursor = app.by('plot-volume').locator('line.cursor');
  const place = await cursor.getAttribute('x1');
  await app.setTime(0.8);
  await expect(cursor).not.toHaveAttribute('x1', place!);
  await app.by('boundary-periodic').check();
  await app.by('plot-volume').scrollIntoViewIfNeeded();
  await expect(curve).not.toHaveAttribute('d', before!);
  await expect(app.by('plot-plane').locator('circle.key')).toHaveCount((await app.state()).doc.keys.length);
  const plot = app.by('plot-volume').locator('svg.plot');
  await plot.scrollIntoViewIfNeeded();
  await app.analysed();
  await plot.click({ position: { x: 60, y: 40 } });
  expect((await app.state()).time).not.toBe(0.8);
  // The value of the curve is next to the title.
  await expect(app.by('plot-volume-value')).toHaveText(/^[\d.]+$/);
});

test('a plot shows the values of all curves at the mouse, or at the cursor moved by the keyboard', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear' });
  const plot = app.by('plot-volume').locator('svg.plot');
  await plot.scrollIntoViewIfNeeded();
  await app.analysed();
  const lines = plot.locator('.read-out text');
  const time = async (): Promise<number> => parseFloat(await lines.first().innerHTML());
  await expect(lines).toHaveCount(0);
  const box = (await plot.boundingBox())!;
  const point = (share: number) => app.page.mouse.move(box.x + share * box.width, box.y + box.height / 2);
  const { time: before } = await app.state();
  await point(0.5);
  await expect(lines).toHaveCount(3);
  await expect(lines.first()).toHaveText(/^[\d.]+ s$/);
  const middle = await time();
  await point(0.7);
  await expect.poll(time).toBeGreaterThan(middle + 0.1);
  expect((await app.state()).time).toBe(before);
  // The text matches the drawing.
  const said = async (line: number): Promise<number> =>
    Number(/([\d.]+)\s%$/.exec((await lines.nth(line).textContent())!)![1]);
  const [spline, blend] = [await said(1), await said(2)];
  await app.setTime(await time());
  await app.settled();
  const volume = async (tile: number): Promise<number> =>
    Number(/volume ([\d.]+)\s%/.exec(await app.by(`tile-${tile}`).innerText())![1]);
  expect(Math.abs(spline - (await volume(0)))).toBeLessThan(0.2);
  expect(Math.abs(blend - (await volume(1)))).toBeLessThan(0.2);
  expect(Math.abs(spline - blend)).toBeGreaterThan(1);
  await app.page.mouse.move(5, 5);
  await expect(lines).toHaveCount(0);

  await app.page.keyboard.press('Tab');
  await plot.focus();
  await expect.poll(time).toBeCloseTo((await app.state()).time, 1);
  const there = await time();
  await app.page.keyboard.press('Shift+ArrowLeft');
  await expect.poll(time).toBeLessThan(there - 0.05);
  await plot.blur();
  await expect(lines).toHaveCount(0);
  await app.expectNoProblems();
});
