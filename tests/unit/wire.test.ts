/** The edges shown by a wireframe. */
import { describe, expect, it } from 'vitest';
import { edgesOf } from '../../web/viewer/wire.ts';

const named = (edges: Uint32Array): string[] =>
  Array.from({ length: edges.length / 2 }, (_, i) =>
    [edges[2 * i]!, edges[2 * i + 1]!].sort((a, b) => a - b).join('-'),
  ).sort();

describe('edges of polygons', () => {
  it('are those of the faces if all are triangles', () => {
    expect(named(edgesOf([0, 1, 2, 0, 2, 3], null))).toEqual(['0-1', '0-2', '0-2', '0-3', '1-2', '2-3']);
  });

  it('omit the diagonal of a quad, and keep the edge between two polygons', () => {
    // A quad of two faces beside a triangle, and a pentagon of three.
    const faces = [0, 1, 2, 0, 2, 3, 3, 2, 4, 5, 6, 7, 5, 7, 8, 5, 8, 9];
    expect(named(edgesOf(faces, Int32Array.of(2, 1, 3)))).toEqual(
      ['0-1', '1-2', '2-3', '0-3', '2-3', '2-4', '3-4', '5-6', '6-7', '7-8', '8-9', '5-9'].sort(),
    );
  });
});
