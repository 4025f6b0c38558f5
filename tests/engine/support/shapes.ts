/** Generated meshes with exactly known motions. */

export interface Mesh {
  /** Positions, 3 x vertices. */
  positions: Float32Array;
  /** Vertex indices, 3 x faces. */
  indices: Uint32Array;
}

type Point = [number, number, number];

/** A closed box, 1 x 1 x length, n x n x m cells, welded; z runs along it from 0. */
export function bar(n = 2, m = 20, length = 10): Mesh {
  const points: Point[] = [];
  const index = new Map<string, number>();
  const vertex = (i: number, j: number, k: number): number => {
    const name = `${i},${j},${k}`;
    const known = index.get(name);
    if (known !== undefined) return known;
    index.set(name, points.length);
    return points.push([i / n - 0.5, j / n - 0.5, (length * k) / m]) - 1;
  };
  const faces: number[] = [];
  const quad = (a: number, b: number, c: number, d: number): void => void faces.push(a, b, c, a, c, d);
  for (let i = 0; i < n; ++i) {
    for (let k = 0; k < m; ++k) {
      quad(vertex(i, 0, k), vertex(i + 1, 0, k), vertex(i + 1, 0, k + 1), vertex(i, 0, k + 1));
      quad(vertex(i, n, k + 1), vertex(i + 1, n, k + 1), vertex(i + 1, n, k), vertex(i, n, k));
      quad(vertex(0, i, k + 1), vertex(0, i + 1, k + 1), vertex(0, i + 1, k), vertex(0, i, k));
      quad(vertex(n, i, k), vertex(n, i + 1, k), vertex(n, i + 1, k + 1), vertex(n, i, k + 1));
    }
    for (let j = 0; j < n; ++j) {
      quad(vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0), vertex(i, j, 0));
      quad(vertex(i, j, m), vertex(i + 1, j, m), vertex(i + 1, j + 1, m), vertex(i, j + 1, m));
    }
  }
  return { positions: Float32Array.from(points.flat()), indices: Uint32Array.from(faces) };
}

export function moved({ positions }: Mesh, move: (x: number, y: number, z: number) => Point): Float32Array {
  const result = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3)
    result.set(move(positions[i]!, positions[i + 1]!, positions[i + 2]!), i);
  return result;
}

/** Bent along an arc in the y-z plane; the centre line keeps its length. */
export function bent(mesh: Mesh, degrees: number, length = 10): Float32Array {
  const angle = (degrees * Math.PI) / 180;
  if (angle === 0) return mesh.positions.slice();
  const radius = length / angle;
  return moved(mesh, (x, y, z) => {
    const a = (z / length) * angle;
    return [x, radius - (radius - y) * Math.cos(a), (radius - y) * Math.sin(a)];
  });
}

export function diagonal(positions: Float32Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3]!, value);
    high[i % 3] = Math.max(high[i % 3]!, value);
  });
  return Math.hypot(...low.map((l, i) => high[i]! - l));
}

/** The largest distance between corresponding vertices. */
export function largestDistance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  for (let i = 0; i < a.length; i += 3) {
    const distance = Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!);
    if (!(distance <= largest)) largest = distance;
  }
  return largest;
}

/** A square sheet of n x n cells, rolled up along two directions by an angle over its side: isometric poses. */
export function rolledSheet(n: number, angle: number): { faces: Uint32Array; poses: Float32Array[] } {
  const faces: number[] = [];
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i) {
      const a = j * (n + 1) + i;
      faces.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  const rolled = (direction: number): Float32Array => {
    const [c, s] = [Math.cos(direction), Math.sin(direction)];
    const points: number[] = [];
    for (let j = 0; j <= n; ++j)
      for (let i = 0; i <= n; ++i) {
        const arc = ((c * i + s * j) / n) * angle;
        const across = (c * j - s * i) / n;
        const along = Math.sin(arc) / angle;
        points.push(c * along - s * across, s * along + c * across, (1 - Math.cos(arc)) / angle);
      }
    return Float32Array.from(points);
  };
  return { faces: Uint32Array.from(faces), poses: [rolled(0.3), rolled(0.3 + Math.PI / 2)] };
}

/** The same poses with separate vertices for every face, as flat shaded files have them. */
export function split(
  faces: Uint32Array,
  poses: readonly Float32Array[],
): { faces: Uint32Array; poses: Float32Array[] } {
  const apart = (pose: Float32Array): Float32Array =>
    Float32Array.from({ length: 3 * faces.length }, (_, i) => pose[3 * faces[Math.floor(i / 3)]! + (i % 3)]!);
  return { faces: faces.map((_, i) => i), poses: poses.map(apart) };
}

/** The walls of n x n x n cubes in a unit cube. Inside, all vertices are junctions, which simplification keeps. */
export function foam(n: number): Mesh {
  const at = (place: number[]): number => place[0]! + (n + 1) * (place[1]! + (n + 1) * place[2]!);
  const positions: number[] = [];
  const faces: number[] = [];
  for (let z = 0; z <= n; ++z)
    for (let y = 0; y <= n; ++y)
      for (let x = 0; x <= n; ++x) {
        positions.push(x / n, y / n, z / n);
        const corner = (...steps: number[]): number[] => [x, y, z].map((one, axis) => one + steps[axis]!);
        for (const [u, v] of [
          [corner(1, 0, 0), corner(0, 1, 0)],
          [corner(0, 1, 0), corner(0, 0, 1)],
          [corner(0, 0, 1), corner(1, 0, 0)],
        ] as const) {
          const opposite = u.map((one, axis) => one + v[axis]! - [x, y, z][axis]!);
          if (Math.max(...opposite) > n) continue;
          faces.push(at([x, y, z]), at(u), at(opposite), at([x, y, z]), at(opposite), at(v));
        }
      }
  return { indices: Uint32Array.from(faces), positions: Float32Array.from(positions) };
}
