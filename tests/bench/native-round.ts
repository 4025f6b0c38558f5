/** Our own solver and others, native, on the same system: run in each round between the engine's runs. */

/** Milliseconds: the analysis once; the factorisation and a solve of three columns, medians of up to five. */
export interface SolverRound {
  orderMs: number;
  factorMs: number;
  solveMs: number;
  /** Of the triangular factor. */
  entries: number;
  /** Size of the stored factor, indices included. */
  bytes: number;
  /** Largest distance over the bounding box's diagonal, of a system with a known solution. */
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
