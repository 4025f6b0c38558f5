/** Documents for tests, with default options and no added turns unless specified. */
import type { Shaping } from '../../web/model/shaping.ts';
import { DEFAULT_SHAPING } from '../../web/model/shaping.ts';
import type { Doc, KeyRef } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

export function keyRef(pose: number, name: string, time: number, shaping: Partial<Shaping> = {}): KeyRef {
  return { pose, name, time, shaping: { ...DEFAULT_SHAPING, ...shaping } };
}

export function docOfKeys(...keys: KeyRef[]): Doc {
  return { ...EMPTY_STATE.doc, keys };
}
