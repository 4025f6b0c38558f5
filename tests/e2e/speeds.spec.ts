/** The Hermite speeds as handles at the ends of the curve: on the timeline, and in the shape plane. */
import type { Locator } from '@playwright/test';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

/** Drags by this many pixels without releasing. */
async function pull(app: App, handle: Locator, dx: number, dy = 0): Promise<void> {
  const box = (await handle.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await app.page.mouse.move(x, y);
  await app.page.mouse.down();
  await app.page.mouse.move(x + dx, y + dy, { steps: 6 });
}

async function speeds(app: App): Promise<[number, number]> {
  const { startSpeed, endSpeed } = (await app.state()).doc.motion;
  return [startSpeed, endSpeed];
}

async function openHermite(app: App, hash = ''): Promise<void> {
  await app.open({ hash: `#sample=cactus&boundary=hermite${hash}` });
}

const ENDS = [
  { end: 'start', inward: 1, panel: 0 },
  { end: 'end', inward: -1, panel: 1 },
] as const;

test('handles are shown at the first and last key for Hermite ends only', async ({ app }) => {
  await app.open();
  await expect(app.by('speed-lane')).toBeHidden();
  const places = () =>
    app.page.evaluate(() => window.__shapespline!.project(window.__shapespline!.positions()).slice(0, 200));
  const picture = () => app.by('viewport').locator('canvas').boundingBox();
  const buttons = async () => (await app.by('fit').boundingBox())!;
  const [shape, canvas, button] = [await places(), await picture(), await buttons()];
  await app.by('boundary-hermite').check();
  await app.settled();
  // The lane covers the bottom of the viewport. The shape stays in place, and no button is below the lane.
  expect([await places(), await picture()]).toEqual([shape, canvas]);
  const lane = (await app.by('speed-lane').boundingBox())!;
  expect((await buttons()).y).toBeCloseTo(button.y - lane.height, 0);
  const track = (await app.by('timeline').locator('.track').boundingBox())!;
  for (const { end, inward } of ENDS) {
    await app.by(`${end}-speed-number`).fill('1');
    await app.by(`${end}-speed-number`).press('Enter');
    await app.settled();
    const key = track.x + (track.width * (end === 'start' ? 0.4 : 1.4)) / 1.8;
    const grip = (await app.by(`${end}-speed-handle`).boundingBox())!;
    const reach = (grip.x + grip.width / 2 - key) * inward;
    expect(reach).toBeGreaterThan(10);
    expect(reach).toBeLessThan(track.width / 3.6);
    await expect(app.by(`${end}-speed-value`)).toHaveText('1×');
  }
  await app.by('method').selectOption('linear');
  await expect(app.by('speed-lane')).toBeHidden();
});

test('dragging a handle changes the motion there at once, as one undo step', async ({ app }) => {
  await openHermite(app);
  const before = await app.positionsAt(0.9);
  const key = await app.positionsAt(1);
  await app.setTime(0.9);
  await pull(app, app.by('end-speed-handle'), -40);
  await app.settled();
  const dragged = await app.positions();
  expect(difference(dragged, before)).toBeGreaterThan(1e-3 * diagonal(before));
  await app.page.mouse.up();
  const [start, speed] = await speeds(app);
  expect(speed).toBeGreaterThan(1.5);
  expect(start).toBe(1);
  // Handle, panel and link show the same value.
  await expect(app.by('end-speed-value')).toHaveText(`${speed}×`);
  await expect(app.by('end-speed-handle')).toHaveAttribute('aria-valuenow', String(speed));
  await expect(app.by('end-speed-number')).toHaveValue(String(speed));
  await expect(app.page).toHaveURL(new RegExp(`endSpeed=${speed}(&|$)`));
  expect(difference(await app.positionsAt(1), key)).toBeLessThan(1e-5 * diagonal(key));
  await app.by('end-speed-reset').click();
  expect(await speeds(app)).toEqual([1, 1]);
  await app.by('undo').click();
  await app.by('undo').click();
  await app.settled();
  expect(await speeds(app)).toEqual([1, 1]);
  await expect(app.by('undo')).toBeDisabled();
  expect(await app.positionsAt(0.9)).toEqual(before);
});

test('the handles work with the keyboard, and a double click resets them', async ({ app }) => {
  await openHermite(app);
  for (const { end, inward, panel } of ENDS) {
    const handle = app.by(`${end}-speed-handle`);
    const pressed = async (key: string): Promise<number> => {
      await handle.press(key);
      return (await speeds(app))[panel];
    };
    expect(await pressed('ArrowUp')).toBe(1.05);
    expect(await pressed(inward > 0 ? 'ArrowRight' : 'ArrowLeft')).toBe(1.1);
    expect(await pressed('Shift+ArrowDown')).toBe(0.6);
    expect(await pressed('Home')).toBe(0);
    expect(await pressed('End')).toBe(4);
    expect(await pressed('Delete')).toBe(1);
    expect((await app.state()).time).toBe(0);
    await pressed('End');
    await app.nextFrame();
    await handle.dblclick();
    expect((await speeds(app))[panel]).toBe(1);
  }
});

test('the handles can be dragged at 360 px, and do not overlap at full length', async ({ app }) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await openHermite(app, '&startSpeed=4&endSpeed=4');
  const [start, end] = [
    (await app.by('start-speed-handle').boundingBox())!,
    (await app.by('end-speed-handle').boundingBox())!,
  ];
  expect(start.x + start.width).toBeLessThanOrEqual(end.x + 12);
  await pull(app, app.by('start-speed-handle'), -30);
  await app.page.mouse.up();
  const [speed] = await speeds(app);
  expect(speed).toBeLessThan(3);
  expect(speed).toBeGreaterThan(1);
  await app.expectNoProblems();
});

test('a handle in the shape plane bends the curve along its tangent', { tag: '@all' }, async ({ app }) => {
  await openHermite(app);
  await app.by('plot-plane').scrollIntoViewIfNeeded();
  const curve = app.by('plot-plane').locator('path.curve.lri');
  await expect(curve).toBeVisible();
  const [before, shape] = [await curve.getAttribute('d'), await app.positionsAt(0.1)];
  const grip = app.by('plane-start-speed').locator('.grip-mark');
  const stem = await app
    .by('plane-start-speed')
    .locator('.stem')
    .evaluate((line) => {
      const [x1, y1, x2, y2] = ['x1', 'y1', 'x2', 'y2'].map((name) => Number(line.getAttribute(name))) as [
        number,
        number,
        number,
        number,
      ];
      return [x2 - x1, y2 - y1] as const;
    });
  const scale = (await app.by('plot-plane').locator('svg.plot').boundingBox())!.width / 272;
  await pull(app, grip, stem[0] * scale, stem[1] * scale);
  await app.page.mouse.up();
  await app.settled();
  expect((await speeds(app))[0]).toBeCloseTo(2, 1);
  await expect(app.by('start-speed-value')).toHaveText(`${(await speeds(app))[0]}×`);
  await expect(curve).not.toHaveAttribute('d', before!);
  expect(difference(await app.positionsAt(0.1), shape)).toBeGreaterThan(1e-3 * diagonal(shape));
  // Dragging perpendicular to the tangent changes nothing.
  const [speed] = await speeds(app);
  await pull(app, grip, -stem[1], stem[0]);
  await app.page.mouse.up();
  expect((await speeds(app))[0]).toBeCloseTo(speed, 1);
  await app.by('plane-start-speed').press('Delete');
  expect((await speeds(app))[0]).toBe(1);
});
