import { describe, expect, it } from 'vitest';
import { extentOf } from '../../web/viewer/bounds.ts';
import { measure } from '../../web/app/drawing/measures.ts';
import { patchColours } from '../../web/viewer/patch-colours.ts';
import { tiles } from '../../web/viewer/tiles.ts';

/** A tetrahedron on the unit axes. */
const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const indices = Uint32Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);

describe('measures on the page', () => {
  it('are correct for a tetrahedron', () => {
    const { volume, area } = measure(positions, indices);
    expect(volume).toBeCloseTo(1 / 6, 6);
    expect(area).toBeCloseTo(1.5 + Math.sqrt(3) / 2, 6);
  });

  it('do not depend on the position of the shape', () => {
    const moved = positions.map((value, index) => value + [5, -3, 8][index % 3]!);
    expect(measure(moved, indices).volume).toBeCloseTo(1 / 6, 4);
  });

  it('find the box around several poses', () => {
    const { bounds } = extentOf([positions, positions.map((value) => -2 * value)]);
    expect(bounds).toMatchObject({ min: [-2, -2, -2], max: [1, 1, 1] });
  });

  it('put the ring around the parts that touch the floor, not around parts above it', () => {
    const leaning = Float32Array.from([3, 0, 4, 5, 0, 4, 4, 0.01, 5, 9, 1, 9]);
    expect(extentOf([leaning]).bounds.foot).toEqual({ x: 4, z: 4.5, radius: Math.hypot(1, 0.5) });
  });

  it('keep the extreme vertices in a sample', () => {
    const many = new Float32Array(3 * 10_000);
    many.set([9, 0, 0], 3 * 7777);
    expect(Math.max(...extentOf([many]).points)).toBe(9);
  });

  it('colour every vertex of a patch alike and different patches differently', () => {
    const colours = patchColours(Int32Array.from([0, 1]), Uint32Array.from([0, 1, 2, 3, 4, 5]), 7);
    const at = (vertex: number): number[] => [...colours.subarray(3 * vertex, 3 * vertex + 3)];
    expect(at(0)).toEqual(at(2));
    expect(at(0)).not.toEqual(at(3));
    expect(at(6)).toEqual(at(6));
  });
});

describe('tiles', () => {
  it('share the canvas without gap or overlap', () => {
    for (const [count, width, height] of [
      [1, 300, 200],
      [2, 900, 400],
      [2, 300, 700],
      [3, 1200, 400],
      [4, 800, 600],
    ] as const) {
      const rects = tiles(count, width, height);
      expect(rects).toHaveLength(count);
      expect(rects.reduce((sum, rect) => sum + rect.width * rect.height, 0)).toBeCloseTo(width * height, 6);
    }
  });

  it('are side by side on a wide canvas and above each other on a tall one', () => {
    expect(tiles(2, 900, 400).map((rect) => rect.y)).toEqual([0, 0]);
    // Film strips are wide.
    expect(tiles(2, 900, 400, 6).map((rect) => rect.x)).toEqual([0, 0]);
    expect(tiles(2, 300, 700).map((rect) => rect.x)).toEqual([0, 0]);
  });
});
