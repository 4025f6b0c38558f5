/** What each method interpolates, and its options. */
import { MOTION } from './option-table.ts';
import type { Method } from './types.ts';

export interface MethodFacts {
  /** Interpolated quantity: shapes in LRI space, which has stretches, a ghost mesh and a plane, or positions. */
  space: 'lri' | 'vertices';
  /** Straight from key to key, a polygon has no end derivatives, no tension and no bias. */
  curve: 'spline' | 'polygon';
  /** Supports holding and pins. */
  holds: boolean;
}

export const METHOD: Readonly<Record<Method, MethodFacts>> = {
  lri: { space: 'lri', curve: 'spline', holds: true },
  geodesic: { space: 'lri', curve: 'polygon', holds: false },
  linear: { space: 'vertices', curve: 'polygon', holds: false },
  'cubic-vertex': { space: 'vertices', curve: 'spline', holds: false },
};

export const METHODS: readonly Method[] = MOTION.method.choices;

/** The method of the paper. */
export const OWN_METHOD: Method = MOTION.method.default;
