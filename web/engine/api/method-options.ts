/** The options of a sequence that each method supports. */
import { METHOD } from './methods.ts';
import { conflicts, without } from './rules.ts';
import { ENCODING_DEFAULTS } from './types.ts';
import type { EncodingOptions, Method, MotionOptions } from './types.ts';

/**
 * The options that a method supports; the others have their defaults. `plain`: as published, without holding, pins and
 * kept lengths.
 */
export function motionFor<T extends Omit<MotionOptions, 'method'>>(
  options: T,
  { method, plain = false }: { method: Method; plain?: boolean },
): T & { method: Method } {
  const own = { ...options, method };
  const lacks = conflicts(own).flatMap(({ option, other }) => (other === 'method' ? [option] : []));
  return without(own, plain ? [...lacks, 'hold', 'pins', 'keepLengths'] : lacks);
}

/**
 * The options without a ghost mesh if the method cannot follow it: faces that rotate by themselves need their own
 * stretches, which the paper's transfer does not keep.
 */
export function ghostFor<T extends GhostOptions>(options: T, method: Method): T {
  const follows = options.transfer !== 'paper' || ['lri', 'vertices'].includes(METHOD[method].space);
  return follows ? options : { ...options, ...NO_GHOST };
}

type GhostOptions = Pick<EncodingOptions, 'ghostFaces' | 'transfer' | 'placement'>;
const { ghostFaces, transfer, placement } = ENCODING_DEFAULTS;
export const NO_GHOST: GhostOptions = { ghostFaces, transfer, placement };
