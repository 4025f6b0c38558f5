/** An animation played forwards and then in reverse: the same shapes, twice the time. */
import { EngineError } from '../api/errors.ts';
import { MAX_WEIGHTS } from './export-plan.ts';

export interface Weighted {
  seconds: number[];
  /** One row per time with a weight per target; null: each target is shown alone at its time. */
  weights: Float32Array | null;
}

/** The turning point is not repeated. `targets`: number of shapes without the first. */
export function pingPong({ seconds, weights }: Weighted, targets: number): Weighted {
  const there = seconds.length;
  const end = seconds.at(-1)!;
  const rows = 2 * there - 1;
  if (rows * targets > MAX_WEIGHTS)
    throw new EngineError(
      'too-large',
      `With ${targets.toLocaleString('en')} morph targets forwards and backwards, the file would be too large to open here again. ` +
        'Export it forwards only, or raise the tolerance to get fewer morph targets.',
    );
  const both = new Float32Array(rows * targets);
  for (let row = 0; row < rows; row += 1) {
    const from = row < there ? row : rows - 1 - row;
    if (weights) both.set(weights.subarray(from * targets, (from + 1) * targets), row * targets);
    else if (from > 0) both[row * targets + from - 1] = 1;
  }
  return {
    seconds: [
      ...seconds,
      ...seconds
        .slice(0, -1)
        .reverse()
        .map((s) => Math.fround(2 * end - s)),
    ],
    weights: both,
  };
}
