/** Whole frames of a timeline with frame 0 at time 0. */

type Range = readonly [number, number];

/** A frame number this close to a whole number counts as whole, because times are quotients. */
export const SAME_FRAME = 1e-6;

const firstFrame = (start: number, fps: number): number => Math.ceil(start * fps - SAME_FRAME);

/** Number of whole frames in the range. It may be huge, so check it before listing them. */
export function frameCount([start, end]: Range, fps: number): number {
  return Math.max(Math.floor(end * fps + SAME_FRAME) - firstFrame(start, fps) + 1, 0);
}

/** Times of all whole frames in the range. */
export function frameTimes(range: Range, fps: number): number[] {
  const first = firstFrame(range[0], fps);
  return Array.from({ length: frameCount(range, fps) }, (_, index) => (first + index) / fps);
}
