/** Touch input on the element: vertical moves scroll the page from anywhere; sideways moves rotate and scrub. */
import type { CDPSession, Page } from '@playwright/test';
import { expect, it } from 'vitest';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';
import { KEYS, on, openElements, picture, seek, told, useElements, when } from './support/element.ts';

useElements();

const TOUCH = {
  hasTouch: true,
  isMobile: true,
  reducedMotion: 'reduce',
  viewport: { width: 400, height: 700 },
} as const;
const PARTS = ['viewport', 'timeline', 'play'] as const;

async function onPhone(attributes: string): Promise<{ page: Page; client: CDPSession }> {
  const page = await openElements(
    `<shape-spline id="a" src="${KEYS}" ${attributes}></shape-spline><i id="gap"></i>`,
    TOUCH,
  );
  await when(page, 'load');
  await seek(page, 0.25);
  return { page, client: await page.context().newCDPSession(page) };
}

async function middleOf(page: Page, part: string): Promise<{ x: number; y: number }> {
  const { x, y, width, height } = (await page.locator(`#a [part=${part}]`).boundingBox())!;
  return { x: x + width / 2, y: y + height / 2 };
}

/** Moves one finger, with the events that a touch screen sends. */
async function swipe(client: CDPSession, from: { x: number; y: number }, dx: number, dy: number): Promise<void> {
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', share: number): Promise<unknown> =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: from.x + share * dx, y: from.y + share * dy, id: 1 }],
    });
  await send('touchStart', 0);
  for (let i = 1; i <= 12; i += 1) await send('touchMove', i / 12);
  await send('touchEnd', 1);
}

const scrolled = (page: Page): Promise<number> => page.evaluate(() => scrollY);
const atRest = (page: Page): Promise<{ t: number; paused: boolean }> =>
  on(page, (shape) => ({ t: shape.currentTime, paused: shape.paused }));

it.each(PARTS)('an upward swipe from the %s only scrolls the page', async (part) => {
  const { page, client } = await onPhone('controls');
  const before = [await picture(page), await atRest(page)];
  await swipe(client, await middleOf(page, part), 0, -150);
  await expect.poll(() => scrolled(page), { timeout: 30_000 }).toBeGreaterThan(80);
  expect(await atRest(page)).toEqual(before[1]);
  expect(await told(page, 'play')).toEqual([]);
  await page.evaluate(() => scrollTo(0, 0));
  await seek(page, 0.25);
  expect((await picture(page)) === before[0]).toBe(true);
});

it('a sideways swipe rotates the shape, and does not scroll', async () => {
  const { page, client } = await onPhone('controls');
  const before = await picture(page);
  await swipe(client, await middleOf(page, 'viewport'), 120, 0);
  await expect.poll(async () => (await picture(page)) === before, { timeout: 30_000 }).toBe(false);
  expect(await scrolled(page)).toBe(0);
  expect(await on(page, (shape) => shape.currentTime)).toBe(0.25);
});

it('a sideways swipe on the timeline changes the time, and a tap sets it', async () => {
  const { page, client } = await onPhone('controls');
  const middle = await middleOf(page, 'timeline');
  await swipe(client, middle, 100, 0);
  const time = (): Promise<number> => on(page, (shape) => shape.currentTime);
  await expect.poll(time, { timeout: 30_000 }).toBeGreaterThan(0.6);
  expect(await scrolled(page)).toBe(0);
  // The browser treats a tap right after a swipe as the end of its fling, without an event.
  const tapped = async (): Promise<number> => {
    await page.touchscreen.tap(middle.x, middle.y);
    return time();
  };
  await expect.poll(tapped, { timeout: 30_000 }).toBeCloseTo(0.5, 1);
  const play = await middleOf(page, 'play');
  await page.touchscreen.tap(play.x, play.y);
  await when(page, 'play');
});

it('if the shape cannot be rotated, swipes in all directions scroll the page', async () => {
  const { page, client } = await onPhone('controls camera-controls="false"');
  const before = await picture(page);
  await swipe(client, await middleOf(page, 'viewport'), 120, 0);
  await swipe(client, await middleOf(page, 'viewport'), 0, -150);
  await expect.poll(() => scrolled(page), { timeout: 30_000 }).toBeGreaterThan(80);
  await page.evaluate(() => scrollTo(0, 0));
  await on(page, (shape: ShapeSplineElement) => shape.seek(0.25));
  expect((await picture(page)) === before).toBe(true);
});
