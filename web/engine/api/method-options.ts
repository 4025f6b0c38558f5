/** The options of a sequence that each method supports. */
import { METHOD, OWN_METHOD, hasEnds } from './methods.ts';
import { ENCODING_DEFAULTS, MOTION_DEFAULTS } from './types.ts';
import type { EncodingOptions, Method, MotionOptions } from './types.ts';

/**
 * The options that a method uses; the others have no effect. Straight motion has no end derivatives, and fitted motion
 * has natural ends and no tension. Some methods ignore holding and added turns, and only the shape spline keeps
 * lengths. `plain`: as published, without holding, pins and kept lengths.
 */
export function motionFor<T extends Omit<MotionOptions, 'method'>>(
  options: T,
  { method, plain = false }: { method: Method; plain?: boolean },
): T & { method: Method } {
  const { curve, holds, turns } = METHOD[method];
  const { hold, pins } = plain || !holds ? MOTION_DEFAULTS : options;
  const { keepLengths } = plain || method !== OWN_METHOD ? MOTION_DEFAULTS : options;
  return {
    ...options,
    method,
    boundary: hasEnds(method, options.boundary) ? options.boundary : 'natural',
    hold,
    pins: [...pins],
    keepLengths,
    turns: turns ? options.turns : [],
    ...(curve === 'fitted' && { tension: [], bias: [] }),
  };
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
