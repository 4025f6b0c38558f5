/** The one camera of all views: orbit, pan, zoom, and standard views fitted tightly to the shape. */
import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraPose, ViewName } from '../model/camera.ts';

const FIELD_OF_VIEW = 32;
const MARGIN = 1.12;
const TURN_MS = 180;

const DIRECTIONS: Record<ViewName, [number, number, number]> = {
  home: [0.55, 0.32, 1],
  front: [0, 0, 1],
  right: [1, 0, 0],
  top: [0, 1, 1e-4],
};

/** Shares of a view's height that other things cover: a fitted shape stands between them. */
export interface Insets {
  top: number;
  bottom: number;
}

export const NO_INSETS: Readonly<Insets> = { top: 0, bottom: 0 };

export class CameraRig {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private points: Float32Array = new Float32Array([-1, -1, -1, 1, 1, 1]);
  private radius = 1;
  private aspect = 1;
  private insets: Insets = NO_INSETS;
  private turn = 0;

  constructor(
    element: HTMLElement,
    private readonly onChange: () => void,
    private readonly onUserMove: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', this.onChange);
    this.controls.addEventListener('start', () => this.stopTurning());
    this.controls.addEventListener('end', this.onUserMove);
    this.look(DIRECTIONS.home);
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  /** Points that a fitted view must show, xyz interleaved: a sample of the vertices of all keys. */
  setPoints(points: Float32Array, radius: number): void {
    this.points = points;
    this.radius = Math.max(radius, 1e-6);
    this.controls.minDistance = 0.02 * this.radius;
    this.controls.maxDistance = 60 * this.radius;
  }

  extent(): { points: Float32Array; radius: number } {
    return { points: this.points, radius: this.radius };
  }

  /** Where a fitted view would stand, without going there. */
  fittedPose(view: ViewName): CameraPose {
    return this.fitted(new Vector3(...DIRECTIONS[view]).normalize());
  }

  setAspect(aspect: number): void {
    this.aspect = aspect;
  }

  /** The picture as a whole moves to the middle of what is left; nothing turns. Returns the insets before. */
  setInsets(insets: Insets): Insets {
    const before = this.insets;
    this.insets = insets;
    return before;
  }

  pose(): CameraPose {
    return { position: this.camera.position.toArray(), target: this.target.toArray() };
  }

  setPose(pose: CameraPose): void {
    this.stopTurning();
    this.camera.position.fromArray(pose.position);
    this.target.fromArray(pose.target);
    this.controls.update();
    this.onChange();
  }

  /** Looks from a standard direction, or from where it stands now, at the whole shape. */
  fit(view: ViewName | null, eased: boolean): void {
    const direction = view ? new Vector3(...DIRECTIONS[view]) : this.camera.position.clone().sub(this.target);
    const pose = this.fitted(direction.normalize());
    if (eased) return this.turnTo(pose);
    this.setPose(pose);
    this.onUserMove();
  }

  /** Turns about the target by angles in radians; from the keyboard. */
  orbit(horizontal: number, vertical: number): void {
    const offset = new Spherical().setFromVector3(this.camera.position.clone().sub(this.target));
    offset.theta -= horizontal;
    offset.phi = Math.min(Math.max(offset.phi - vertical, 0.01), Math.PI - 0.01);
    this.moveTo(new Vector3().setFromSpherical(offset).add(this.target));
  }

  zoom(factor: number): void {
    this.moveTo(this.camera.position.clone().sub(this.target).multiplyScalar(factor).add(this.target));
  }

  /** Moves eye and target by shares of the shape's size. */
  pan(right: number, up: number): void {
    const shift = new Vector3()
      .setFromMatrixColumn(this.camera.matrix, 0)
      .multiplyScalar(right * this.radius)
      .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * this.radius);
    this.target.add(shift);
    this.moveTo(this.camera.position.clone().add(shift));
  }

