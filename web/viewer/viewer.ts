/** The viewer: one to four views with one camera, drawn only after changes. */
import { Scene, Vector3 } from 'three';
import type { WebGLRenderer } from 'three';
import type { KeysInfo } from '../engine/api/types.ts';
import type { CameraPose, ViewName } from '../model/camera.ts';
import { CameraRig } from './camera.ts';
import { Contents } from './contents.ts';
import { NO_INSETS } from './fit.ts';
import type { Insets } from './fit.ts';
import { listenToSize } from './host-size.ts';
import { Floor } from './floor.ts';
import { extentOf } from './bounds.ts';
import type { Extent } from './bounds.ts';
import type { Bounds } from './floor.ts';
import { Studio } from './studio.ts';
import { ownSurface } from './surface.ts';
import { Thumbnails } from './thumbnails.ts';
import { sides, tiles } from './tiles.ts';
import type { Extra, FirstKey, GhostPicture, Look, PixelSize, Ray, Rect } from './types.ts';

export interface ViewerEvents {
  /** The user, or a standard view, has moved the camera. */
  onCamera(pose: CameraPose): void;
  onContextLost(): void;
  onContextRestored(): void;
  /** The canvas size changed and the views have moved. */
  onResize(): void;
  /**
   * Pixels covered by other elements at the top and bottom of each view; two `split` views count as one. `strip`: the
   * views show film strips.
   */
  covered(views: number, split: boolean, strip: boolean): { top: number; bottom: number };
}

/** Aspect ratio of views with film strips, which are stacked. */
const STRIP_ASPECT = 6;
/** Sample of vertices for testing whether a shape is visible. */
const SAMPLED = 300;
/** Milliseconds between tests whether the graphics card has finished. */
const FENCE_MS = 4;
/** Largest share of a view's height for covering elements. */
const MAX_COVERED = 0.6;

export class Viewer {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly studio = new Studio();
  private readonly floor = new Floor();
  private readonly rig: CameraRig;
  private readonly contents = new Contents(this.studio, () => this.change());
  private readonly thumbnails: Thumbnails;
  /** Preferred aspect ratio of views side by side. */
  private tileAspect = 1;
  /** Size of exported images in pixels; null for the page size. */
  private pictureSize: PixelSize | null = null;
  private split: number | null = null;
  private phase: string | null = null;
  private bounds: Bounds | null = null;
  /** Restores camera and floor from before the first key of an import was shown. */
  private leaveOpening: (() => void) | null = null;
  /** Changes whenever the casters change. */
  private version = 0;
  private pending = 0;
  private starting: Promise<void> | null = null;
  private started = false;
  /** The floor is prepared after the first shape, which does not wait for it. */
  private flooring: Promise<void> | null = null;
  private floored = false;
  private waiting: (() => void)[] = [];
  private readonly followers: (() => void)[] = [];
  /** Device pixels per CSS pixel, as drawn. */
  private ratio = 1;
  private readonly over = new AbortController();
  /** Resolves when drawing has ended for good. */
  private readonly ended = new Promise<void>((resolve) => {
    this.over.signal.addEventListener('abort', () => resolve());
  });
  hasSeen = false;
  private onFirstSeen: () => void = () => undefined;
  /** Resolves once a shape has been drawn for the first time; then `hasSeen` is true. */
  readonly firstSeen = new Promise<void>((resolve) => {
    this.onFirstSeen = resolve;
  });

  /** Throws if the browser has no WebGL 2. */
  constructor(
    private readonly host: HTMLElement,
    private readonly events: ViewerEvents,
    private readonly surface = ownSurface(),
  ) {
    this.renderer = surface.renderer;
    this.thumbnails = new Thumbnails(this.renderer, this.studio);
    this.canvas = surface.canvas;
    this.canvas.style.objectFit = 'contain';
    host.append(this.canvas);
    this.scene.add(this.floor.object, this.contents.object);
    this.rig = new CameraRig(
      this.canvas,
      () => this.invalidate(),
      () => events.onCamera(this.rig.pose()),
    );
    const { signal } = this.over;
    const context = this.renderer.domElement;
    context.addEventListener('webglcontextlost', () => events.onContextLost(), { signal });
    context.addEventListener(
      'webglcontextrestored',
      () => {
        events.onContextRestored();
        this.floor.restore();
        this.started ||= this.starting !== null; // the lost context has no programs
        this.floored ||= this.flooring !== null;
        // The next frame has no floor and no transparent background. The frame after it is complete.
        this.draw();
        this.invalidate();
      },
      { signal },
    );
    let width = host.clientWidth;
    const resized = (): void => {
      this.fitCanvas();
      // After a phone is rotated, the shape must fit again.
      if (host.clientWidth !== width) this.refit(false);
      width = host.clientWidth;
      events.onResize();
    };
    // On another screen, or after a change of the page's `zoom`, the CSS size stays but the number of pixels changes.
    const zoomed = (): void => {
      if (this.ratio !== this.wantedRatio) this.fitCanvas();
    };
    listenToSize(host, resized, zoomed, signal);
    this.fitCanvas();
  }

