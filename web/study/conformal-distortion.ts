/** How far faces are from a similar shape in another pose. */

/**
 * The mean over the faces of tr A'A / det A - 2, weighted by their areas at rest: 0 for similar faces. A: the 2 x 2
 * gradient of a face from rest to shape. Faces without area in either pose are left out. All arrays: 3 x vertices, or
 * 3 x faces.
 */
export function conformalDistortion(faces: Uint32Array, rest: Float32Array, shape: Float32Array): number {
  let [sum, total] = [0, 0];
  for (let f = 0; f < faces.length; f += 3) {
    const corners = faces.subarray(f, f + 3);
    const [a, b, c] = gram(rest, corners);
    const [p, q, r] = gram(shape, corners);
    const [squared, changed] = [a * c - b * b, p * r - q * q];
    if (!(squared > 0 && changed > 0)) continue;
    const area = Math.sqrt(squared);
    sum += area * ((c * p - 2 * b * q + a * r) / (area * Math.sqrt(changed)) - 2);
    total += area;
  }
  return sum / total;
}

/** The products of two edges from the first corner: u u, u v, v v. */
function gram(positions: Float32Array, corners: Uint32Array): [uu: number, uv: number, vv: number] {
  let [uu, uv, vv] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis += 1) {
    const [o, p, q] = [0, 1, 2].map((corner) => positions[3 * corners[corner]! + axis]!);
    uu += (p! - o!) ** 2;
    uv += (p! - o!) * (q! - o!);
    vv += (q! - o!) ** 2;
  }
  return [uu, uv, vv];
}
