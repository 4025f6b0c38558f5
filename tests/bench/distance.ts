/** Distance of two shapes, relative to the diagonal of the second's bounding box. */
export interface Distance {
  mean: number;
  worst: number;
}

/**
 * The distance of positions with 3 numbers per vertex. If the first shape has more vertices, only common ones are
 * compared.
 */
export function distanceOf(positions: ArrayLike<number>, reference: ArrayLike<number>): Distance {
  if (positions.length < reference.length) throw new Error('the reference belongs to another mesh');
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  let sum = 0,
    largest = 0;
  for (let v = 0; v < reference.length; v += 3) {
    let squared = 0;
    for (let k = 0; k < 3; ++k) {
      const x = reference[v + k]!;
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
      squared += (positions[v + k]! - x) ** 2;
    }
    const distance = Math.sqrt(squared);
    sum += distance;
    largest = Math.max(largest, distance);
  }
  const diagonal = Math.hypot(...high.map((h, k) => h - low[k]!));
  return { mean: sum / (reference.length / 3) / diagonal, worst: largest / diagonal };
}

/** The larger mean and the larger maximum: an upper bound for several pairs of shapes. */
export function worse(a: Distance, b: Distance): Distance {
  return { mean: Math.max(a.mean, b.mean), worst: Math.max(a.worst, b.worst) };
}

export const NO_DISTANCE: Readonly<Distance> = { mean: 0, worst: 0 };
