/** Content of the views: one shape per view, onion skins or a film strip, and the ghost mesh. */
import { Group } from 'three';
import type { Camera, WebGLRenderer } from 'three';
import type { KeysInfo } from '../engine/api/types.ts';
import { GhostView } from './ghost.ts';
import { Shape, topologyOf, triangleOf } from './shape.ts';
import type { Topology } from './shape.ts';
import { makePrograms } from './programs.ts';
import type { Studio } from './studio.ts';
import { decodeTextures } from './textures.ts';
import type { Extra, FirstKey, GhostPicture, Look } from './types.ts';

/** Longest time that the first image waits for textures. */
const TEXTURES_MS = 200;
const DEFAULT_LOOK: Look = { colouring: 'texture', shading: 'smooth', wireframe: false, floor: true, dark: false };

/**
 * Layers of the scene. Light and floor are on the default layer 0. Next come the shapes of at most six views, then
 * their onion skins or film strips.
 */
export const FIRST_SHAPE = 2;
export const FIRST_EXTRAS = 8;
/** Number of layers for shapes, and for extras. */
export const MAX_VIEWS = FIRST_EXTRAS - FIRST_SHAPE;

/** An import whose first key is shown while its motion is made. */
interface Preview {
  of: KeysInfo;
  topology: Topology;
  textured: Promise<void>;
  shape: Shape;
  colour: string;
}

export class Contents {
  readonly object = new Group();
  /** The open content, hidden while the first key of an import is shown alone. */
  private readonly open = new Group();
  private opening: Preview | null = null;
  /** The import that `topology` belongs to. */
  private of: KeysInfo | null = null;
  private topology: Topology | null = null;
  private shapes: Shape[] = [];
  /** Additional shapes, indexed by view. */
  private extras: Shape[][] = [];
  private ghost: GhostView | null = null;
  private warming: Shape | null = null;
  private colours: string[] = [];
  private extraColours: string[][] = [];
  private current = DEFAULT_LOOK;
  private patchColours: Float32Array | null = null;
  private hideShapes = false;

  /** `onTextures`: called when textures are decoded, after the shapes are shown. */
  constructor(
    private readonly studio: Studio,
    private readonly onTextures: () => void,
  ) {
    this.object.add(this.open);
  }

  get look(): Look {
    return this.current;
  }

  get views(): number {
    return this.opening ? 1 : this.shapes.length;
  }

  /** Whether a film strip is shown instead of the moving shapes. */
  get isStrip(): boolean {
    return this.hideShapes && !this.opening;
  }

  /** Textures of the open import. */
  private ownTextures: Promise<void> = Promise.resolve();

  /** Resolves once the textures of the shown import are decoded. */
  get textured(): Promise<void> {
    return this.opening?.textured ?? this.ownTextures;
  }

  /**
   * Before the first shape, draws a triangle without area with the materials for `info`. The graphics card then
   * compiles its programs early and keeps them between imports. Resolves once all are requested and, if the card can
   * report it, compiled.
   */
  async warm(info: KeysInfo, renderer: WebGLRenderer, camera: Camera): Promise<void> {
    this.prepare(info);
    // A material with a texture uses another program.
    await Promise.race([this.ownTextures, new Promise((resolve) => setTimeout(resolve, TEXTURES_MS))]);
    if (this.topology) this.warming = this.addShape(triangleOf(this.topology), FIRST_SHAPE);
    if (this.warming) await makePrograms(renderer, this.warming.surface, camera);
  }

  /**
   * A new import with fresh buffers. If its first key is shown, reuses its buffers and keeps the key visible until the
   * first frame.
   */
  setImport(info: KeysInfo): void {
    const opening = this.opening?.of === info ? this.opening : null;
    if (!opening) this.hideFirstKey();
    this.prepare(info, opening);
    if (!opening) return;
    this.opening = null;
    this.open.visible = true;
    this.open.add(opening.shape.object);
    this.shapes = [opening.shape];
    this.colours[0] = opening.colour;
  }

  /**
   * Shows an import's first key instead of the open content, which is kept. The key is hidden until its textures are
   * ready, so it is drawn only once.
   */
  showFirstKey({ info, positions, normals, colour }: FirstKey): void {
    this.hideFirstKey();
    // The import of a first visit is already prepared.
    const own = this.of === info ? this.topology : null;
    const topology = own ?? topologyOf(info);
    const shape = this.addShape(topology, FIRST_SHAPE, this.object);
    shape.setFrame(positions, normals);
    shape.object.visible = false;
    this.open.visible = false;
    const opening = { of: info, topology, textured: this.ownTextures, shape, colour };
    this.opening = opening;
    if (!own) opening.textured = this.loadTextures(topology);
    opening.textured = opening.textured.then(() => {
      shape.object.visible = true;
      this.onTextures();
    });
    this.applyColours();
  }

