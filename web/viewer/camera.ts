/** The common camera of all views: orbit, pan, zoom, and standard views fitted tightly to the shape. */
import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraPose, ViewName } from '../model/camera.ts';
import { FIELD_OF_VIEW, NO_INSETS, directionOf, fittedPose, setLens } from './fit.ts';
import type { Extent, Insets } from './fit.ts';
import { measureInOwnPixels } from './own-pixels.ts';

const TURN_MS = 180;

export class CameraRig {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private extent: Extent = { points: new Float32Array([-1, -1, -1, 1, 1, 1]), radius: 1 };
  private aspect = 1;
  private insets: Insets = NO_INSETS;
  private turn = 0;
  /** Camera after the last fit. */
  private whole: CameraPose | null = null;

  constructor(
    element: HTMLElement,
    private readonly onChange: () => void,
    private readonly onUserMove: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, element);
    measureInOwnPixels(this.controls, element);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', this.onChange);
    this.controls.addEventListener('start', () => this.stopTurning());
    this.controls.addEventListener('end', this.onUserMove);
    this.setPose(this.fitted(directionOf('home')));
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  /** Returns a function that restores the current camera and fit. */
  keep(): () => void {
    const { extent, whole } = this;
    const pose = this.pose();
    return () => {
      this.setExtent(extent);
      this.setPose(pose);
      this.whole = whole;
    };
  }

  setExtent(extent: Extent): void {
    this.extent = extent;
    this.controls.minDistance = 0.02 * extent.radius;
    this.controls.maxDistance = 60 * extent.radius;
  }

  setAspect(aspect: number): void {
    this.aspect = aspect;
  }

  /** Centres the image in the free area, without rotation. */
  setInsets(insets: Insets): void {
    this.insets = insets;
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

  /** Shows the whole shape from a standard direction, or from the current one. */
  fit(view: ViewName | null, eased: boolean): void {
    const direction = view ? directionOf(view) : this.camera.position.clone().sub(this.target).normalize();
    const pose = this.fitted(direction);
    this.whole = pose;
    if (eased) return this.turnTo(pose);
    this.setPose(pose);
    this.onUserMove();
  }

  /** Whether the camera is at its fitted pose, or moving there. */
  get isFitted(): boolean {
    if (this.turning || !this.whole) return this.turning;
    const { position, target } = this.whole;
    const off =
      this.camera.position.distanceTo(new Vector3(...position)) + this.target.distanceTo(new Vector3(...target));
    return off < 1e-4 * this.extent.radius;
  }

  /** Rotates about the target by angles in radians; used by the keyboard. */
  orbit(horizontal: number, vertical: number): void {
    const offset = new Spherical().setFromVector3(this.camera.position.clone().sub(this.target));
    offset.theta -= horizontal;
    offset.phi = Math.min(Math.max(offset.phi - vertical, 0.01), Math.PI - 0.01);
    this.moveTo(new Vector3().setFromSpherical(offset).add(this.target));
  }

  zoom(factor: number): void {
    this.moveTo(this.camera.position.clone().sub(this.target).multiplyScalar(factor).add(this.target));
  }

  /** Moves eye and target by multiples of the shape's radius. */
  pan(right: number, up: number): void {
    const shift = new Vector3()
      .setFromMatrixColumn(this.camera.matrix, 0)
      .multiplyScalar(right * this.extent.radius)
      .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * this.extent.radius);
    this.target.add(shift);
    this.moveTo(this.camera.position.clone().add(shift));
  }

  /**
   * Sets the parameters that depend on the view's aspect ratio and the eye's distance; call before drawing. A `zoom`
   * below 1 shows more.
   */
  prepare(aspect: number, zoom = 1): void {
    this.camera.zoom = zoom;
    setLens(this.camera, this.target, this.extent.radius, aspect, this.insets);
  }

  dispose(): void {
    this.stopTurning();
    this.controls.dispose();
  }

  private moveTo(position: Vector3): void {
    this.stopTurning();
    this.camera.position.copy(position);
    this.controls.update();
    this.onUserMove();
  }

  private fitted(direction: Vector3): CameraPose {
    return fittedPose(direction, this.extent, this.aspect, this.insets);
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

  /** True while the view rotates to another direction. */
  get turning(): boolean {
    return this.turn !== 0;
  }

  private stopTurning(): void {
    cancelAnimationFrame(this.turn);
    this.turn = 0;
  }
}
