/** Documents stored in a browser between visits. */
import { withoutGone } from '../engine/api/gone-options.ts';
import type { Doc } from './state.ts';
import { EMPTY_STATE } from './state.ts';
import type { Shaping } from './shaping.ts';
import { DEFAULT_SHAPING } from './shaping.ts';

interface StoredDocument extends Partial<Pick<Doc, 'encoding'>> {
  motion?: Partial<Doc['motion']>;
  keys: { pose: number; name: string; time: number; shaping?: Partial<Shaping> }[];
}

/** Fields missing in an earlier version get their defaults. */
export function storedDocument({ keys, motion, encoding }: StoredDocument): Doc {
  const empty = EMPTY_STATE.doc;
  return {
    keys: keys.map(({ shaping, ...key }) => ({ ...key, shaping: { ...DEFAULT_SHAPING, ...shaping } })),
    motion: { ...empty.motion, ...withoutGone(motion ?? {}) },
    encoding: { ...empty.encoding, ...encoding },
  };
}
