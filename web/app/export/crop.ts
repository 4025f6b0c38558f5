/** Crops the empty border around the shapes of an image. */
import type { Rect } from '../../viewer/types.ts';
import { titleHeight, writeTitle } from './title.ts';
import type { Title } from './title.ts';

/** Pixels with at least this alpha count as drawn. */
const SEEN = 8;
/** Margin around a shape, as a share of its box's larger side. */
const MARGIN = 0.03;

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** The box of a view's drawn pixels, from its corner; null for an empty view. `pixels`: RGBA of this view only. */
export function drawnBox({ data, width, height }: Pick<ImageData, 'data' | 'width' | 'height'>): Box | null {
  const box = { left: width, top: height, right: 0, bottom: 0 };
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      if (data[4 * (y * width + x) + 3]! < SEEN) continue;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x + 1);
      box.top = Math.min(box.top, y);
      box.bottom = y + 1;
    }
  }
  return box.right > box.left ? box : null;
}

/**
 * The smallest box around the drawn pixels of all views, with a margin, clipped to the view. The whole view if nothing
 * is drawn.
 */
export function commonBox(boxes: readonly (Box | null)[], { width, height }: { width: number; height: number }): Box {
  const drawn = boxes.filter((box) => box !== null);
  if (drawn.length === 0) return { left: 0, top: 0, right: width, bottom: height };
  const left = Math.min(...drawn.map((box) => box.left));
  const top = Math.min(...drawn.map((box) => box.top));
  const right = Math.max(...drawn.map((box) => box.right));
  const bottom = Math.max(...drawn.map((box) => box.bottom));
  const margin = Math.ceil(MARGIN * Math.max(right - left, bottom - top));
  return {
    left: Math.max(left - margin, 0),
    top: Math.max(top - margin, 0),
    right: Math.min(right + margin, width),
    bottom: Math.min(bottom + margin, height),
  };
}

/** The part of each view inside the box, arranged like the views, each under its title. */
export function joined(
  picture: HTMLCanvasElement,
  rects: readonly Rect[],
  box: Box,
  titles: readonly Title[],
  ground: string | null,
): HTMLCanvasElement {
  const size = { width: box.right - box.left, height: box.bottom - box.top };
  const top = Math.max(...titles.map((title) => titleHeight(size, title)), 0);
  const [columns, rows] = [placesOf(rects.map(({ x }) => x)), placesOf(rects.map(({ y }) => y))];
  const canvas = Object.assign(document.createElement('canvas'), {
    width: size.width * columns.length,
    height: (size.height + top) * rows.length,
  });
  const context = canvas.getContext('2d')!;
  if (ground !== null) {
    context.fillStyle = ground;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }
  rects.forEach((rect, view) => {
    const x = columns.indexOf(rect.x) * size.width;
    const y = rows.indexOf(rect.y) * (size.height + top);
    const [fromX, fromY] = [Math.round(rect.x) + box.left, Math.round(rect.y) + box.top];
    context.drawImage(picture, fromX, fromY, size.width, size.height, x, y + top, size.width, size.height);
    if (titles[view]) writeTitle(context, titles[view], { x, y, ...size });
  });
  return canvas;
}

function placesOf(values: readonly number[]): number[] {
  return [...new Set(values)].sort((a, b) => a - b);
}
