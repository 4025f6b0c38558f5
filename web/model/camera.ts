/** Poses of the camera, and a test whether a point is inside a shape. */

export interface CameraPose {
  position: [number, number, number];
  target: [number, number, number];
}

/** The standard views. */
export type ViewName = 'home' | 'front' | 'top' | 'right';

/**
 * Whether a point lies inside the surface, by its generalized winding number (Jacobson et al. 2013): the solid angle of
 * all faces, close to one inside despite holes. Avoids `Math.hypot`, which is slower. `positions`: xyz, V x 3; `faces`:
 * F x 3.
 */
export function isInside(point: CameraPose['position'], positions: Float32Array, faces: Uint32Array): boolean {
  const [x, y, z] = point;
  let sum = 0;
  for (let f = 0; f < faces.length; f += 3) {
    const a = 3 * faces[f]!;
    const b = 3 * faces[f + 1]!;
    const c = 3 * faces[f + 2]!;
    const ax = positions[a]! - x;
    const ay = positions[a + 1]! - y;
    const az = positions[a + 2]! - z;
    const bx = positions[b]! - x;
    const by = positions[b + 1]! - y;
    const bz = positions[b + 2]! - z;
    const cx = positions[c]! - x;
    const cy = positions[c + 1]! - y;
    const cz = positions[c + 2]! - z;
    const la = Math.sqrt(ax * ax + ay * ay + az * az);
    const lb = Math.sqrt(bx * bx + by * by + bz * bz);
    const lc = Math.sqrt(cx * cx + cy * cy + cz * cz);
    const volume = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    const ab = ax * bx + ay * by + az * bz;
    const bc = bx * cx + by * cy + bz * cz;
    const ca = cx * ax + cy * ay + cz * az;
    sum += Math.atan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb);
  }
  return Math.abs(sum) > Math.PI;
}
