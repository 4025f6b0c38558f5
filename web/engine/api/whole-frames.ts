/** Whole frames of a time that has frame 0 at 0. */

type Range = readonly [number, number];

/** A frame number this near to a whole one is meant to be it: times are quotients. */
export const SAME_FRAME = 1e-6;

const firstFrame = (start: number, fps: number): number => Math.ceil(start * fps - SAME_FRAME);

/** How many whole frames the range has: any number, so that it is asked before they are listed. */
export function frameCount([start, end]: Range, fps: number): number {
  return Math.max(Math.floor(end * fps + SAME_FRAME) - firstFrame(start, fps) + 1, 0);
}

/** Times of all whole frames in the range. */
export function frameTimes(range: Range, fps: number): number[] {
  const first = firstFrame(range[0], fps);
  return Array.from({ length: frameCount(range, fps) }, (_, index) => (first + index) / fps);
}
