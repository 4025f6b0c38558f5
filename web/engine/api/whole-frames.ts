/** Whole frames of a timeline with frame 0 at time 0. */

type Range = readonly [number, number];

/** A frame number this close to a whole number counts as whole, because times are quotients. */
export const SAME_FRAME = 1e-6;
/** An end of the range replaces a whole frame this close, in frames. */
const NEAR_END = 0.01;

/** The first and last whole frame between the ends of the range. */
const framesBetween = ([start, end]: Range, fps: number): [number, number] => [
  Math.floor(start * fps + NEAR_END) + 1,
  Math.ceil(end * fps - NEAR_END) - 1,
];

/** Number of whole frames in the range, and its ends. It may be huge, so check it before listing them. */
export function frameCount(range: Range, fps: number): number {
  const [first, last] = framesBetween(range, fps);
  return range[0] < range[1] ? Math.max(last - first + 1, 0) + 2 : 1;
}

/** Times of all whole frames in the range, and of its ends. No key at an end is lost. */
export function frameTimes([start, end]: Range, fps: number): number[] {
  const [first] = framesBetween([start, end], fps);
  const between = Math.max(frameCount([start, end], fps) - 2, 0);
  const inner = Array.from({ length: between }, (_, index) => (first + index) / fps);
  return start < end ? [start, ...inner, end] : [start];
}