  /** At most 2, because a finer image looks nearly the same and costs four times as much. */
  private get wantedRatio(): number {
    // Not every browser reports the zoom of page parts.
    return Math.min(window.devicePixelRatio * (this.host.currentCSSZoom ?? 1), 2);
  }

  /**
   * Announces an import that will be set soon. The graphics card compiles the first shape's programs while the motion
   * is made. Only the first call has an effect.
   */
  expect(info: KeysInfo): void {
    this.starting ??= this.contents
      .warm(info, this.renderer, this.rig.camera)
      .catch(() => undefined)
      .then(() => {
        this.started = true;
        this.draw();
      });
  }

  private async addFloor(): Promise<void> {
    await new Promise(requestAnimationFrame); // the first shape is being drawn
    await this.floor.compile(this.renderer, this.rig.camera).catch(() => undefined);
    this.floored = true;
    this.change();
  }

  /** A new import, hidden until its first frame, unless its first key is shown. */
  setImport(info: KeysInfo, bounds: Bounds, points: Float32Array): void {
    this.expect(info);
    this.leaveOpening = null;
    this.contents.setImport(info);
    this.tileAspect = 1;
    this.setBounds(bounds);
    const extent = { points, radius: radiusOf(bounds) };
    this.thumbnails.setExtent(extent);
    this.rig.setExtent(extent);
  }

  /**
   * Shows only the first key of an import, before the import is set; `camera` null: fits the whole key. The current
   * content is kept; call `hideFirstKey` or `setImport` next.
   */
  showFirstKey(key: FirstKey, { bounds, points }: Extent, camera: CameraPose | null): void {
    this.leaveOpening ??= this.restoring();
    this.contents.showFirstKey(key);
    this.floor.setPhase(key.colour);
    this.tileAspect = 1;
    this.setExtent(bounds, points);
    if (camera) this.setCameraPose(camera);
    else this.fit('home', false);
    this.change();
  }

  /** Returns a function that restores the current camera and floor. */
  private restoring(): () => void {
    const restoreCamera = this.rig.keep();
    const { bounds, tileAspect, phase } = this;
    const { isStrip } = this.contents;
    return () => {
      this.tileAspect = tileAspect;
      if (bounds) this.setBounds(bounds);
      this.floor.setPhase(isStrip ? null : phase);
      this.rig.setAspect(this.aspect());
      this.rig.setInsets(this.insets());
      restoreCamera();
    };
  }

  hideFirstKey(): void {
    const leave = this.leaveOpening;
    if (!leave) return;
    this.leaveOpening = null;
    this.contents.hideFirstKey();
    leave();
    this.change();
    // Without a previous shape, no later drawing would clear the image.
    if (!this.contents.isShown) this.render();
  }

  /** Resolves once the shape is shown with its own textures. */
  textured(): Promise<void> {
    return this.contents.textured;
  }

  get views(): number {
    return this.contents.views;
  }

  /** Sets the number of shapes side by side; existing shapes keep their frames. */
  setViews(count: number): void {
    this.contents.setViews(count);
    this.change();
  }

  setFrame(view: number, positions: Float32Array, normals: Float32Array, colour: string): void {
    this.contents.setFrame(view, positions, normals, colour);
    this.phase = colour;
    this.floor.setPhase(this.contents.isStrip ? null : colour);
    this.change();
  }

  /** Onion skins or a film strip for each view; `instead` hides the moving shapes. */
  setExtras(extras: readonly (readonly Extra[])[], instead = false): void {
    this.contents.setExtras(extras, instead);
    this.tileAspect = instead ? STRIP_ASPECT : 1;
    this.floor.setPhase(instead ? null : this.phase);
    this.change();
  }

  setPatchColours(colours: Float32Array | null): void {
    this.contents.setPatchColours(colours);
    this.change();
  }

