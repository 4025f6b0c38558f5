/** The keys that a warning concerns; its sentence names them as well. */
import type { Warning } from './types.ts';

/** Ambiguities concern an interval; all other warnings concern one key. */
const INTERVAL = /^ambiguous-/;

/**
 * The keys that bound the warning's place, 0-based: the same key twice for a warning about one key, null for none. A
 * closed motion goes from its last of `count` keys to the first.
 */
export function keysOf({ code, key }: Warning, count: number): [number, number] | null {
  if (key < 0) return null;
  if (!INTERVAL.test(code)) return [key, key];
  return key === 0 || key >= count ? [count - 1, 0] : [key - 1, key];
}
