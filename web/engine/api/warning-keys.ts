/** The keys of a warning, which its message names as well. */
import type { Warning } from './types.ts';

/** Ambiguities and turns that are not held concern an interval; all other warnings concern one key. */
const INTERVAL = /^(ambiguous|unheld)-/;

/**
 * The keys around the warning's time, 0-based: equal for a warning about one key, null for none. A closed motion goes
 * from its last of `count` keys to the first.
 */
export function keysOf({ code, key }: Warning, count: number): [number, number] | null {
  if (key < 0) return null;
  if (!INTERVAL.test(code)) return [key, key];
  return key === 0 || key >= count ? [count - 1, 0] : [key - 1, key];
}
