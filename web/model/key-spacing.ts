/** Times of keys of which only the order is known. */

/** Exponent of the key distance in the length of an interval. */
export const SPACINGS = { even: 0, root: 0.5, difference: 1 } as const;
export type Spacing = keyof typeof SPACINGS;

/** The least share of a mean interval that two keys are apart, however equal they are. */
const LEAST_INTERVAL = 0.1;

/**
 * Times from first to last, with intervals as large as powers of the distances between the keys: 0 spaces them evenly,
 * 1 by how different they are. distance: one less than keys.
 */
export function spacedTimes(first: number, last: number, distance: readonly number[], power: number): number[] {
  const mean = distance.reduce((sum, d) => sum + d ** power, 0) / Math.max(distance.length, 1);
  const intervals = distance.map((d) => (mean > 0 ? Math.max(d ** power, LEAST_INTERVAL * mean) : 1));
  const all = intervals.reduce((sum, interval) => sum + interval, 0);
  let passed = 0;
  return [0, ...intervals].map((interval, index) => {
    passed += interval;
    return index === intervals.length ? last : first + ((last - first) * passed) / all;
  });
}
