/** Chooses the upper end of a colour scale so a few slivers do not dominate it. */

/** Share of vertices within half of the scale. */
const SHARE = 0.99;
/** Minimum upper end, in percent, of a scale that clips values. Smaller differences are invisible. */
const MIN_TOP = 1;

/** The upper end for non-negative amounts in percent; `largest` is their maximum. */
export function robustLargest(values: Float32Array, largest: number): number {
  return Math.min(largest, Math.max(2 * quantile(values, SHARE), MIN_TOP));
}

/** The upper bits of a positive float sort numbers by magnitude, in steps of 3 %. */
const SHIFT = 18;

/** The quantile for this share of non-negative values, overestimated by at most 3 %. Linear time. */
export function quantile(values: Float32Array, share: number): number {
  const bits = new Uint32Array(values.buffer, values.byteOffset, values.length);
  const counts = new Uint32Array(2 ** (31 - SHIFT));
  for (let i = 0; i < bits.length; i += 1) counts[bits[i]! >>> SHIFT]! += 1;
  let [bin, below] = [0, counts[0]!];
  while (below < share * bits.length) {
    bin += 1;
    below += counts[bin]!;
  }
  return new Float32Array(Uint32Array.of((bin + 1) << SHIFT).buffer)[0]!;
}
