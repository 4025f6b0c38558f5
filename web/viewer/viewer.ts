/** The picture: what it shows in one to four views with one camera, drawn only when something changed. */
import { NoToneMapping, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import type { KeysInfo } from '../engine/api/types.ts';
import type { CameraPose, ViewName } from '../model/camera.ts';
import { CameraRig, NO_INSETS } from './camera.ts';
import type { Insets } from './camera.ts';
import { Contents } from './contents.ts';
import { Stage } from './stage.ts';
import type { Bounds } from './stage.ts';
import { tiles } from './tiles.ts';
import type { Extra, GhostPicture, Look, Rect } from './types.ts';

export interface ViewerEvents {
  /** The user, or a standard view, has moved the camera. */
  onCamera(pose: CameraPose): void;
  onContextLost(): void;
  onContextRestored(): void;
  /** The canvas has another size, and the views stand elsewhere. */
  onResize(): void;
  /** Pixels at the top and the bottom of each of so many views that other things lie over. */
  covered(views: number): { top: number; bottom: number };
}

/** The largest share of a view's height that is given to what lies over it. */
const MOST_COVERED = 0.4;

export class Viewer {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly stage = new Stage();
  private readonly rig: CameraRig;
  private readonly contents = new Contents(() => this.invalidate());
  private home: { bounds: Bounds; points: Float32Array; radius: number } | null = null;
  private pending = 0;
  private waiting: (() => void)[] = [];
  private readonly resize: ResizeObserver;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly host: HTMLElement,
    private readonly events: ViewerEvents,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'high-performance' });
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.autoClear = false;
    this.canvas = this.renderer.domElement;
    host.append(this.canvas);
    this.scene.add(this.stage.object, this.contents.object);
    this.rig = new CameraRig(
      this.canvas,
      () => this.invalidate(),
      () => events.onCamera(this.rig.pose()),
    );
    this.canvas.addEventListener('webglcontextlost', () => events.onContextLost());
    this.canvas.addEventListener('webglcontextrestored', () => {
      events.onContextRestored();
      // The first drawing after it has neither floor nor transparent ground; the second one is whole.
      this.draw();
      this.invalidate();
    });
    this.resize = new ResizeObserver(() => {
      this.fitCanvas();
      events.onResize();
    });
    this.resize.observe(host);
    this.fitCanvas();
  }

  /** A new import; nothing of it is seen until its first frame. */
  setImport(info: KeysInfo, bounds: Bounds, points: Float32Array): void {
    this.contents.setImport(info);
    this.stage.setBounds(bounds);
    this.home = { bounds, points, radius: radiusOf(bounds) };
    this.rig.setPoints(points, this.home.radius);
  }

  get views(): number {
    return this.contents.views;
  }

  /** How many shapes are shown side by side; those that exist keep their frame. */
  setViews(count: number): void {
    this.contents.setViews(count);
    this.invalidate();
  }

  /** `eased`: the frame before goes over into it; all views are eased together, or none. */
  setFrame(view: number, positions: Float32Array, normals: Float32Array, colour: string, eased = false): void {
    this.contents.setFrame(view, positions, normals, colour, eased);
    this.invalidate();
  }

  /** Onion skins or a film strip; `instead` hides the moving shapes. */
  setExtras(extras: readonly Extra[], instead = false): void {
    this.contents.setExtras(extras, instead);
    this.invalidate();
  }

  setPatchColours(colours: Float32Array | null): void {
    this.contents.setPatchColours(colours);
    this.invalidate();
  }

  setHeatColours(colours: Float32Array | null): void {
    this.contents.setHeatColours(colours);
    this.invalidate();
  }

  setMark(faces: readonly number[] | null): void {
    this.contents.setMark(faces);
    this.invalidate();
  }

  setGhost(ghost: GhostPicture | null): void {
    this.contents.setGhost(ghost);
    this.invalidate();
  }

  setLook(look: Look): void {
    this.contents.setLook(look);
    this.stage.setLook(look.floor, look.dark);
    this.invalidate();
  }

  /** A colour behind the shape, for videos, which have no transparency; null lets the page through. */
  setBackdrop(colour: string | null): void {
    this.renderer.setClearColor(colour ?? '#000000', colour === null ? 0 : 1);
    this.invalidate();
  }

  fit(view: ViewName | null, eased: boolean): void {
    this.rig.setAspect(this.aspect());
    this.rig.setInsets(this.insets());
    this.rig.fit(view, eased);
  }

  /** Lets light, floor and fitted views follow other shapes than the keys: what is extrapolated, a film strip. */
  setExtent(bounds: Bounds, points: Float32Array): void {
    this.stage.setBounds(bounds);
    this.rig.setPoints(points, radiusOf(bounds));
    this.invalidate();
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

  /** Positions drawn in a view now, copied; empty before the first frame. */
  positions(view: number): Float32Array {
    return this.contents.positions(view);
  }

  /** Where points (xyz interleaved) appear: x, y in CSS pixels from the canvas' top left corner. */
  project(points: Float32Array, view = 0): Float32Array {
    const rect = this.rects()[view];
    if (!rect) return new Float32Array();
    this.rig.prepare(rect.width / rect.height);
    const result = new Float32Array((points.length / 3) * 2);
    const point = new Vector3();
    for (let i = 0; i < points.length / 3; i += 1) {
      point.fromArray(points, 3 * i).project(this.rig.camera);
      result[2 * i] = rect.x + ((point.x + 1) / 2) * rect.width;
      result[2 * i + 1] = rect.y + ((1 - point.y) / 2) * rect.height;
    }
    return result;
  }

  /** The parts of the canvas that the views take, in CSS pixels. */
  rects(): Rect[] {
    return tiles(
      Math.max(this.contents.views, 1),
      Math.max(this.host.clientWidth, 1),
      Math.max(this.host.clientHeight, 1),
    );
  }

  invalidate(): void {
    if (this.pending === 0) this.pending = requestAnimationFrame(() => this.draw());
  }

  /** Resolves once everything set so far has been drawn, no view is being turned to and no shape eased. */
  async drawn(): Promise<void> {
    // One draw shows all that was set before it; what is set meanwhile, as by a motion that plays, is not waited for.
    if (this.pending === 0 && !this.moving) return;
    do {
      await new Promise<void>((resolve) => {
        this.waiting.push(resolve);
        this.invalidate();
      });
    } while (this.moving);
  }

  /** Draws now and calls `use` before the browser may clear the canvas. */
  snapshot<T>(use: (canvas: HTMLCanvasElement) => T): T {
    this.draw();
    return use(this.canvas);
  }

  /** A small picture of one shape in the current look, as a data URL. */
  thumbnail(positions: Float32Array, normals: Float32Array, width: number, height: number, colour: string): string {
    const picture = this.contents.alone(positions, normals, colour, () => this.drawHome(width, height));
    // Before the browser shows the canvas again: several pictures in a row cost one drawing.
    if (picture !== null) this.invalidate();
    return picture ?? '';
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.resize.disconnect();
    this.contents.clear();
    this.rig.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }

  private get moving(): boolean {
    return this.rig.turning || this.contents.easing;
  }

  /** What covers the views, as shares of their height; never so much that little is left. */
  private insets(): Insets {
    const { height } = this.rects()[0]!;
    const { top, bottom } = this.events.covered(this.contents.views);
    const scale = Math.min(1, MOST_COVERED / Math.max((top + bottom) / height, 1e-6));
    return { top: (scale * top) / height, bottom: (scale * bottom) / height };
  }

  private aspect(): number {
    const rect = this.rects()[0]!;
    return rect.width / rect.height;
  }

  private fitCanvas(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.rig.setInsets(this.insets());
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    this.contents.ease(performance.now());
    if (this.contents.easing) this.invalidate();
    const rects = this.rects();
    this.contents.eachView(rects.length, (view) => this.renderOne(rects[view]!));
    const waiting = this.waiting;
    this.waiting = [];
    for (const resolve of waiting) resolve();
  }

  /** From where a new import is seen. Uses a corner of the canvas, where the picture has to be drawn again. */
  private drawHome(width: number, height: number): string {
    const { clientWidth, clientHeight } = this.host;
    const scale = Math.min(1, clientWidth / width, clientHeight / height);
    const [w, h] = [Math.max(Math.floor(width * scale), 1), Math.max(Math.floor(height * scale), 1)];
    const before = this.rig.extent();
    const pose = this.rig.pose();
    const insets = this.rig.setInsets(NO_INSETS);
    const { floor, dark } = this.contents.look;
    if (this.home) this.rig.setPoints(this.home.points, this.home.radius);
    this.rig.setAspect(w / h);
    this.rig.setPose(this.rig.fittedPose('home'));
    this.stage.setLook(false, dark);
    this.renderOne({ x: 0, y: clientHeight - h, width: w, height: h });
    const picture = cut(this.canvas, w, h, this.renderer.getPixelRatio());
    this.stage.setLook(floor, dark);
    this.rig.setPoints(before.points, before.radius);
    this.rig.setInsets(insets);
    this.rig.setPose(pose);
    return picture;
  }

  private renderOne(rect: Rect): void {
    const bottom = this.host.clientHeight - rect.y - rect.height;
    this.renderer.setViewport(rect.x, bottom, rect.width, rect.height);
    this.renderer.setScissor(rect.x, bottom, rect.width, rect.height);
    this.renderer.setScissorTest(true);
    this.renderer.clear();
    this.rig.prepare(rect.width / rect.height);
    this.stage.follow(this.rig.camera, this.rig.target);
    this.renderer.render(this.scene, this.rig.camera);
  }
}

function radiusOf({ min, max }: Bounds): number {
  return new Vector3(...max).distanceTo(new Vector3(...min)) / 2;
}

/** The bottom left corner of the canvas as a PNG; in the same task as the drawing, before the buffer is cleared. */
function cut(source: HTMLCanvasElement, width: number, height: number, ratio: number): string {
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas
    .getContext('2d')
    ?.drawImage(
      source,
      0,
      source.height - canvas.height,
      canvas.width,
      canvas.height,
      0,
      0,
      canvas.width,
      canvas.height,
    );
  return canvas.toDataURL('image/png');
}
