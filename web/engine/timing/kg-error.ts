/**
 * The error of a motion relative to a reference, after Karni and Gotsman (2004), in percent: 100 |A - A~| / |A - E(A)|,
 * with Frobenius norms over all vertices of all frames. E(A) puts every vertex of a frame at the frame's centroid. The
 * core's tests have a separate implementation (tests/native/kg_error.h).
 */
export class KgError {
  private difference = 0;
  private spread = 0;

  /** Adds one frame of both motions, 3 x vertices. */
  add(reference: Float32Array, other: Float32Array): void {
    const centroid = [0, 1, 2].map((axis) => meanOf(reference, axis));
    for (let i = 0; i < reference.length; i += 3) {
      for (let axis = 0; axis < 3; axis += 1) {
        const value = reference[i + axis]!;
        this.difference += (value - other[i + axis]!) ** 2;
        this.spread += (value - centroid[axis]!) ** 2;
      }
    }
  }

  get percent(): number {
    return this.difference === 0 ? 0 : 100 * Math.sqrt(this.difference / this.spread);
  }
}

function meanOf(values: Float32Array, axis: number): number {
  let sum = 0;
  for (let i = axis; i < values.length; i += 3) sum += values[i]!;
  return sum / (values.length / 3);
}