  /** Sets what depends on the size of the view and the distance; call before drawing. */
  prepare(aspect: number): void {
    const distance = this.camera.position.distanceTo(this.target);
    const { top, bottom } = this.insets;
    // The lens is shifted, as architects do it: the point that is turned about stays the middle of the shape.
    this.camera.setViewOffset(aspect, 1, 0, (bottom - top) / 2, aspect, 1);
    this.camera.near = Math.max(distance - 12 * this.radius, 0.01 * this.radius, distance * 1e-3);
    this.camera.far = distance + 24 * this.radius;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  dispose(): void {
    this.stopTurning();
    this.controls.dispose();
  }

  private look(direction: readonly [number, number, number]): void {
    this.setPose(this.fitted(new Vector3(...direction).normalize()));
  }

  private moveTo(position: Vector3): void {
    this.stopTurning();
    this.camera.position.copy(position);
    this.controls.update();
    this.onUserMove();
  }

  /** The nearest eye along a direction from which every point is in the picture. */
  private fitted(direction: Vector3): CameraPose {
    const eye = new PerspectiveCamera();
    eye.position.copy(direction);
    eye.lookAt(0, 0, 0);
    eye.updateMatrix();
    const right = new Vector3().setFromMatrixColumn(eye.matrix, 0);
    const up = new Vector3().setFromMatrixColumn(eye.matrix, 1);
    const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / MARGIN;
    const vertical = half * (1 - this.insets.top - this.insets.bottom);
    const horizontal = half * this.aspect;
    const x = extent(this.points, right);
    const y = extent(this.points, up);
    const z = extent(this.points, direction);
    const target = new Vector3()
      .addScaledVector(right, mid(x))
      .addScaledVector(up, mid(y))
      .addScaledVector(direction, mid(z));
    let distance = 0.1 * this.radius;
    const point = new Vector3();
    for (let i = 0; i + 2 < this.points.length; i += 3) {
      point.fromArray(this.points, i).sub(target);
      const depth = point.dot(direction);
      distance = Math.max(
        distance,
        depth + Math.abs(point.dot(right)) / horizontal,
        depth + Math.abs(point.dot(up)) / vertical,
      );
    }
    return { position: target.clone().addScaledVector(direction, distance).toArray(), target: target.toArray() };
  }

  private turnTo(pose: CameraPose): void {
    this.stopTurning();
    const from = new Spherical().setFromVector3(this.camera.position.clone().sub(this.target));
    const fromTarget = this.target.clone();
    const toTarget = new Vector3(...pose.target);
    const to = new Spherical().setFromVector3(new Vector3(...pose.position).sub(toTarget));
    const turn = Math.atan2(Math.sin(to.theta - from.theta), Math.cos(to.theta - from.theta));
    const start = performance.now();
    const step = (): void => {
      const share = Math.min((performance.now() - start) / TURN_MS, 1);
      const eased = share * share * (3 - 2 * share);
      this.target.lerpVectors(fromTarget, toTarget, eased);
      const offset = new Spherical(
        from.radius + (to.radius - from.radius) * eased,
        from.phi + (to.phi - from.phi) * eased,
        from.theta + turn * eased,
      );
      this.camera.position.setFromSpherical(offset).add(this.target);
      this.controls.update();
      this.onChange();
      this.turn = share < 1 ? requestAnimationFrame(step) : 0;
      if (this.turn === 0) this.onUserMove();
    };
    step();
  }

  /** True while a view is being turned to. */
  get turning(): boolean {
    return this.turn !== 0;
  }

  private stopTurning(): void {
    cancelAnimationFrame(this.turn);
    this.turn = 0;
  }
}

function extent(points: Float32Array, axis: Vector3): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const value = points[i]! * axis.x + points[i + 1]! * axis.y + points[i + 2]! * axis.z;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return [low, high];
}

function mid([low, high]: [number, number]): number {
  return (low + high) / 2;
}
