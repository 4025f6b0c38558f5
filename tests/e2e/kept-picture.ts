/**
 * Stored images of the page. The stage and each panel are compared separately, scaled to a quarter so other software
 * renderers pass.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { changedShare, crop, decode, encode, shrink } from './png.ts';
import type { Box } from './png.ts';
import type { App } from './support.ts';
import { expect } from './support.ts';

export type Part = Box & { name: string };

export const SHRUNK = 4;
/** Allowed difference of a scaled pixel, in levels of 255, and the share of a part's pixels that may exceed it. */
const LEVELS = 28;
const SHARE = 0.01;

/** Positions of the page's parts on the screen, in shrunk pixels, clipped to the visible area. */
export async function partsOf(app: App, selectors: Readonly<Record<string, string>>): Promise<Part[]> {
  const { width, height } = app.page.viewportSize()!;
  const parts: Part[] = [];
  for (const [name, selector] of Object.entries(selectors)) {
    const box = await app.page.locator(selector).first().boundingBox();
    expect(box, `${name} is on the page`).not.toBeNull();
    const within = (value: number, most: number): number => Math.min(Math.max(value, 0), most) / SHRUNK;
    const [left, top] = [Math.ceil(within(box!.x, width)), Math.ceil(within(box!.y, height))];
    const [right, bottom] = [
      Math.floor(within(box!.x + box!.width, width)),
      Math.floor(within(box!.y + box!.height, height)),
    ];
    parts.push({ name, x: left, y: top, width: right - left, height: bottom - top });
  }
  return parts;
}

/** The parts that differ between two images. */
export function changedParts(kept: Buffer, now: Buffer, parts: readonly Part[]): string[] {
  const [before, after] = [decode(kept), decode(now)];
  return parts
    .filter((part) => changedShare(encode(crop(before, part)), encode(crop(after, part)), LEVELS) > SHARE)
    .map(({ name }) => name);
}

/** The page on the screen, scaled down. */
export async function shrunk(app: App): Promise<Buffer> {
  return shrink(await app.page.screenshot({ animations: 'disabled' }), SHRUNK);
}

/** Compares the image with the stored one, part by part, or retakes it. */
export function expectAsKept(file: string, now: Buffer, parts: readonly Part[], isUpdate: boolean): void {
  if (isUpdate) {
    mkdirSync(path.dirname(file), { recursive: true });
    writeFileSync(file, now);
    return;
  }
  expect(existsSync(file), `${file} is there`).toBe(true);
  expect(changedParts(readFileSync(file), now, parts), 'what looks different').toEqual([]);
}
