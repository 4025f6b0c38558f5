/**
 * Pins: a foot of the walking dachshund is pinned by the user, and stays pinned in links, exports and after reopening.
 */
import { exported, type } from './exporting.ts';
import { diagonal, difference, expect, test, type App } from './support.ts';

/** The lowest vertex in the first key, and its position on the page. */
async function foot(app: App): Promise<{ vertex: number; x: number; y: number }> {
  const first = await app.positionsAt((await app.state()).doc.keys[0]!.time);
  let vertex = 0;
  for (let v = 0; v < first.length / 3; v++) if (first[3 * v + 1]! < first[3 * vertex + 1]!) vertex = v;
  return { vertex, ...(await placeOf(app, first.slice(3 * vertex, 3 * vertex + 3))) };
}

async function placeOf(app: App, point: number[]): Promise<{ x: number; y: number }> {
  const box = (await app.by('viewport').boundingBox())!;
  const [x = 0, y = 0] = await app.page.evaluate((xyz) => Array.from(window.__shapespline!.project(xyz)), point);
  return { x: box.x + x, y: box.y + y };
}

const point = (positions: number[], vertex: number): number[] => positions.slice(3 * vertex, 3 * vertex + 3);
const distance = (a: number[], b: number[]): number => Math.hypot(...a.map((x, k) => x - b[k]!));

