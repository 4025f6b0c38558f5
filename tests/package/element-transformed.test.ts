/** Pointers on the element in containers that the page rotates, scales, tilts or zooms. */
import type { Page } from '@playwright/test';
import { expect, it } from 'vitest';
import { KEYS, POLICY, on, openElements, picture, seek, useElements, when } from './support/element.ts';

useElements();

const POLICY_WITH_STYLES = POLICY.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'");

const STYLES = [
  ['none', ''],
  ['rotated by a quarter', 'transform: rotate(90deg)'],
  ['rotated by a half', 'rotate: 180deg'],
  ['rotated and scaled', 'transform: rotate(-30deg) scale(0.7)'],
  ['mirrored', 'scale: -1 1'],
  ['tilted', 'transform: perspective(600px) rotateY(40deg)'],
  ['zoomed', 'zoom: 1.2'],
] as const;

async function openStyled(style: string, more = ''): Promise<Page> {
  const page = await openElements(
    `<div style="width: 400px; margin: 150px 0 0 80px; ${style}"><shape-spline id="a" src="${KEYS}" controls
      loading="eager" style="width: 400px; ${more}"></shape-spline></div>`,
    { policy: POLICY_WITH_STYLES, reducedMotion: 'reduce' },
  );
  await when(page, 'load');
  return page;
}

/** The centre of the thumb while this time is shown. */
async function placeOf(page: Page, t: number): Promise<{ x: number; y: number }> {
  await seek(page, t);
  const { x, y, width, height } = (await page.locator('#a [part=thumb]').boundingBox())!;
  return { x: x + width / 2, y: y + height / 2 };
}

it.each(STYLES)('the timeline follows the pointer: %s', async (_, style) => {
  const page = await openStyled(style);
  const [from, to] = [await placeOf(page, 0.3), await placeOf(page, 0.75)];
  const time = (): Promise<number> => on(page, (shape) => shape.currentTime);
  await page.mouse.click(from.x, from.y);
  await expect.poll(time).toBeCloseTo(0.3, 1.5);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  await expect.poll(time).toBeCloseTo(0.75, 1.5);
  // The thumb itself can be pressed.
  await page.mouse.click(to.x, to.y);
  await expect.poll(time).toBeCloseTo(0.75, 1.5);
});

it('also if the element itself is transformed', async () => {
  const page = await openStyled('', 'transform: rotate(60deg)');
  const { x, y } = await placeOf(page, 0.3);
  await seek(page, 0.8);
  await page.mouse.click(x, y);
  await expect.poll(() => on(page, (shape) => shape.currentTime)).toBeCloseTo(0.3, 1.5);
});

/** The image after a drag from the middle of the shape, along its own horizontal axis. */
async function dragged(style: string, dx: number, dy: number): Promise<string> {
  const page = await openStyled(style);
  await seek(page, 0.5);
  const { x, y, width, height } = (await page.locator('#a [part=viewport]').boundingBox())!;
  const [middleX, middleY] = [Math.round(x + width / 2), Math.round(y + height / 2)];
  await page.mouse.move(middleX, middleY);
  await page.mouse.down();
  await page.mouse.move(middleX + dx, middleY + dy, { steps: 4 });
  await page.mouse.up();
  await seek(page, 0.5);
  return picture(page);
}

it('a drag rotates the shape along its own axes', async () => {
  const plain = await dragged('', 80, 0);
  expect((await dragged('', 0, 80)) === plain).toBe(false);
  expect((await dragged('transform: rotate(90deg)', 0, 80)) === plain).toBe(true);
  expect((await dragged('rotate: 180deg', -80, 0)) === plain).toBe(true);
  expect((await dragged('scale: 0.5', 40, 0)) === plain).toBe(true);
});
