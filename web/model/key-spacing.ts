/** Times of keys whose order alone is known. */

/** Exponent of the key distance in the length of an interval. */
export const SPACINGS = { even: 0, root: 0.5, difference: 1 } as const;
export type Spacing = keyof typeof SPACINGS;

/** Smallest interval between two keys, even equal ones, as a share of the mean interval. */
const MIN_INTERVAL = 0.1;

/**
 * Times from first to last, with intervals proportional to a power of the key distances. Power 0 spaces keys evenly, 1
 * by their difference. distance: one entry per interval.
 */
export function spacedTimes(first: number, last: number, distance: readonly number[], power: number): number[] {
  const mean = distance.reduce((sum, d) => sum + d ** power, 0) / Math.max(distance.length, 1);
  const intervals = distance.map((d) => (mean > 0 ? Math.max(d ** power, MIN_INTERVAL * mean) : 1));
  const all = intervals.reduce((sum, interval) => sum + interval, 0);
  let passed = 0;
  return [0, ...intervals].map((interval, index) => {
    passed += interval;
    return index === intervals.length ? last : first + ((last - first) * passed) / all;
  });
}