  /** Shows the previous content again. */
  hideFirstKey(): void {
    const { opening } = this;
    if (!opening) return;
    opening.shape.dispose();
    if (opening.topology !== this.topology) disposeTextures(opening.topology);
    this.opening = null;
    this.open.visible = true;
  }

  /** Makes the buffers for an import and starts decoding its textures. */
  private prepare(info: KeysInfo, opening: Preview | null = null): void {
    if (this.of === info && this.shapes.length === 0) return;
    this.of = info;
    this.clear();
    disposeTextures(this.topology);
    this.topology = opening?.topology ?? topologyOf(info);
    this.patchColours = null;
    this.ownTextures = opening?.textured ?? this.loadTextures(this.topology);
  }

  /** Whether a shape is shown. */
  get isShown(): boolean {
    return this.drawn.some(({ object }) => object.visible) || (!this.opening && this.extras.flat().length > 0);
  }

  /** Sets the number of shapes side by side; existing shapes keep their frames. */
  setViews(count: number): void {
    if (!this.topology) return;
    while (this.shapes.length > count) this.shapes.pop()?.dispose();
    while (this.shapes.length < count) {
      const shape = this.addShape(this.topology, FIRST_SHAPE + this.shapes.length);
      shape.setPatchColours(this.patchColours);
      shape.setLook(this.current);
      shape.object.visible = false;
      this.shapes.push(shape);
    }
  }

  /** Ignores a frame of a previous import that arrives late. */
  setFrame(view: number, positions: Float32Array, normals: Float32Array, colour: string): void {
    const shape = this.shapes[view];
    if (!shape || !this.fits(positions)) return;
    shape.setFrame(positions, normals);
    if (this.warming) this.warming.object.visible = false;
    shape.object.visible = true;
    this.colours[view] = colour;
    this.applyColours();
  }

  /** Onion skins or a film strip for each view; `instead` hides the moving shapes. */
  setExtras(extras: readonly (readonly Extra[])[], instead = false): void {
    if (!extras.flat().every(({ positions }) => this.fits(positions))) return;
    const views = Math.max(extras.length, this.extras.length);
    for (let view = 0; view < views; view += 1) this.setExtrasOf(view, extras[view] ?? []);
    this.hideShapes = instead;
  }

  private setExtrasOf(view: number, extras: readonly Extra[]): void {
    const shapes = this.extras[view] ?? [];
    this.extras[view] = shapes;
    while (shapes.length > extras.length) shapes.pop()?.dispose();
    while (shapes.length < extras.length && this.topology)
      shapes.push(this.addShape(this.topology, FIRST_EXTRAS + view));
    this.extraColours[view] = extras.map(({ colour }) => colour);
    extras.forEach((extra, index) => {
      const shape = shapes[index];
      if (!shape) return;
      shape.setFrame(extra.positions, extra.normals);
      shape.setOpacity(extra.opacity);
      shape.setLook(this.lookOf(extra.opacity));
      shape.setColour(extra.colour);
      shape.object.position.x = extra.offset;
    });
  }

  /** Patch colours on the shape: 3 x vertices, linear RGB; null removes them. */
  setPatchColours(colours: Float32Array | null): void {
    this.patchColours = colours;
    for (const shape of this.shapes) shape.setPatchColours(colours);
    this.setLook(this.current);
  }

  /** Heat colours on a view's shape: 3 x vertices, linear RGB; null removes them. */
  setHeatColours(colours: Float32Array | null, view: number): void {
    const shape = this.shapes[view];
    if (!shape || (colours && !this.fits(colours))) return;
    shape.setHeatColours(colours);
    shape.setLook(this.current);
    this.applyColours();
  }

  /** Marks faces of the first view's shape; null removes the mark. */
  setMark(faces: readonly number[] | null): void {
    const corners = this.topology?.index.array;
    if (!corners) return;
    const index =
      faces &&
      Uint32Array.from({ length: 3 * faces.length }, (_, i) => corners[3 * faces[Math.floor(i / 3)]! + (i % 3)]!);
    this.shapes[0]?.setMark(index);
  }

