/** Documents stored in a browser between visits. Earlier versions stored options per key in separate lists. */
import { withoutGone } from '../engine/api/gone-options.ts';
import type { Doc } from './state.ts';
import { EMPTY_STATE } from './state.ts';
import type { Shaping } from './shaping.ts';
import { DEFAULT_SHAPING, shapingOf, withTurns } from './shaping.ts';

interface StoredDocument extends Partial<Pick<Doc, 'encoding'>> {
  motion?: Partial<Doc['motion']>;
  keys: { pose: number; name: string; time: number; shaping?: Partial<Shaping> }[];
  tension?: number[];
  bias?: number[];
  turns?: number[];
  partTurns?: { component: number; turns: number }[][];
}

/** Fields missing in an earlier version get their defaults. */
export function storedDocument({ keys, motion, encoding, tension, bias, turns, partTurns }: StoredDocument): Doc {
  const empty = EMPTY_STATE.doc;
  const before = (key: number): Shaping =>
    [{ turns: turns?.[key] ?? 0 }, ...(partTurns?.[key] ?? [])].reduce(withTurns, shapingOf({ tension, bias }, key));
  return {
    keys: keys.map(({ shaping, ...key }, index) => ({
      ...key,
      shaping: shaping ? { ...DEFAULT_SHAPING, ...shaping } : before(index),
    })),
    motion: { ...empty.motion, ...withoutGone(motion ?? {}) },
    encoding: { ...empty.encoding, ...encoding },
  };
}
