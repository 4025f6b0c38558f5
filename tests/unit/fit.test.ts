/** What a fitted view shows of a shape and of the ring around it. */
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { ViewName } from '../../web/model/camera.ts';
import { FIELD_OF_VIEW, directionOf, fittedPose, setLens } from '../../web/viewer/fit.ts';
import type { Extent } from '../../web/viewer/fit.ts';
import { ringAround } from '../../web/viewer/stage.ts';

const [min, max]: [number, number, number][] = [
  [-1, 0, -1],
  [1, 3, 1],
];
// A mushroom: it fills its box at the top alone.
const points = Float32Array.from([0, 0, 0, ...[0, 1, 2, 3].flatMap((c) => [c & 1 || -1, 3, c & 2 ? 1 : -1])]);
const around = ringAround({ min: min!, max: max! });
const ASPECT = 2;
const INSETS = { top: 0, bottom: 0.1 };

/** The lowest place in the view, fitted to `extent`, from -1 at its lower edge. */
function lowest(view: ViewName, extent: Extent, of: Float32Array): number {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW);
  camera.aspect = ASPECT;
  const { position, target } = fittedPose(directionOf(view), extent, ASPECT, INSETS);
  camera.position.fromArray(position);
  camera.lookAt(new Vector3(...target));
  setLens(camera, new Vector3(...target), extent.radius, ASPECT, INSETS);
  const heights = Array.from({ length: of.length / 3 }, (_, i) => new Vector3().fromArray(of, 3 * i).project(camera).y);
  return Math.min(...heights);
}

it('the ring is not cut at the lower edge, where covering buttons may lie over it', () => {
  const shape = { points, radius: 1.5 };
  expect(lowest('home', shape, around)).toBeLessThan(-1);
  const low = lowest('home', { ...shape, around }, around);
  expect(low).toBeGreaterThan(-1);
  expect(low).toBeLessThan(-0.9);
  expect(lowest('home', { ...shape, around }, points)).toBeGreaterThan(lowest('home', shape, points));
});

it('from above a shape is as large as without the ring', () => {
  const shape = { points, radius: 1.5 };
  expect(lowest('top', { ...shape, around }, points)).toBe(lowest('top', shape, points));
});