test('a foot is pinned, dragged, undone, reloaded, exported and opened again', async ({ app }, testInfo) => {
  await app.open({ sample: 'dachshund' });
  const { keys } = (await app.state()).doc;
  const t0 = keys[0]!.time;
  const t = t0 + 0.5 * (keys[1]!.time - t0);
  const at = await foot(app);
  const plain = await app.positionsAt(t);
  await app.setTime(t0);

  await app.page.keyboard.press('Space');
  await expect.poll(async () => (await app.state()).play.playing).toBe(true);
  await app.by('pin-place').click();
  // A playing shape is hard to click, so playback stops.
  expect((await app.state()).play.playing).toBe(false);
  await app.setTime(t0);
  // Before the click, a mark shows the vertex under the pointer.
  await app.page.mouse.move(at.x, at.y - 4);
  await expect(app.by('pin-mark')).toBeVisible();
  const mark = (await app.by('pin-mark').boundingBox())!;
  await app.page.mouse.click(at.x, at.y - 4);
  await expect(app.by('pin-mark')).toBeHidden();
  await expect(app.by('pin-0')).toBeVisible();
  const placed = (await app.by('pin-handle-0').boundingBox())!;
  expect(Math.abs(placed.x + placed.width / 2 - mark.x - mark.width / 2)).toBeLessThan(2);
  const [pin] = (await app.state()).doc.motion.pins;
  expect(pin).toBeDefined();
  const vertex = pin!.vertex;
  const size = diagonal(plain);

  // The pinned foot stays at its position in the first key.
  const home = point(await app.positionsAt(t0), vertex);
  await app.by('pin-0-mode').selectOption({ index: 1 });
  await app.settled();
  const held = await app.positionsAt(t);
  expect(distance(point(held, vertex), home)).toBeLessThan(0.2 * distance(point(plain, vertex), home) + 1e-3 * size);
  expect(difference(held, plain)).toBeGreaterThan(1e-3 * size);

  // A drag moves the pin at this time, as a single undo step.
  const handle = (await app.by('pin-handle-0').boundingBox())!;
  const middle = { x: handle.x + handle.width / 2, y: handle.y + handle.height / 2 };
  await app.page.mouse.move(middle.x, middle.y);
  await app.page.mouse.down();
  await app.page.mouse.move(middle.x + 20, middle.y - 40, { steps: 3 });
  await app.page.mouse.up();
  await app.settled();
  await expect(app.by('pin-0-path')).toHaveText(/^Dragged at [\d.]+ s$/);
  // The pin's path passes through the dragged position.
  const nearest = async (): Promise<number> => {
    const line = app.page.locator('.pin-paths polyline');
    if ((await line.count()) !== 1) return Infinity;
    const now = (await app.by('pin-handle-0').boundingBox())!;
    const frame = (await app.by('pin-handles').boundingBox())!;
    const at = [now.x + now.width / 2 - frame.x, now.y + now.height / 2 - frame.y] as const;
    const points = ((await line.getAttribute('points')) ?? '').split(' ').map((one) => one.split(',').map(Number));
    return Math.min(...points.map(([x, y]) => Math.hypot(x! - at[0], y! - at[1])));
  };
  await expect.poll(nearest).toBeLessThan(40);
  const after = (await app.by('pin-handle-0').boundingBox())!;
  expect(Math.hypot(after.x - handle.x - 20, after.y - handle.y + 40)).toBeLessThan(12);
  const dragged = await app.positionsAt(t);
  await app.by('undo').click();
  await app.settled();
  expect(difference(await app.positionsAt(t), held)).toBe(0);
  await app.by('redo').click();
  await app.settled();
  expect(difference(await app.positionsAt(t), dragged)).toBe(0);

  // The link contains the pin.
  const link = (): Promise<string> => app.page.evaluate(() => decodeURIComponent(location.hash));
  await expect.poll(link).toMatch(/pins=[^&]*\//);
  await app.reload();
  await expect(app.by('pin-0-path')).toHaveText(/^Dragged at [\d.]+ s$/);
  expect(difference(await app.positionsAt(t), dragged)).toBeLessThan(1e-3 * size);

  const { download } = await exported(app, async () => {
    await app.by('export-targets-principal').check();
    await expect(app.by('export-dialog')).toContainText('only pins on their own splines are kept');
    await app.by('export-targets-every').check();
    await type(app, 'export-frames', '4');
    await expect(app.by('export-dialog')).not.toContainText('only pins on their own splines are kept');
  });
  const saved = testInfo.outputPath('pinned.glb');
  await download.saveAs(saved);
  await app.by('pin-0-remove').click();
  await app.settled();
  await expect(app.by('pin-handle-0')).toHaveCount(0);
  await app.by('file-input').setInputFiles(saved);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  await expect(app.by('pin-0-path')).toHaveText(/^Dragged at [\d.]+ s$/);
  expect(difference(dragged, await app.positionsAt(t))).toBeLessThan(1e-3 * size);
  await app.by('pin-0-remove').click();
  await app.settled();
  expect(difference(plain, await app.positionsAt(t))).toBeLessThan(1e-3 * size);
});

test('a pin shows its key or path, and scrolls into view when it is placed', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ sample: 'dachshund' });
  const keys = (await app.state()).doc.keys.map(({ time }) => time);
  const [t0, t1] = [keys[0]!, keys[1]!];
  const at = await foot(app);
  await app.setTime(t0);
  // The button is the last visible element; its hint and then the pin's row scroll into view.
  await app.page.setViewportSize({ width: 1280, height: 800 });
  await app.by('hold').scrollIntoViewIfNeeded();
  await app.by('pin-place').evaluate((button) => button.scrollIntoView({ block: 'end' }));
  await app.by('pin-place').click();
  await expect(app.by('pin-hint')).toBeInViewport({ ratio: 0.9 });
  // A click beside the shape is reported, and the next click still places the pin.
  const box = (await app.by('viewport').boundingBox())!;
  await app.page.mouse.click(box.x + 6, box.y + box.height / 2);
  await expect(app.page.getByText('That is not part of the shape')).toBeVisible();
  const again = await placeOf(app, point(await app.positions(), at.vertex));
  await app.page.mouse.click(again.x, again.y - 4);
  await expect(app.by('pin-0-mode')).toBeInViewport({ ratio: 0.9 });
  await expect(app.by('pin-0-note')).toBeHidden();

  // The whole text is visible.
  await app.by('pin-0-mode').selectOption({ label: 'As in Key 1' });
  await expect(app.by('pin-0-mode')).toHaveAttribute('title', 'Pin 1 stays as in Key 1');
  const needs = await app.by('pin-0-mode').evaluate((field: HTMLSelectElement) => {
    const style = getComputedStyle(field);
    const context = document.createElement('canvas').getContext('2d')!;
    context.font = style.font;
    const text = context.measureText(field.selectedOptions[0]!.text).width;
    return text - (field.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight));
  });
  expect(needs).toBeLessThanOrEqual(0);

  await app.by('boundary-periodic').check();
  await expect(app.by('pin-0-note')).toContainText('travels at constant speed');
  await app.by('boundary-natural').check();
  await expect(app.by('pin-0-note')).toBeHidden();

  // Removing the key is reported; undo restores the pin.
  await app.by('key-0-go').focus();
  await app.page.keyboard.press('Delete');
  await expect(app.by('pin-0-mode')).toHaveValue('own');
  await expect(app.by('pin-0-note')).toContainText('was removed');
  await app.by('undo').click();
  await expect(app.by('pin-0-note')).toBeHidden();
  await app.settled();

  // The first drag applies to all times. A second drag shortly after changes the same path key.
  const t = t0 + 0.5 * (t1 - t0);
  for (const [time, times] of [
    [t, 1],
    [t + 0.004 * (keys.at(-1)! - t0), 1],
    [t1, 2],
  ] as const) {
    await app.setTime(time);
    await app.by('pin-handle-0').press('Shift+ArrowUp');
    await app.settled();
    await expect(app.by('pin-0-path')).toHaveText(times === 1 ? /^Dragged at [\d.]+ s$/ : /at [\d.]+, [\d.]+ s$/);
    if (times === 1) await expect(app.by('pin-0-note')).toContainText('at all other times');
  }
  await expect(app.by('pin-0-note')).toBeHidden();
});