  /** The ghost mesh of the first view's shape at the drawn time; null removes it. */
  setGhost(ghost: GhostPicture | null): void {
    const shape = this.shapes[0];
    if (!ghost || !this.ghost?.fits(ghost)) {
      this.ghost?.dispose();
      this.ghost = ghost && new GhostView(ghost, this.studio, FIRST_SHAPE);
      if (this.ghost) this.open.add(this.ghost.object);
    }
    if (ghost && shape) this.ghost?.setFrame(ghost, shape.positions, this.current.dark);
  }

  setLook(look: Look): void {
    this.current = look;
    for (const shape of this.shapes) shape.setLook(look);
    this.opening?.shape.setLook(look);
    for (const shape of this.extras.flat()) shape.setLook(this.lookOf(shape.opacity));
    this.applyColours();
  }

  /** A copy of the positions drawn in a view; empty before the first frame. */
  positions(view: number): Float32Array {
    const shape = this.drawn[view];
    return shape?.object.visible ? shape.positions.slice() : new Float32Array();
  }

  /** A vertex of the first view's shape; empty before its first frame and while an import is being opened. */
  vertex(index: number): Float32Array {
    const shape = this.shapes[0];
    return shape?.object.visible && !this.opening
      ? shape.positions.slice(3 * index, 3 * index + 3)
      : new Float32Array();
  }

  /** At most this many vertices of the first view's shape; none before its first frame. */
  sample(count: number): Float32Array {
    const shape = this.drawn[0];
    if (!shape?.object.visible) return new Float32Array();
    const all = shape.positions;
    const step = 3 * Math.max(Math.floor(all.length / 3 / count), 1);
    return Float32Array.from(
      { length: 3 * Math.ceil(all.length / step) },
      (_, i) => all[Math.floor(i / 3) * step + (i % 3)]!,
    );
  }

  /**
   * Layer masks of a view. Later layers are drawn over earlier ones, for example the shape over its onion skins. The
   * ghost belongs to the first view's motion.
   */
  layersOf(view: number): number[] {
    const around = 1;
    const shape = 1 << (FIRST_SHAPE + view);
    const extras = 1 << (FIRST_EXTRAS + view);
    if (this.isStrip) return [around | extras];
    return this.extras[view]?.length ? [around | extras, shape] : [around | shape];
  }

  /** A separate shape for an image, which the caller disposes of; null for a frame of another import. */
  shapeOf(positions: Float32Array, normals: Float32Array, colour: string): Shape | null {
    if (!this.topology || !this.fits(positions)) return null;
    const shape = new Shape(this.topology, this.studio);
    shape.setFrame(positions, normals);
    shape.setLook({ ...this.current, wireframe: false });
    shape.setColour(colour);
    return shape;
  }

  clear(): void {
    for (const shape of [...this.shapes, ...this.extras.flat()]) shape.dispose();
    this.shapes = [];
    this.extras = [];
    this.ghost?.dispose();
    this.ghost = null;
    this.hideShapes = false;
  }

  dispose(): void {
    this.hideFirstKey();
    this.clear();
    this.warming?.dispose();
    disposeTextures(this.topology);
    this.topology = null;
  }

  /** The first key of an import, or the shapes of the views. */
  private get drawn(): readonly Shape[] {
    return this.opening ? [this.opening.shape] : this.shapes;
  }

  private fits(positions: Float32Array): boolean {
    return positions.length === 3 * (this.topology?.vertices ?? -1);
  }

  /** A skin is transparent, and its colour shows its time. */
  private lookOf(opacity: number): Look {
    const { colouring } = this.current;
    const coloured = opacity < 1 || colouring === 'patches';
    return { ...this.current, colouring: coloured ? 'phase' : colouring, wireframe: false };
  }

  private addShape(topology: Topology, layer: number, into = this.open): Shape {
    const shape = new Shape(topology, this.studio, layer);
    shape.setLook(this.current);
    into.add(shape.object);
    return shape;
  }

  private applyColours(): void {
    this.shapes.forEach((shape, index) => shape.setColour(this.colours[index] ?? '#888888'));
    this.opening?.shape.setColour(this.opening.colour);
    this.extras.forEach((shapes, view) =>
      shapes.forEach((shape, index) => shape.setColour(this.extraColours[view]?.[index] ?? '#888888')),
    );
  }

  private async loadTextures(topology: Topology): Promise<void> {
    const textures = await decodeTextures(topology.scene.images, topology.scene.materials);
    if (topology !== this.topology && topology !== this.opening?.topology) return;
    topology.textures = textures;
    this.setLook(this.current);
    this.onTextures();
  }
}

function disposeTextures(topology: Topology | null): void {
  for (const texture of topology?.textures ?? []) texture?.dispose();
}
