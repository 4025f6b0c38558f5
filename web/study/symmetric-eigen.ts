/** Eigenvectors of small symmetric matrices (cyclic Jacobi). */

/** The unit eigenvector of the largest eigenvalue. matrix: n x n, row by row. */
export function leadingEigenvector(matrix: readonly number[], n: number): number[] {
  const a = [...matrix];
  const vectors = Array.from({ length: n * n }, (_, i) => (i % (n + 1) === 0 ? 1 : 0));
  for (let sweep = 0; sweep < 40; sweep += 1) {
    let off = 0;
    for (let p = 0; p < n; p += 1)
      for (let q = p + 1; q < n; q += 1) {
        off += a[p * n + q]! ** 2;
        rotate(a, vectors, n, p, q);
      }
    if (off < 1e-30 * a.reduce((sum, entry) => sum + entry * entry, 0)) break;
  }
  let best = 0;
  for (let i = 1; i < n; i += 1) if (a[i * (n + 1)]! > a[best * (n + 1)]!) best = i;
  return Array.from({ length: n }, (_, row) => vectors[row * n + best]!);
}

/** Makes entry (p, q) zero. */
function rotate(a: number[], vectors: number[], n: number, p: number, q: number): void {
  const apq = a[p * n + q]!;
  if (apq === 0) return;
  const theta = (a[q * (n + 1)]! - a[p * (n + 1)]!) / (2 * apq);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  const s = t * c;
  const turn = (of: number[], first: number, second: number): void => {
    const [x, y] = [of[first]!, of[second]!];
    of[first] = c * x - s * y;
    of[second] = s * x + c * y;
  };
  for (let k = 0; k < n; k += 1) turn(a, k * n + p, k * n + q);
  for (let k = 0; k < n; k += 1) turn(a, p * n + k, q * n + k);
  for (let k = 0; k < n; k += 1) turn(vectors, k * n + p, k * n + q);
}
