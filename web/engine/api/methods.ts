/** What each method interpolates, and its options. */
import { MOTION } from './option-table.ts';
import type { Boundary, Method } from './types.ts';

export interface MethodFacts {
  /**
   * Interpolated quantity: shapes in LRI space, which has stretches, a ghost mesh and a plane; positions; or faces of
   * the whole shape: how each rotates by itself (rotation-strain coordinates) or against its neighbours (RIMD); or
   * lengths of edges and angles at them.
   */
  space: 'lri' | 'vertices' | 'rotation-strain' | 'rimd' | 'shells';
  /**
   * Straight from key to key, a polygon has no end derivatives, no tension and no bias. Fitted shapes are found while a
   * motion is made, which takes seconds: natural ends, no tension, no bias, and the motion cannot be updated.
   */
  curve: 'spline' | 'polygon' | 'fitted';
  /** Supports holding and pins. */
  holds: boolean;
  /** Whole turns can be added on the way to a key. */
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

export const METHODS: readonly Method[] = MOTION.method.choices;

/** The method of the paper. */
export const OWN_METHOD: Method = MOTION.method.default;
