/** Interpolated quantity and options of each method. */
import { MOTION } from './option-table.ts';
import type { Boundary, Method, MotionOptions } from './types.ts';

export interface MethodFacts {
  /**
   * Interpolated quantity. 'lri': shapes in LRI space, with stretches, ghost mesh and shape plane. 'vertices':
   * positions. 'rotation-strain' and 'rimd': faces of the whole shape, with each rotation absolute or relative to the
   * neighbours. 'shells': edge lengths and dihedral angles.
   */
  space: 'lri' | 'vertices' | 'rotation-strain' | 'rimd' | 'shells';
  /**
   * A polygon is straight between keys and has no end derivatives, tension or bias. A fitted motion (`isFitted`) has
   * natural ends, without tension and bias.
   */
  curve: 'spline' | 'polygon' | 'fitted';
  /** Supports holding and pins. */
  holds: boolean;
  /** Supports added full turns before a key. */
  turns: boolean;
}

export const METHOD: Readonly<Record<Method, MethodFacts>> = {
  lri: { space: 'lri', curve: 'spline', holds: true, turns: true },
  geodesic: { space: 'lri', curve: 'polygon', holds: false, turns: true },
  linear: { space: 'vertices', curve: 'polygon', holds: false, turns: false },
  'cubic-vertex': { space: 'vertices', curve: 'spline', holds: false, turns: false },
  'rotation-strain': { space: 'rotation-strain', curve: 'spline', holds: false, turns: false },
  rimd: { space: 'rimd', curve: 'spline', holds: false, turns: false },
  lengths: { space: 'shells', curve: 'fitted', holds: false, turns: false },
  shell: { space: 'shells', curve: 'fitted', holds: false, turns: false },
};

/** Whether its motions can have these ends. */
export function hasEnds(method: Method, boundary: Boundary): boolean {
  const { curve } = METHOD[method];
  return curve === 'spline' || boundary === 'natural' || (curve === 'polygon' && boundary === 'periodic');
}

/** Whether a motion has shapes fitted while it is made: such motions take seconds and cannot be updated. */
export function isFitted({ method, keepLengths }: Pick<MotionOptions, 'method' | 'keepLengths'>): boolean {
  return METHOD[method].curve === 'fitted' || (method === OWN_METHOD && keepLengths > 0);
}

/** The number of fitted shapes between the keys of a motion. */
export function fitCount(
  keys: number,
  { method, keepLengths, spaceSamples }: Pick<MotionOptions, 'method' | 'keepLengths' | 'spaceSamples'>,
): number {
  const intervals = keys - 1;
  return METHOD[method].curve === 'fitted'
    ? Math.max(spaceSamples, 2 * intervals) - intervals
    : keepLengths * intervals;
}

export const METHODS: readonly Method[] = MOTION.method.choices;

/** The method of the paper. */
export const OWN_METHOD: Method = MOTION.method.default;
