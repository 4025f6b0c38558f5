/**
 * Volume and area of a frame that is on the page already, so that it is not evaluated again. `wasm/core/mesh/measures`,
 * which serves `Sequence.measures`, defines them alike.
 */

export interface Measure {
  volume: number;
  area: number;
}

/** Signed volume and surface area. The volume of an open surface is that of the cone to the first vertex. */
export function measure(positions: Float32Array, indices: Uint32Array): Measure {
  let volume = 0;
  let area = 0;
  const [ox, oy, oz] = [positions[0]!, positions[1]!, positions[2]!];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i]!, 3 * indices[i + 1]!, 3 * indices[i + 2]!];
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [bx, by, bz] = [positions[b]! - ax, positions[b + 1]! - ay, positions[b + 2]! - az];
    const [cx, cy, cz] = [positions[c]! - ax, positions[c + 1]! - ay, positions[c + 2]! - az];
    const [nx, ny, nz] = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
    volume += ((ax - ox) * nx + (ay - oy) * ny + (az - oz) * nz) / 6;
    area += Math.hypot(nx, ny, nz) / 2;
  }
  return { volume, area };
}
