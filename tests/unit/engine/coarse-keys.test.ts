/** Fewer faces for shapes that are only approximate. */
import { describe, expect, it } from 'vitest';
import { coarseMesh, coarsePositions } from '../../../web/engine/caller/coarse-keys.ts';

/** A square sheet of n x n quads in the plane z = 0, or as `place` has it. */
function sheet(n: number, place = (x: number, y: number): [number, number, number] => [x, y, 0]) {
  const positions: number[] = [];
  const faces: number[] = [];
  for (let j = 0; j <= n; j += 1) for (let i = 0; i <= n; i += 1) positions.push(...place(i / n, j / n));
  for (let j = 0; j < n; j += 1) {
    for (let i = 0; i < n; i += 1) {
      const a = j * (n + 1) + i;
      faces.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  return { positions: Float32Array.from(positions), faces: Uint32Array.from(faces) };
}

function area(p: Float32Array, faces: Uint32Array): number {
  let sum = 0;
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f]!, 3 * faces[f + 1]!, 3 * faces[f + 2]!];
    sum += ((p[b]! - p[a]!) * (p[c + 1]! - p[a + 1]!) - (p[c]! - p[a]!) * (p[b + 1]! - p[a + 1]!)) / 2;
  }
  return sum;
}

describe('a coarse mesh', () => {
  it('covers the shape with a fraction of its faces, turned the same way', () => {
    const { positions, faces } = sheet(400);
    const mesh = coarseMesh([positions], faces);
    expect(mesh.faces.length).toBeLessThan(faces.length / 20);
    const coarse = coarsePositions(mesh, positions);
    expect(coarse).toHaveLength(3 * mesh.vertices.length);
    expect(Math.max(...mesh.faces)).toBeLessThan(mesh.vertices.length);
    // A cell is lost at most along two of the sides.
    expect(area(coarse, mesh.faces)).toBeGreaterThan(0.93);
    expect(area(coarse, mesh.faces)).toBeLessThanOrEqual(1 + 1e-6);
  });

  it('keeps small meshes as they are', () => {
    const { positions, faces } = sheet(20);
    const mesh = coarseMesh([positions], faces);
    expect(coarsePositions(mesh, positions)).toEqual(positions);
    const turned = (corners: Uint32Array): string[] =>
      Array.from({ length: corners.length / 3 }, (_, f) => {
        const [a, b, c] = corners.slice(3 * f, 3 * f + 3) as unknown as [number, number, number];
        return (a < b && a < c ? [a, b, c] : b < c ? [b, c, a] : [c, a, b]).join();
      }).sort();
    expect(turned(mesh.faces)).toEqual(turned(faces));
  });

  it('has each face once, and turns hardly any over', () => {
    const { positions, faces } = sheet(400, (x, y) => [x, y, 0.1 * Math.sin(9 * x) * Math.cos(7 * y)]);
    const mesh = coarseMesh([positions], faces);
    const triples = Array.from({ length: mesh.faces.length / 3 }, (_, f) => mesh.faces.slice(3 * f, 3 * f + 3).sort());
    expect(new Set(triples.map(String)).size).toBe(triples.length);
    const coarse = coarsePositions(mesh, positions);
    const over = triples.filter((_, f) => area(coarse, mesh.faces.subarray(3 * f, 3 * f + 3)) <= 0);
    expect(over.length).toBeLessThan(0.01 * triples.length);
  });

  it('keeps apart what is together in one pose only', () => {
    const closed = sheet(200, (x, y) => [Math.min(x, 1 - x), y, 0]);
    const open = sheet(200);
    const folded = coarseMesh([closed.positions], closed.faces);
    const both = coarseMesh([closed.positions, open.positions], closed.faces);
    expect(both.vertices.length).toBeGreaterThan(1.7 * folded.vertices.length);
    const coarse = coarsePositions(both, open.positions);
    const longest = Math.max(
      ...Array.from(both.faces, (v, i) => {
        const next = both.faces[i % 3 === 2 ? i - 2 : i + 1]!;
        return Math.hypot(coarse[3 * v]! - coarse[3 * next]!, coarse[3 * v + 1]! - coarse[3 * next + 1]!);
      }),
    );
    expect(longest).toBeLessThan(0.06);
  });
});
