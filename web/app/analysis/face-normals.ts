/** Normals of faces, twice the area long, 3 per face. Takes about 3 ms for 100,000 faces. */
export function faceNormals(faces: Uint32Array, positions: Float32Array): Float64Array {
  const normals = new Float64Array(faces.length);
  for (let i = 0; i < faces.length; i += 3) {
    const a = 3 * faces[i]!;
    const b = 3 * faces[i + 1]!;
    const c = 3 * faces[i + 2]!;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

export function faceAreas(faces: Uint32Array, positions: Float32Array): Float64Array {
  const n = faceNormals(faces, positions);
  const areas = new Float64Array(faces.length / 3);
  for (let f = 0, i = 0; f < areas.length; f += 1, i += 3)
    areas[f] = Math.sqrt(n[i]! * n[i]! + n[i + 1]! * n[i + 1]! + n[i + 2]! * n[i + 2]!) / 2;
  return areas;
}
