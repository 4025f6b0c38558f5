/** Where a motion of a fitted method shows its own shapes, and where it falls back on another method. */
import type { Motion } from '../engine/api/api.ts';
import { METHOD } from '../engine/api/methods.ts';

/** Whether the motion shows shapes of its own method at t. A key belongs to both of its intervals. */
export function isOwnAt({ fitted, keyTimes, options }: Motion, t: number): boolean {
  if (!fitted || METHOD[options.method].curve !== 'fitted') return true;
  const last = fitted.length - 1;
  const reaches = (i: number): boolean => (i === 0 || keyTimes[i]! <= t) && (i === last || t <= keyTimes[i + 1]!);
  return fitted.every((isFitted, i) => isFitted || !reaches(i));
}

/** The number of intervals between keys with fitted shapes; null for motions without fits. */
export const fittedCount = ({ fitted }: Pick<Motion, 'fitted'>): number | null =>
  fitted?.filter((isFitted) => isFitted).length ?? null;

/** Names the intervals without a fit, by their keys. */
export function unfittedNote({ fitted }: Pick<Motion, 'fitted'>): string {
  const ends = (fitted ?? []).flatMap((isFitted, i) => (isFitted ? [] : [`${i + 1} and ${i + 2}`]));
  return ends.length === 0 ? '' : `no fitted shapes between keys ${ends.join(', ')}`;
}

const ABOUT_FITS: readonly string[] = [
  'lengths-not-fitted',
  'bending-not-minimised',
  'bending-search-ended',
  'bends-more-than-lri',
];

/** The motion's warnings about its fits. */
export const fitWarnings = ({ warnings }: Pick<Motion, 'warnings'>): string[] =>
  warnings.filter(({ code }) => ABOUT_FITS.includes(code)).map(({ message }) => message);
