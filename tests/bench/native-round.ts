/** Our native solver and others on the same system, run in each round between the engine's measurements. */

/** Milliseconds: one analysis; medians of up to five factorisations and solves of three columns. */
export interface SolverRound {
  orderMs: number;
  factorMs: number;
  solveMs: number;
  /** Entries of the triangular factor. */
  entries: number;
  /** Size of the stored factor, indices included. */
  bytes: number;
  /** Largest distance from the known solution of a system, relative to the bounding box's diagonal. */
  error: number;
}

export const PEERS = ['eigen', 'cholmod'] as const;
export const PEER_NAMES: Record<(typeof PEERS)[number], string> = { eigen: 'Eigen', cholmod: 'CHOLMOD' };

/** Our own solver in both precisions; CHOLMOD if installed. */
export interface NativeRound {
  single: SolverRound;
  double: SolverRound;
  eigen: SolverRound;
  cholmod: SolverRound | null;
}

export type RunNative = () => Promise<NativeRound>;
