/** The picture: shapes in one to four views with one camera, drawn only when something changed. */
import { NoToneMapping, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import type { KeysInfo } from '../engine/api/types.ts';
import { CameraRig, NO_INSETS } from './camera.ts';
import type { Insets } from './camera.ts';
import { GhostView } from './ghost.ts';
import { Shape, topologyOf } from './shape.ts';
import type { Topology } from './shape.ts';
import { Stage } from './stage.ts';
import type { Bounds } from './stage.ts';
import { decodeTextures } from './textures.ts';
import { tiles } from './tiles.ts';
import type { CameraPose, Extra, GhostPicture, Look, Rect, ViewName } from './types.ts';

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

/** How long a shape takes to go over into the exact one. */
const EASE_MS = 150;
/** The largest share of a view's height that is given to what lies over it. */
const MOST_COVERED = 0.4;
const DEFAULT_LOOK: Look = { colouring: 'phase', shading: 'smooth', wireframe: false, floor: true, dark: false };

export class Viewer {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly stage = new Stage();
  private readonly rig: CameraRig;
  private topology: Topology | null = null;
  private shapes: Shape[] = [];
  private extras: Shape[] = [];
  private ghost: GhostView | null = null;
  private colours: string[] = [];
  private look = DEFAULT_LOOK;
  private patchColours: Float32Array | null = null;
  private hideShapes = false;
  private home: { bounds: Bounds; points: Float32Array; radius: number } | null = null;
  private pending = 0;
  /** When the shapes began to be eased: 0 = with the next drawing, null = they are not. */
  private easedSince: number | null = null;
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
    this.scene.add(this.stage.object);
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

  /** A new import: fresh buffers for `views` shapes, which stay hidden until their first frame. */
  setImport(info: KeysInfo, bounds: Bounds, points: Float32Array): void {
    this.clearShapes();
    for (const texture of this.topology?.textures ?? []) texture?.dispose();
    this.topology = topologyOf(info);
    this.patchColours = null;
    this.stage.setBounds(bounds);
    this.home = { bounds, points, radius: new Vector3(...bounds.max).distanceTo(new Vector3(...bounds.min)) / 2 };
    this.rig.setPoints(points, this.home.radius);
    void this.loadTextures(this.topology);
  }

  get views(): number {
    return this.shapes.length;
  }

  /** How many shapes are shown side by side; those that exist keep their frame. */
  setViews(count: number): void {
    if (!this.topology) return;
    while (this.shapes.length > count) this.shapes.pop()?.dispose();
    while (this.shapes.length < count) {
      const shape = this.addShape();
      shape.setPatchColours(this.patchColours);
      shape.setLook(this.look);
      shape.object.visible = false;
      this.shapes.push(shape);
    }
    this.invalidate();
  }

  /**
   * A frame of another import, which was on its way when this one came, is left out. `eased`: the frame before goes over into
   * it; all views are eased together, or none.
   */
  setFrame(view: number, positions: Float32Array, normals: Float32Array, colour: string, eased = false): void {
    const shape = this.shapes[view];
    if (!shape || !this.fits(positions)) return;
    if (eased) shape.setFrameEased(positions, normals);
    else shape.setFrame(positions, normals);
    this.easedSince = eased ? 0 : null;
    shape.object.visible = true;
    this.colours[view] = colour;
    this.applyColours();
    this.invalidate();
  }

  /** Onion skins or a film strip; `instead` hides the moving shapes. */
  setExtras(extras: readonly Extra[], instead = false): void {
    if (!extras.every(({ positions }) => this.fits(positions))) return;
    while (this.extras.length > extras.length) this.extras.pop()?.dispose();
    while (this.extras.length < extras.length && this.topology) this.extras.push(this.addShape());
    extras.forEach((extra, index) => {
      const shape = this.extras[index];
      if (!shape) return;
      shape.setFrame(extra.positions, extra.normals);
      shape.setColour(extra.colour);
      shape.setOpacity(extra.opacity);
      shape.object.position.x = extra.offset;
    });
    this.hideShapes = instead;
    this.invalidate();
  }

  /** Colour of each patch on the shape: 3 x vertices, linear RGB; null takes them away. */
  setPatchColours(colours: Float32Array | null): void {
    this.patchColours = colours;
    for (const shape of this.shapes) shape.setPatchColours(colours);
    this.setLook(this.look);
  }

  /** Amounts as colours on the first view's shape: 3 x vertices, linear RGB; null takes them away. */
  setHeatColours(colours: Float32Array | null): void {
    const shape = this.shapes[0];
    if (!shape || (colours && !this.fits(colours))) return;
    shape.setHeatColours(colours);
    shape.setLook(this.look);
    this.applyColours();
    this.invalidate();
  }

  /** Marks faces of the first view's shape; null takes the mark away. */
  setMark(faces: readonly number[] | null): void {
    const corners = this.topology?.index.array;
    if (!corners) return;
    const index =
      faces &&
      Uint32Array.from({ length: 3 * faces.length }, (_, i) => corners[3 * faces[Math.floor(i / 3)]! + (i % 3)]!);
    this.shapes[0]?.setMark(index);
    this.invalidate();
  }

  /** The ghost mesh of the first view's shape, as it is at the moment that is drawn; null takes it away. */
  setGhost(ghost: GhostPicture | null): void {
    const shape = this.shapes[0];
    if (!ghost || !this.ghost?.fits(ghost)) {
      this.ghost?.dispose();
      this.ghost = ghost && new GhostView(ghost);
      if (this.ghost) this.scene.add(this.ghost.object);
    }
    if (ghost && shape) this.ghost?.setFrame(ghost, shape.positions, this.look.dark);
    this.invalidate();
  }

  setLook(look: Look): void {
    this.look = look;
    for (const shape of this.shapes) shape.setLook(look);
    for (const shape of this.extras) shape.setLook({ ...look, colouring: 'phase', wireframe: false });
    this.stage.setLook(look.floor, look.dark);
    this.applyColours();
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
    this.rig.setPoints(points, new Vector3(...bounds.max).distanceTo(new Vector3(...bounds.min)) / 2);
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
    const shape = this.shapes[view];
    return shape?.object.visible ? shape.positions.slice() : new Float32Array();
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
      Math.max(this.shapes.length, 1),
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
    if (!this.topology || !this.fits(positions)) return '';
    const shape = this.addShape();
    shape.setFrame(positions, normals);
    shape.setLook({ ...this.look, wireframe: false });
    shape.setColour(colour);
    const picture = this.drawAlone(width, height);
    shape.dispose();
    // The browser may show the canvas at any time.
    this.draw();
    return picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.resize.disconnect();
    this.clearShapes();
    this.rig.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }

  private get moving(): boolean {
    return this.rig.turning || this.easedSince !== null;
  }

  private fits(positions: Float32Array): boolean {
    return positions.length === 3 * (this.topology?.vertices ?? -1);
  }

  private addShape(): Shape {
    const shape = new Shape(this.topology!);
    shape.setLook(this.look);
    this.scene.add(shape.object);
    return shape;
  }

  private clearShapes(): void {
    for (const shape of [...this.shapes, ...this.extras]) shape.dispose();
    this.shapes = [];
    this.extras = [];
    this.ghost?.dispose();
    this.ghost = null;
    this.hideShapes = false;
    this.easedSince = null;
  }

  private applyColours(): void {
    this.shapes.forEach((shape, index) => shape.setColour(this.colours[index] ?? '#888888'));
  }

  private async loadTextures(topology: Topology): Promise<void> {
    const textures = await decodeTextures(topology.scene.images, topology.scene.materials);
    if (this.topology !== topology) return;
    topology.textures = textures;
    this.setLook(this.look);
  }

  /** What covers the views, as shares of their height; never so much that little is left. */
  private insets(): Insets {
    const { height } = this.rects()[0]!;
    const { top, bottom } = this.events.covered(this.shapes.length);
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
    this.ease();
    const visible = this.shapes.map((shape) => shape.object.visible);
    this.rects().forEach((rect, view) => {
      // Onion skins and film strip belong to the first view's motion.
      for (const extra of this.extras) extra.object.visible = view === 0;
      const hidden = this.hideShapes && view === 0;
      if (this.ghost) this.ghost.object.visible = view === 0 && !hidden;
      this.shapes.forEach((shape, index) => {
        shape.object.visible = visible[index]! && index === view && !hidden;
      });
      this.renderOne(rect);
    });
    this.shapes.forEach((shape, index) => {
      shape.object.visible = visible[index]!;
    });
    const waiting = this.waiting;
    this.waiting = [];
    for (const resolve of waiting) resolve();
  }

  /** The clock starts with the first drawing: to bring large shapes to the graphics card takes a moment. */
  private ease(): void {
    if (this.easedSince === null) return;
    const now = performance.now();
    if (this.easedSince === 0) this.easedSince = now;
    const share = Math.min((now - this.easedSince) / EASE_MS, 1);
    for (const shape of this.shapes) shape.ease(share * share * (3 - 2 * share));
    if (share < 1) this.invalidate();
    else this.easedSince = null;
  }

  /** Uses a corner of the canvas, where the picture has to be drawn again. */
  private drawAlone(width: number, height: number): string {
    const { clientWidth, clientHeight } = this.host;
    const scale = Math.min(1, clientWidth / width, clientHeight / height);
    const [w, h] = [Math.max(Math.floor(width * scale), 1), Math.max(Math.floor(height * scale), 1)];
    const all = [...this.shapes, ...this.extras, ...(this.ghost ? [this.ghost] : [])];
    const shown = all.map((other) => [other, other.object.visible] as const);
    for (const [other] of shown) other.object.visible = false;
    const before = this.rig.extent();
    const pose = this.rig.pose();
    const insets = this.rig.setInsets(NO_INSETS);
    if (this.home) this.rig.setPoints(this.home.points, this.home.radius);
    this.rig.setAspect(w / h);
    this.rig.setPose(this.rig.fittedPose('home'));
    this.stage.setLook(false, this.look.dark);
    this.renderOne({ x: 0, y: clientHeight - h, width: w, height: h });
    const picture = cut(this.canvas, w, h, this.renderer.getPixelRatio());
    this.stage.setLook(this.look.floor, this.look.dark);
    for (const [other, visible] of shown) other.object.visible = visible;
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
