/** Distances between shapes: the largest over all vertices. */

/** Largest distance of `shape` from the blend at `share` between `a` and `b`. */
export function farthest(shape: Float32Array, a: Float32Array, b: Float32Array, share: number): number {
  let largest = 0;
  for (let i = 0; i < shape.length; i += 3) {
    const x = shape[i]! - a[i]! - share * (b[i]! - a[i]!);
    const y = shape[i + 1]! - a[i + 1]! - share * (b[i + 1]! - a[i + 1]!);
    const z = shape[i + 2]! - a[i + 2]! - share * (b[i + 2]! - a[i + 2]!);
    const square = x * x + y * y + z * z;
    if (square > largest) largest = square;
  }
  return Math.sqrt(largest);
}