  setHeatColours(colours: Float32Array | null, view = 0): void {
    this.contents.setHeatColours(colours, view);
    this.change();
  }

  setMark(faces: readonly number[] | null): void {
    this.contents.setMark(faces);
    this.change();
  }

  setGhost(ghost: GhostPicture | null): void {
    this.contents.setGhost(ghost);
    this.change();
  }

  setLook(look: Look): void {
    this.contents.setLook(look);
    this.floor.setLook(look.floor, look.dark);
    this.studio.setDark(look.dark);
    this.change();
  }

  /**
   * Sets a fixed output size in pixels, with the page's views centred and uncovered; null restores the page size.
   * Throws if the graphics card does not support the size.
   */
  setPictureSize(size: PixelSize | null): void {
    this.pictureSize = size;
    this.fitCanvas();
    const context = this.renderer.getContext();
    if (!size || (context.drawingBufferWidth === size.width && context.drawingBufferHeight === size.height)) return;
    this.setPictureSize(null);
    throw new Error('The graphics card cannot draw an image of this size. Choose a smaller size.');
  }

  fit(view: ViewName | null, eased: boolean): void {
    this.rig.setAspect(this.aspect());
    this.rig.setInsets(this.insets());
    this.rig.fit(view, eased);
  }

  /** Whether the view has not moved since it was fitted. */
  get isFitted(): boolean {
    return this.rig.isFitted;
  }

  /** The covered area has changed. Fits the view to the free area, unless the user has moved it. */
  refit(eased: boolean): void {
    if (this.rig.isFitted) this.fit(null, eased);
  }

  /**
   * Adapts light, floor and fitted views to other shapes than the keys, such as extrapolated shapes and film strips.
   */
  setExtent(bounds: Bounds, points: Float32Array): void {
    this.setBounds(bounds);
    this.rig.setExtent({ points, radius: radiusOf(bounds) });
    this.invalidate();
  }

  private setBounds(bounds: Bounds): void {
    this.bounds = bounds;
    this.floor.setBounds(bounds);
  }

  cameraPose(): CameraPose {
    return this.rig.pose();
  }

  setCameraPose(pose: CameraPose): void {
    this.rig.setPose(pose);
  }

  orbit(horizontal: number, vertical: number): void {
    this.rig.orbit(horizontal, vertical);
  }

  zoom(factor: number): void {
    this.rig.zoom(factor);
  }

  pan(right: number, up: number): void {
    this.rig.pan(right, up);
  }

  /** A copy of the positions drawn in a view; empty before the first frame. */
  positions(view: number): Float32Array {
    return this.contents.positions(view);
  }

  /** A vertex drawn in the first view; empty before the first frame. */
  vertex(index: number): Float32Array {
    return this.contents.vertex(index);
  }

  /** The point at a canvas position with the same depth in the first view as `point`. */
  beside(point: ArrayLike<number>, x: number, y: number): [number, number, number] {
    const rect = this.rects()[0]!;
    this.rig.prepare(rect.width / rect.height, 1);
    const { camera } = this.rig;
    const depth = new Vector3(point[0], point[1], point[2]).project(camera).z;
    const place = new Vector3(((x - rect.x) / rect.width) * 2 - 1, 1 - ((y - rect.y) / rect.height) * 2, depth);
    return place.unproject(camera).toArray();
  }

  /** Called after every draw, so overlays can follow the shape. */
  follow(onDrawn: () => void): void {
    this.followers.push(onDrawn);
  }

  /** Projects points (xyz interleaved) to x, y in CSS pixels from the canvas' top left corner. */
  project(points: Float32Array, view = 0): Float32Array {
    return this.projected(points, this.rects()[view], 1);
  }

  /** Projects points to the canvas's own pixels. */
  projectDrawn(points: Float32Array, view: number): Float32Array {
    const rect = this.drawnRects()[view];
    return this.projected(points, rect, rect ? this.zoomOf(rect) : 1);
  }

  private projected(points: Float32Array, rect: Rect | undefined, zoom: number): Float32Array {
    if (!rect) return new Float32Array();
    this.rig.prepare(rect.width / rect.height, zoom);
    const result = new Float32Array((points.length / 3) * 2);
    const point = new Vector3();
    for (let i = 0; i < points.length / 3; i += 1) {
      point.fromArray(points, 3 * i).project(this.rig.camera);
      result[2 * i] = rect.x + ((point.x + 1) / 2) * rect.width;
      result[2 * i + 1] = rect.y + ((1 - point.y) / 2) * rect.height;
    }
    return result;
  }

