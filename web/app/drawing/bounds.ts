/** What the view needs to know of the poses: their box, a sample of points to fit, and colours for patches. */
import type { Bounds } from '../../viewer/stage.ts';

/** Enough to fit a view tightly, few enough to go through at once. */
const POINTS_PER_POSE = 1500;

/**
 * What a view has to show: the box, and some vertices of every pose, xyz interleaved, the extreme ones along each axis
 * among them.
 */
export interface Extent {
  bounds: Bounds;
  points: Float32Array;
}

export function extentOf(poses: Iterable<Float32Array>): Extent {
  const min: Bounds['min'] = [Infinity, Infinity, Infinity];
  const max: Bounds['max'] = [-Infinity, -Infinity, -Infinity];
  const points: number[] = [];
  for (const positions of poses) {
    const vertices = positions.length / 3;
    const step = Math.max(1, Math.floor(vertices / POINTS_PER_POSE));
    for (let v = 0; v < vertices; v += step) push(points, positions, v);
    for (const [index, v] of extremes(positions).entries()) {
      push(points, positions, v);
      const axis = Math.floor(index / 2) as 0 | 1 | 2;
      min[axis] = Math.min(min[axis], positions[3 * v + axis]!);
      max[axis] = Math.max(max[axis], positions[3 * v + axis]!);
    }
  }
  return { bounds: { min, max }, points: Float32Array.from(points) };
}

function push(points: number[], positions: Float32Array, vertex: number): void {
  points.push(positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!);
}

function extremes(positions: Float32Array): number[] {
  const found = [0, 0, 0, 0, 0, 0];
  for (let v = 0; v < positions.length / 3; v += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const value = positions[3 * v + axis]!;
      if (value < positions[3 * found[2 * axis]! + axis]!) found[2 * axis] = v;
      if (value > positions[3 * found[2 * axis + 1]! + axis]!) found[2 * axis + 1] = v;
    }
  }
  return found;
}

/** One colour per patch, neighbours in number far apart in hue; a vertex takes that of one of its faces. Linear RGB. */
export function patchColours(patches: Int32Array, indices: Uint32Array, vertices: number): Float32Array {
  const colours = new Float32Array(3 * vertices).fill(0.2);
  patches.forEach((patch, face) => {
    if (patch < 0) return;
    const colour = hueColour(patch);
    for (let corner = 0; corner < 3; corner += 1) colours.set(colour, 3 * indices[3 * face + corner]!);
  });
  return colours;
}

/** The golden angle spreads any number of hues; lightness and strength vary so that neighbours differ in grey too. */
function hueColour(index: number): [number, number, number] {
  const hue = (index * 137.508) % 360;
  const lightness = 0.5 + 0.14 * ((index % 3) - 1);
  const channel = (offset: number): number => {
    const k = (offset + hue / 30) % 12;
    const strength = 0.45 * Math.min(lightness, 1 - lightness);
    return (lightness - strength * Math.max(-1, Math.min(k - 3, 9 - k, 1))) ** 2.2;
  };
  return [channel(0), channel(8), channel(4)];
}

export interface Measure {
  volume: number;
  area: number;
}

/** Signed volume and surface area of one shape; for an open surface the volume is that of the cone to the origin. */
export function measure(positions: Float32Array, indices: Uint32Array): Measure {
  let volume = 0;
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i]!, 3 * indices[i + 1]!, 3 * indices[i + 2]!];
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [bx, by, bz] = [positions[b]! - ax, positions[b + 1]! - ay, positions[b + 2]! - az];
    const [cx, cy, cz] = [positions[c]! - ax, positions[c + 1]! - ay, positions[c + 2]! - az];
    const [nx, ny, nz] = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
    volume += (ax * nx + ay * ny + az * nz) / 6;
    area += Math.hypot(nx, ny, nz) / 2;
  }
  return { volume, area };
}
