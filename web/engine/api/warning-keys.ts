/** Which keys a warning is about; its sentence names them, too. */
import type { Warning } from './types.ts';

/** What is open between two keys; everything else is about one key. */
const INTERVAL = /^ambiguous-/;

/**
 * The keys that bound what the warning is about, 0-based: twice the same one where it is about that key, null where it
 * is about none. A closed motion goes from its last of `count` keys to the first.
 */
export function keysOf({ code, key }: Warning, count: number): [number, number] | null {
  if (key < 0) return null;
  if (!INTERVAL.test(code)) return [key, key];
  return key === 0 || key >= count ? [count - 1, 0] : [key - 1, key];
}
