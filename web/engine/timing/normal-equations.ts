/** Least squares with bounds, where each row has entries in few neighbouring blocks of unknowns. */

/** Sums of products of the rows: N x = g. Rows touch at most three neighbouring blocks of `size` unknowns. */
export class NormalEquations {
  readonly rhs: Float64Array;
  private readonly band: Float64Array;

  constructor(
    readonly blocks: number,
    readonly size: number,
  ) {
    this.rhs = new Float64Array(blocks * size);
    this.band = new Float64Array(this.rhs.length * this.width);
  }

  /** Unknowns of the five blocks that share rows with a block. */
  private get width(): number {
    return 5 * this.size;
  }

  private index(row: number, column: number): number {
    return row * this.width + column - (Math.floor(row / this.size) - 2) * this.size;
  }

  at(row: number, column: number): number {
    return this.band[this.index(row, column)]!;
  }

  /** The unknowns in the same row of N: first, and after the last. */
  near(row: number): [first: number, end: number] {
    const block = Math.floor(row / this.size);
    return [Math.max(block - 2, 0) * this.size, Math.min(block + 3, this.blocks) * this.size];
  }

  /** Adds rows. columns: of these unknowns; values: what they are to sum to. */
  add(unknowns: readonly number[], columns: readonly Float32Array[], values: Float32Array): void {
    unknowns.forEach((row, i) => {
      this.rhs[row]! += product(columns[i]!, values);
      for (let j = 0; j <= i; j += 1) {
        const sum = product(columns[i]!, columns[j]!);
        this.band[this.index(row, unknowns[j]!)]! += sum;
        if (j < i) this.band[this.index(unknowns[j]!, row)]! += sum;
      }
    });
  }

  plus(other: NormalEquations): NormalEquations {
    const sum = new NormalEquations(this.blocks, this.size);
    sum.rhs.set(this.rhs.map((value, i) => value + other.rhs[i]!));
    sum.band.set(this.band.map((value, i) => value + other.band[i]!));
    return sum;
  }

  /**
   * Minimises x (N + ridge) x / 2 - g x with |x| at most `bound`, one unknown after the other. group: unknowns of one
   * group share a part of their ridge, which is `share` of their mean and of the mean of all on the diagonal.
   */
  solve(share: number, group: (unknown: number) => number, bound: (unknown: number) => number): Float64Array {
    const diagonal = this.rhs.map((_, i) => this.at(i, i));
    const ridge = ridges(diagonal, share, group);
    const x = new Float64Array(diagonal.length);
    for (let round = 0, change = 1; round < MAX_ROUNDS && change > PRECISION; round += 1) {
      change = 0;
      for (let i = 0; i < x.length; i += 1) {
        const pivot = diagonal[i]! + ridge[i]!;
        if (pivot === 0) continue;
        let rest = this.rhs[i]! + diagonal[i]! * x[i]!;
        const [first, end] = this.near(i);
        for (let j = first; j < end; j += 1) rest -= this.at(i, j) * x[j]!;
        const next = Math.min(Math.max(rest / pivot, -bound(i)), bound(i));
        change = Math.max(change, Math.abs(next - x[i]!));
        x[i] = next;
      }
    }
    return x;
  }
}

const MAX_ROUNDS = 2000;
const PRECISION = 1e-5;

function ridges(diagonal: Float64Array, share: number, group: (unknown: number) => number): Float64Array {
  const sums = new Map<number, { sum: number; count: number }>();
  diagonal.forEach((value, i) => {
    const one = sums.get(group(i)) ?? { sum: 0, count: 0 };
    sums.set(group(i), { sum: one.sum + value, count: one.count + 1 });
  });
  const mean = diagonal.reduce((sum, value) => sum + value, 0) / diagonal.length;
  return diagonal.map((_, i) => {
    const { sum, count } = sums.get(group(i))!;
    return share * (mean + sum / count);
  });
}

/** Four sums at a time, which is twice as fast as one. */
function product(a: Float32Array, b: Float32Array): number {
  let [p, q, r, s] = [0, 0, 0, 0];
  const whole = a.length - (a.length % 4);
  for (let i = 0; i < whole; i += 4) {
    p += a[i]! * b[i]!;
    q += a[i + 1]! * b[i + 1]!;
    r += a[i + 2]! * b[i + 2]!;
    s += a[i + 3]! * b[i + 3]!;
  }
  for (let i = whole; i < a.length; i += 1) p += a[i]! * b[i]!;
  return p + q + r + s;
}
