/** Layout of one to four views on the canvas: side by side, or two across a divider. */
import type { Rect } from './types.ts';

/** Two overlapping views of full size, each visible on one side of a divider; the first is on the right. */
export function sides(share: number, width: number, height: number): Rect[] {
  const at = share * width;
  return [
    { x: at, y: 0, width: width - at, height },
    { x: 0, y: 0, width: at, height },
  ];
}

/** Divides the area into equal tiles. Their aspect ratio is close to `aspect` (1: square), and few tiles stay empty. */
export function tiles(count: number, width: number, height: number, aspect = 1): Rect[] {
  let columns = 1;
  let best = Infinity;
  for (let candidate = 1; candidate <= count; candidate += 1) {
    const rows = Math.ceil(count / candidate);
    const shape = Math.abs(Math.log(width / candidate / (height / rows) / aspect)) + (rows * candidate - count) * 0.5;
    if (shape < best) {
      best = shape;
      columns = candidate;
    }
  }
  const rows = Math.ceil(count / columns);
  return Array.from({ length: count }, (_, index) => {
    const column = index % columns;
    const row = Math.floor(index / columns);
    return { x: (column * width) / columns, y: (row * height) / rows, width: width / columns, height: height / rows };
  });
}