  /** View and ray at a position in CSS pixels from the canvas's top left corner; null outside every view. */
  rayAt(x: number, y: number): { view: number; ray: Ray } | null {
    const inside = (rect: Rect): boolean =>
      x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
    const view = this.seen().findIndex(inside);
    const rect = this.rects()[view];
    if (!rect) return null;
    this.rig.prepare(rect.width / rect.height, 1);
    const at = (depth: number): Vector3 =>
      new Vector3(((x - rect.x) / rect.width) * 2 - 1, 1 - ((y - rect.y) / rect.height) * 2, depth).unproject(
        this.rig.camera,
      );
    const near = at(-1);
    const direction = at(1).sub(near).normalize();
    return { view, ray: { origin: near.toArray(), direction: direction.toArray() } };
  }

  /** Whether any of the shape is visible, tested on a sample of vertices; true if none is drawn. */
  seesShape(): boolean {
    const rect = this.fittedRect();
    const points = this.contents.sample(SAMPLED);
    if (points.length === 0) return true;
    const places = this.project(points);
    const { camera } = this.rig;
    const point = new Vector3();
    for (let i = 0; i < places.length; i += 2) {
      // Skips points behind the eye, which would project as if in front of it.
      if (point.fromArray(points, (3 * i) / 2).applyMatrix4(camera.matrixWorldInverse).z >= 0) continue;
      const x = places[i]! - rect.x;
      const y = places[i + 1]! - rect.y;
      if (x >= 0 && x <= rect.width && y >= 0 && y <= rect.height) return true;
    }
    return false;
  }

  /** Area for fitting the first shape: the part not hidden by a divider, unless the divider hides even the middle. */
  private fittedRect(): Rect {
    const [[whole], [side]] = [this.rects(), this.seen()] as [[Rect], [Rect]];
    const middle = whole.x + whole.width / 2;
    return side.x <= middle && middle <= side.x + side.width ? side : whole;
  }

  /** Areas of the views on the page, in CSS pixels. */
  rects(): Rect[] {
    return this.tiles(this.size());
  }

  /** Visible parts of the views on the page, in CSS pixels. */
  seen(): Rect[] {
    return this.sides(this.size());
  }

  /** Visible parts of the views on the canvas, in its pixels. */
  drawnRects(): Rect[] {
    return this.sides(this.canvas);
  }

  /** With a divider, both views have the full width. */
  private tiles({ width, height }: PixelSize): Rect[] {
    if (this.isSplit) return this.sides({ width, height }).map(() => ({ x: 0, y: 0, width, height }));
    return tiles(Math.max(this.contents.views, 1), Math.max(width, 1), Math.max(height, 1), this.tileAspect);
  }

  private sides(size: PixelSize): Rect[] {
    return this.isSplit ? sides(this.split!, size.width, size.height) : this.tiles(size);
  }

  /** Position of a divider between two views, relative to the width; null: side by side. */
  setSplit(share: number | null): void {
    const before = this.isSplit;
    this.split = share;
    if (this.isSplit !== before) this.fit(null, false);
    this.invalidate();
  }

  /** Whether a divider separates two views. */
  get isSplit(): boolean {
    return this.split !== null && this.contents.views === 2;
  }

  private change(): void {
    this.version += 1;
    this.invalidate();
  }

  invalidate(): void {
    if (this.pending === 0) this.pending = requestAnimationFrame(() => this.draw());
  }

  /** Resolves once all changes so far have been drawn and no view is rotating. */
  async drawn(): Promise<void> {
    // One draw shows all earlier changes. It does not wait for later ones, such as playback.
    if (this.pending === 0 && !this.rig.turning && !this.compiling && this.floored === (this.flooring !== null)) return;
    do {
      await Promise.race([this.flooring, this.ended]);
      if (this.over.signal.aborted) return;
      await new Promise<void>((resolve) => {
        this.waiting.push(resolve);
        this.invalidate();
      });
    } while (this.rig.turning || (this.flooring !== null && !this.floored));
  }

  /** Resolves like `drawn`, but also waits for the graphics card. */
  async finished(): Promise<void> {
    await this.drawn();
    const context = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    context.flush();
    while (fence && !context.isContextLost() && !this.over.signal.aborted) {
      if (context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED) break;
      await new Promise((resolve) => setTimeout(resolve, FENCE_MS));
    }
    context.deleteSync(fence);
  }

