/** Rotation vectors: axis times angle in radians. */

/** A unit quaternion w, x, y, z. */
export type Quaternion = readonly [number, number, number, number];
export type Vector = [number, number, number];

/** The rotation vector log(a^-1 b), of at most 180 degrees. */
export function rotationVector([a, b, c, d]: Quaternion, [w, x, y, z]: Quaternion): Vector {
  const real = a * w + b * x + c * y + d * z;
  const sign = real < 0 ? -1 : 1;
  const imaginary: Vector = [
    sign * (a * x - b * w - c * z + d * y),
    sign * (a * y - c * w - d * x + b * z),
    sign * (a * z - d * w - b * y + c * x),
  ];
  const length = Math.hypot(...imaginary);
  const factor = length < 1e-12 ? 2 : (2 * Math.atan2(length, Math.abs(real))) / length;
  return imaginary.map((part) => part * factor) as Vector;
}

/** Adds whole turns to make each vector as close as possible to the previous one. */
export function unwound(vectors: readonly Vector[]): Vector[] {
  let last: Vector = [0, 0, 0];
  return vectors.map((vector) => {
    const angle = Math.hypot(...vector);
    const axis = angle < 1e-9 ? [0, 0, 0] : vector.map((part) => part / angle);
    const along = axis.reduce((sum, part, i) => sum + part * last[i]!, 0);
    const turns = Math.round((along - angle) / (2 * Math.PI));
    last = axis.map((part) => part * (angle + 2 * Math.PI * turns)) as Vector;
    return last;
  });
}
