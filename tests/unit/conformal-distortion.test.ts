/** The conformal distortion of faces between two poses. */
import { expect, it } from 'vitest';
import { conformalDistortion } from '../../web/study/conformal-distortion.ts';

/** Two faces of a unit square, of which the third corner is moved. */
const faces = Uint32Array.of(0, 1, 2, 0, 2, 3);
const square = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
const mapped = (to: (x: number, y: number) => number[]): Float32Array =>
  Float32Array.from([0, 1, 2, 3].flatMap((v) => to(square[3 * v]!, square[3 * v + 1]!)));

it('is 0 for similar faces, and that of the singular values otherwise', () => {
  const turned = mapped((x, y) => [5 - 2 * y, 3, 2 * x]);
  expect(conformalDistortion(faces, square, turned)).toBeCloseTo(0, 6);
  // Singular values 3 and 1: (9 + 1) / 3 - 2.
  expect(
    conformalDistortion(
      faces,
      square,
      mapped((x, y) => [3 * x, 0, y]),
    ),
  ).toBeCloseTo(4 / 3, 6);
  // A shear by 1: tr A'A = 3, det A = 1.
  expect(
    conformalDistortion(
      faces,
      square,
      mapped((x, y) => [x + y, y, 0]),
    ),
  ).toBeCloseTo(1, 6);
});

it('leaves out faces without area', () => {
  const folded = Float32Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0);
  const [sheared] = [conformalDistortion(faces.slice(3), square, folded)];
  expect(conformalDistortion(faces, square, folded)).toBeCloseTo(sheared, 9);
  expect(conformalDistortion(faces.slice(0, 3), square, folded)).toBeNaN();
});