  /** Draws now and calls `use` before the browser may clear the canvas. */
  snapshot<T>(use: (canvas: HTMLCanvasElement) => T): T {
    this.draw();
    return use(this.canvas);
  }

  /** A small image of one shape in the current look, as a data URL; empty for a frame of another import. */
  thumbnail(positions: Float32Array, normals: Float32Array, width: number, height: number, colour: string): string {
    const shape = this.contents.shapeOf(positions, normals, colour);
    if (!shape) return '';
    const { bounds, points } = extentOf([positions]);
    const picture = this.thumbnails.draw(shape, { points, radius: radiusOf(bounds) }, width, height);
    shape.dispose();
    return picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.contents.dispose();
    this.rig.dispose();
    this.floor.dispose();
    this.over.abort();
    this.surface.dispose();
    // Releases callers that wait for a frame, because drawing has ended.
    for (const resolve of this.waiting.splice(0)) resolve();
  }

  private get compiling(): boolean {
    return this.starting !== null && !this.started;
  }

  /** Covered shares of the views' heights, limited to leave room for the shape. */
  private insets(): Insets {
    const { height } = this.rects()[0]!;
    const { views, isStrip } = this.contents;
    const { top, bottom } = this.events.covered(this.isSplit ? 1 : views, this.isSplit, isStrip);
    const scale = Math.min(1, MAX_COVERED / Math.max((top + bottom) / height, 1e-6));
    return { top: (scale * top) / height, bottom: (scale * bottom) / height };
  }

  private aspect(): number {
    const rect = this.rects()[0]!;
    return rect.width / rect.height;
  }

  private fitCanvas(): void {
    const { clientWidth, clientHeight } = this.host;
    if (this.pictureSize) this.surface.setSize(this.pictureSize.width, this.pictureSize.height, 1, false);
    else if (clientWidth === 0 || clientHeight === 0) return;
    else {
      this.ratio = this.wantedRatio;
      this.surface.setSize(clientWidth, clientHeight, this.ratio, true);
    }
    this.rig.setInsets(this.pictureSize ? NO_INSETS : this.insets());
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    if (this.compiling) return;
    // The old image stays until the first frame of an import, because an empty floor would flash.
    if (this.contents.isShown || !this.hasSeen) this.render();
    const waiting = this.waiting;
    this.waiting = [];
    for (const resolve of waiting) resolve();
    if (this.pictureSize) return;
    for (const follow of this.followers) follow();
  }

  private render(): void {
    const size = this.pictureSize ?? this.size();
    const seen = this.sides(size);
    const tiles = this.started ? this.tiles(size) : [];
    this.surface.begin();
    this.floor.object.visible = this.floored;
    tiles.forEach((rect, view) => this.renderOne(rect, seen[view]!, size.height, this.contents.layersOf(view)));
    this.surface.end();
    if (this.flooring || tiles.length === 0 || !this.contents.isShown) return;
    this.flooring = this.addFloor();
    this.hasSeen = true;
    this.onFirstSeen();
  }

  private size(): PixelSize {
    return { width: Math.max(this.host.clientWidth, 1), height: Math.max(this.host.clientHeight, 1) };
  }

  /** For a view narrower than on the page, zooms out until the page's width is visible. */
  private zoomOf({ width, height }: Rect): number {
    return this.pictureSize ? Math.min(width / height / this.aspect(), 1) : 1;
  }

  private renderOne(rect: Rect, seen: Rect, height: number, layers: number[]): void {
    const bottom = (part: Rect): number => height - part.y - part.height;
    this.renderer.setViewport(rect.x, bottom(rect), rect.width, rect.height);
    this.renderer.setScissor(seen.x, bottom(seen), seen.width, seen.height);
    this.renderer.setScissorTest(true);
    this.renderer.clear();
    this.rig.prepare(rect.width / rect.height, this.zoomOf(rect));
    this.studio.follow(this.rig.camera);
    const all = layers.reduce((sum, mask) => sum | mask);
    if (this.floored) this.floor.prepare(this.renderer, this.scene, all, this.version);
    for (const mask of layers) {
      this.renderer.clearDepth();
      this.rig.camera.layers.mask = mask;
      this.renderer.render(this.scene, this.rig.camera);
    }
  }
}

function radiusOf({ min, max }: Bounds): number {
  return Math.max(new Vector3(...max).distanceTo(new Vector3(...min)) / 2, 1e-6);
}
