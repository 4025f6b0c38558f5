/** The upper end of a colour scale that a few slivers do not set. */

/** Share of the vertices within half of the scale. */
const SHARE = 0.99;
/** In percent. A scale that cuts off values reaches at least this far: smaller differences are invisible. */
const LEAST = 1;

/** Of amounts in percent, none of them negative; `largest`: of all of them. Nothing is left out needlessly. */
export function robustLargest(values: Float32Array, largest: number): number {
  return Math.min(largest, Math.max(2 * quantile(values, SHARE), LEAST));
}

/** The upper bits of a positive float order numbers by their size, in steps of 3 %. */
const SHIFT = 18;

/** What this share of the values does not exceed, at most 3 % too large. Linear in their number; none is negative. */
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
