import { expect, it } from 'vitest';
import { pickFace } from '../../web/app/drawing/pick-face.ts';

/** Two squares perpendicular to the view, one behind the other. */
const square = (z: number): number[] => [-1, -1, z, 1, -1, z, 1, 1, z, -1, 1, z];
const positions = Float32Array.from([...square(0), ...square(-2)]);
const faces = Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7);
const from = (x: number, y: number, z: number, down = -1) => ({
  origin: [x, y, z] as const,
  direction: [0, 0, down] as const,
});

it('the nearest face is hit, from either side, and none next to the shape', () => {
  expect(pickFace(positions, faces, from(0.5, -0.5, 5))).toBe(0);
  expect(pickFace(positions, faces, from(-0.5, 0.5, 5))).toBe(1);
  expect(pickFace(positions, faces, from(0.5, -0.5, -1))).toBe(2);
  expect(pickFace(positions, faces, from(0.5, -0.5, -5, 1))).toBe(2);
  expect(pickFace(positions, faces, from(3, 0, 5))).toBe(-1);
});
