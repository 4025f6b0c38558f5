/** Small linear systems with one right-hand side. */

export type Matrix = number[][];

export interface System {
  /** The matrix, n x n. */
  matrix: Matrix;
  /** The right-hand side, n numbers. */
  rhs: number[];
}

/**
 * Tridiagonal elimination and substitution (Thomas), one pass each. For diagonally dominant systems, which need no
 * pivoting.
 */
export function solveTridiagonal({ matrix, rhs }: System): number[] {
  const n = rhs.length;
  const diagonal = matrix.map((row, i) => row[i]!);
  const x = [...rhs];
  for (let i = 1; i < n; i += 1) {
    const factor = matrix[i]![i - 1]! / diagonal[i - 1]!;
    diagonal[i]! -= factor * matrix[i - 1]![i]!;
    x[i]! -= factor * x[i - 1]!;
  }
  x[n - 1]! /= diagonal[n - 1]!;
  for (let i = n - 2; i >= 0; i -= 1) x[i] = (x[i]! - matrix[i]![i + 1]! * x[i + 1]!) / diagonal[i]!;
  return x;
}

/** Gaussian elimination with partial pivoting, for any regular system. */
export function solveDense({ matrix, rhs }: System): number[] {
  const n = rhs.length;
  const rows = matrix.map((row, i) => [...row, rhs[i]!]);
  for (let column = 0; column < n; column += 1) {
    let pivot = column;
    for (let i = column + 1; i < n; i += 1) {
      if (Math.abs(rows[i]![column]!) > Math.abs(rows[pivot]![column]!)) pivot = i;
    }
    [rows[column], rows[pivot]] = [rows[pivot]!, rows[column]!];
    const top = rows[column]!;
    for (let i = column + 1; i < n; i += 1) {
      const factor = rows[i]![column]! / top[column]!;
      if (factor === 0) continue;
      for (let j = column; j <= n; j += 1) rows[i]![j]! -= factor * top[j]!;
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i -= 1) {
    const known = x.reduce((sum, value, j) => (j > i ? sum + rows[i]![j]! * value : sum), 0);
    x[i] = (rows[i]![n]! - known) / rows[i]![i]!;
  }
  return x;
}
