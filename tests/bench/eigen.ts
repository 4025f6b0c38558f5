/** Native Eigen on the same system: asked in each round, while the engine rests, so that both meet the same machine. */

/**
 * Milliseconds: the analysis, once; the numeric factorisation and one solve of three columns, medians of up to five
 * within about three seconds.
 */
export interface EigenRound {
  orderMs: number;
  factorMs: number;
  solveMs: number;
  /** Largest distance over the bounding box's diagonal, of a system with a known solution. */
  error: number;
}

export type RunEigen = () => Promise<EigenRound>;
