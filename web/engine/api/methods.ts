/** What each method interpolates, and its options. */
import { MOTION } from './option-table.ts';
import type { Method } from './types.ts';

export interface MethodFacts {
  /**
   * Interpolated quantity: shapes in LRI space, which has stretches, a ghost mesh and a plane; positions; or faces of
   * the whole shape: how each rotates by itself (rotation-strain coordinates) or against its neighbours (RIMD).
   */
  space: 'lri' | 'vertices' | 'rotation-strain' | 'rimd';
  /** Straight from key to key, a polygon has no end derivatives, no tension and no bias. */
  curve: 'spline' | 'polygon';
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
};

export const METHODS: readonly Method[] = MOTION.method.choices;

/** The method of the paper. */
export const OWN_METHOD: Method = MOTION.method.default;
