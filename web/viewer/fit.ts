/** Camera pose that shows a whole shape, and the camera's lens. */
import { PerspectiveCamera, Vector3 } from 'three';
import type { CameraPose, ViewName } from '../model/camera.ts';

export const FIELD_OF_VIEW = 32;
const MARGIN = 1.12;

const DIRECTIONS: Record<ViewName, [number, number, number]> = {
  home: [0.55, 0.32, 1],
  front: [0, 0, 1],
  right: [1, 0, 0],
  top: [0, 1, 1e-4],
};

export const directionOf = (view: ViewName): Vector3 => new Vector3(...DIRECTIONS[view]).normalize();

/** The extent that a fitted view must show. */
export interface Extent {
  /** A sample of the vertices, xyz interleaved. */
  points: Float32Array;
  /** Radius of the box, always positive. */
  radius: number;
}

/** Shares of a view's height that other elements cover. A fitted shape is placed between them. */
export interface Insets {
  top: number;
  bottom: number;
}

export const NO_INSETS: Readonly<Insets> = { top: 0, bottom: 0 };

/** The closest eye position along a unit direction that sees every point. */
export function fittedPose(direction: Vector3, { points, radius }: Extent, aspect: number, insets: Insets): CameraPose {
  const eye = new PerspectiveCamera();
  eye.position.copy(direction);
  eye.lookAt(0, 0, 0);
  eye.updateMatrix();
  const right = new Vector3().setFromMatrixColumn(eye.matrix, 0);
  const up = new Vector3().setFromMatrixColumn(eye.matrix, 1);
  const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / MARGIN;
  const vertical = half * (1 - insets.top - insets.bottom);
  const horizontal = half * aspect;
  const target = new Vector3()
    .addScaledVector(right, middle(points, right))
    .addScaledVector(up, middle(points, up))
    .addScaledVector(direction, middle(points, direction));
  let distance = 0.1 * radius;
  const point = new Vector3();
  for (let i = 0; i + 2 < points.length; i += 3) {
    point.fromArray(points, i).sub(target);
    const depth = point.dot(direction);
    distance = Math.max(
      distance,
      depth + Math.abs(point.dot(right)) / horizontal,
      depth + Math.abs(point.dot(up)) / vertical,
    );
  }
  return { position: target.clone().addScaledVector(direction, distance).toArray(), target: target.toArray() };
}

/** Sets the parameters that depend on the view size and the distance to the target; call before drawing. */
export function setLens(
  camera: PerspectiveCamera,
  target: Vector3,
  radius: number,
  aspect: number,
  { top, bottom }: Insets,
): void {
  const distance = camera.position.distanceTo(target);
  // Shifts the lens, as in architectural photography, so the centre of rotation stays the middle of the shape.
  camera.setViewOffset(aspect, 1, 0, (bottom - top) / 2, aspect, 1);
  camera.near = Math.max(distance - 12 * radius, 0.01 * radius, distance * 1e-3);
  camera.far = distance + 24 * radius;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

function middle(points: Float32Array, axis: Vector3): number {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const value = points[i]! * axis.x + points[i + 1]! * axis.y + points[i + 2]! * axis.z;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return (low + high) / 2;
}
