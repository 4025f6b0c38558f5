/** Whether a camera is inside the shape. */
import { expect, test } from 'vitest';
import { isInside } from '../../web/model/camera.ts';

// A cube of side 2 about the origin.
const CORNERS = Float32Array.from(
  [0, 1, 2, 3, 4, 5, 6, 7].flatMap((c) => [c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1]),
);
const QUADS = [
  [0, 4, 6, 2],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 2, 3, 1],
  [4, 5, 7, 6],
] as const;
const FACES = Uint32Array.from(QUADS.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]));

test('points in a cube are inside, points next to it are not', () => {
  expect(isInside([0.9, -0.9, 0.5], CORNERS, FACES)).toBe(true);
  expect(isInside([1.1, 0, 0], CORNERS, FACES)).toBe(false);
  expect(isInside([0, 30, 0], CORNERS, FACES)).toBe(false);
});

test('a cube with an open side still has an inside', () => {
  const open = FACES.slice(6);
  expect(isInside([0.2, 0, 0], CORNERS, open)).toBe(true);
  expect(isInside([-3, 0, 0], CORNERS, open)).toBe(false);
});
