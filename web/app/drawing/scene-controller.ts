/** Passes shapes from the sequences to the viewer, by time, document and look. */
import { METHOD } from '../../engine/api/methods.ts';
import type { Shape } from '../../engine/api/api.ts';
import type { Frame, Ghost, KeysInfo, TimingRegion } from '../../engine/api/types.ts';
import { regionOfFaces } from '../../model/timing-regions.ts';
import type { CameraPose, ViewName } from '../../model/camera.ts';
import type { AppState, Doc, View } from '../../model/state.ts';
import type { ColourBarProps } from '../../ui/colour-bar.ts';
import { fittedText, motionWords } from '../../model/method-words.ts';
import { OFF_CURVE, PHASE_COLOURS, phaseOf } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { TileLabel } from '../../ui/tile-labels.ts';
import type { Extra, Look } from '../../viewer/types.ts';
import { Viewer } from '../../viewer/viewer.ts';
import type { ViewerEvents } from '../../viewer/viewer.ts';
import type { FilmName } from './onion-skin.ts';
import type { FilmLabel } from '../../ui/film-labels.ts';
import { filmNames, filmLabelPositions, filmStrips, filmTimes, onionExtras, onionTimes } from './onion-skin.ts';
import type { OnionSkinInput } from './onion-skin.ts';
import type { Difference } from './difference.ts';
import { extentOf } from '../../viewer/bounds.ts';
import type { Extent } from '../../viewer/bounds.ts';
import type { HeatMap } from './heat-map.ts';
import { besideOf, wantsHeat } from './heat-wanted.ts';
import { measure } from './measures.ts';
import type { Measure } from './measures.ts';
import type { Original } from './original.ts';
import { pickFace } from './pick-face.ts';
import { patchColours } from '../../viewer/patch-colours.ts';
import { vertexNormals } from './vertex-normals.ts';
import type { FrameSet, RunningMotion } from '../../playback/frame-set.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { LoadedKeys } from '../session/workspace.ts';

/**
 * While playing, the shape has the colour of a key if the time is this close to the key (as a share of the range),
 * because a frame rarely hits it exactly.
 */
export const PLAYING_TOLERANCE = 0.006;
/** While playing, shapes larger than this are measured only every MEASURE_MS. */
const MEASURED_FACES = 60_000;
const MEASURE_MS = 200;
/** Distance between the shape and its ghost, in widths of the shape. */
const BESIDE = 1.12;
/** Views narrower than this, in CSS pixels, have little room for names. */
const NARROW_PX = 220;
/** Height of the names under a film strip, including spacing. */
const NAMES_PX = 24;
/** This colour differs from those of keys, interpolated and extrapolated shapes. */
const ORIGINAL_COLOUR = '#8f8f8f';
const THUMBNAIL = { width: 88, height: 60 };
const TIME_PICTURE = { width: 132, height: 90 };

interface Film {
  /** The document that the strips show. */
  of: Doc;
  /** The requested number of shapes. */
  count: View['filmShapes'];
  views: number;
  /** All strips' shapes, at their positions. */
  shapes: Float32Array[];
  names: FilmName[];
  /** Label positions per view. */
  places: Float32Array[];
  /** The camera before the strip; null if nothing was shown before. */
  before: CameraPose | null;
}

export class SceneController {
  readonly viewer: Viewer;
  labels: TileLabel[] = [];
  /** The heat map, loaded with the first use of heat colours. */
  private heatMap: HeatMap | null = null;
  /** The animation beside the motions, or null. */
  private original: Original | null = null;
  private look: Look | null = null;
  private floorless = false;
  private info: KeysInfo | null = null;
  private pool: PosePool | null = null;
  private base: Measure | null = null;
  /** Time of the last measurement of volume and area. */
  private measuredAt = 0;
  /** What the colours of patches or regions belong to. */
  private patchesOf: Shape | TimingRegion[] | null = null;
  private film: Film | null = null;
  private hasOnion = false;
  /** The import has been shown in a view other than a film strip. */
  private ordinary = false;
  private readonly onCamera: ViewerEvents['onCamera'];
  private named = false;
  private ghost: { of: Shape; mesh: Ghost | null } | null = null;
  /** Width of the import's poses along x. */
  private width = 0;
  /** Current distance of the ghost from the shape along x. */
  private beside: number | null = null;
  /** The first key of the files being opened, if it is shown. */
  private opening: { info: KeysInfo; extent: Extent } | null = null;

  constructor(
    host: HTMLElement,
    events: ViewerEvents,
    private readonly onNames: (names: readonly FilmLabel[]) => void,
  ) {
    // While the first key of other files is shown, the camera does not belong to the open shape.
    this.onCamera = (pose) => {
      if (!this.opening) events.onCamera(pose);
    };
    this.viewer = new Viewer(host, {
      ...events,
      onCamera: this.onCamera,
      onResize: () => {
        this.place();
        events.onResize();
      },
    });
    this.viewer.follow(() => this.placeNames());
  }

  get colourBar(): ColourBarProps | null {
    return (this.opening ? null : this.heatMap?.bar) ?? null;
  }

  /** The labels over the views. */
  get shownLabels(): TileLabel[] {
    return this.opening ? [] : this.labels;
  }

  /** The difference of two motions shown by the colours of the first view; null if they show none. */
  get difference(): Difference | null {
    return this.heatMap?.difference ?? null;
  }

  /** Positions the labels over the views. */
  private place(): void {
    const rects = this.viewer.seen();
    this.labels = this.labels.map((label, index) => ({ ...label, ...rects[index] }));
    if (!this.heatMap?.bar) return;
    this.heatMap.bar = { ...this.heatMap.bar, ...besideOf(rects[0]!, this.viewer.rects()[0]) };
  }

  /** Announces an import that is set once its motion exists. */
  expect(info: KeysInfo): void {
    this.viewer.expect(info);
  }

  /** Shows only the first key of the files being opened; the open shape stays in memory. */
  showFirstKey({ info, doc, pool, camera }: LoadedKeys): void {
    this.opening = { info, extent: extentOf(pool.poses(pool.imported)) };
    const pose = doc.keys[0]?.pose ?? 0;
    const positions = pool.keys.positions(pose);
    const normals = (pose === 0 && pool.keys.normals()) || vertexNormals(positions, info.faces);
    this.viewer.showFirstKey({ info, positions, normals, colour: PHASE_COLOURS.key }, this.opening.extent, camera);
    this.placeNames();
  }

  /** Shows the open shape again, unchanged. */
  hideFirstKey(): void {
    if (!this.opening) return;
    this.viewer.hideFirstKey();
    this.opening = null;
    this.placeNames();
  }

  /** Sets a new import with another mesh and size. `camera` keeps a view from a link. */
  setImport(info: KeysInfo, pool: PosePool, camera: View['camera']): void {
    this.original = null;
    this.info = info;
    this.pool = pool;
    this.patchesOf = null;
    this.film = null;
    this.hasOnion = false;
    this.ordinary = false;
    this.ghost = null;
    this.beside = null;
    this.labels = [];
    this.heatMap?.clear();
    const opening = this.opening?.info === info ? this.opening : null;
    this.opening = null;
    const { bounds, points } = opening?.extent ?? extentOf(pool.poses(pool.imported));
    const looksElsewhere = opening !== null && !this.viewer.isFitted;
    this.width = bounds.max[0] - bounds.min[0];
    this.base = measure(pool.keys.positions(0), info.faces);
    this.viewer.setImport(info, bounds, points);
    this.viewer.setViews(1);
    if (looksElsewhere) return;
    if (camera) this.viewer.setCameraPose(camera);
    else this.viewer.fit('home', false);
  }

  /** Fits the view to the keys and to the drawn shape, which may extend beyond them. */
  fit(view: ViewName | null, eased: boolean): void {
    if (this.opening) return this.viewer.fit(view, eased);
    if (!this.pool) return;
    this.setExtent(this.film?.shapes ?? this.withGhost(this.shown()));
    this.viewer.fit(view, eased);
  }

  private setExtent(shapes: Iterable<Float32Array>): void {
    const { bounds, points } = extentOf(shapes);
    this.viewer.setExtent(bounds, points);
  }

  /** Yields the keys' poses and the drawn shape one at a time, because they are large. */
  private *shown(): Generator<Float32Array> {
    yield* this.pool?.poses() ?? [];
    for (let view = 0; view < this.viewer.views; view += 1) {
      const positions = this.viewer.positions(view);
      if (positions.length > 0) yield positions;
    }
  }

  /** Copies the frames of a time to the screen, with their overlays. */
  async show(set: FrameSet, state: AppState, range: Range): Promise<void> {
    const { t, blend, frames, sequences } = set;
    const input = onionSkinInput(t, state, range);
    const phase = blend
      ? OFF_CURVE
      : phaseOf({ ...input, tolerance: state.play.playing ? PLAYING_TOLERANCE : undefined });
    // The ghost is known only at evaluated times.
    const led = blend ? undefined : sequences[0];
    const views = sequences.length + (this.original ? 1 : 0);
    if (this.viewer.views !== views) this.setViews(views);
    frames.forEach((frame, view) =>
      this.viewer.setFrame(view, frame.positions, frame.normals, PHASE_COLOURS[phase.kind]),
    );
    const original = this.original?.(t);
    if (original) this.viewer.setFrame(sequences.length, original.positions, original.normals, ORIGINAL_COLOUR);
    if (!this.heatMap && wantsHeat(sequences, state.view)) {
      const { info } = this;
      const { HeatMap: Loaded } = await import('./heat-map.ts');
      // Another import may have replaced this one.
      if (this.info !== info) return;
      this.heatMap ??= new Loaded(this.viewer);
    }
    if (this.info && this.pool) this.heatMap?.show(set, state, this.info, this.pool, original?.positions ?? null);
    const measures = this.measuresNow(state.play.playing) || this.labels.length !== views;
    this.labels = views > 1 ? this.tileLabels(frames, sequences, original?.positions, measures) : [];
    await this.showGhost(t, led, state.view);
    await this.showOnionSkins(input, sequences, state);
    if (this.film) this.labels = this.labels.map((label) => ({ ...label, detail: '' }));
    this.place();
    await this.showPatches(sequences[0]?.sequence.shape, state);
  }

  /** The animation beside the motions, or null. */
  get shownOriginal(): Original | null {
    return this.original;
  }

  /** Shows the animation beside the motions from the next frame on; null hides it. */
  setOriginal(original: Original | null): void {
    this.original = original;
  }

  setLook(view: View, dark: boolean): void {
    const { colouring, shading, wireframe, floor, split } = view;
    this.look = { colouring: colouring === 'regions' ? 'patches' : colouring, shading, wireframe, floor, dark };
    this.applyLook();
    this.viewer.setSplit(split);
    this.place();
  }

  /** Hides or shows the floor, for images of the shape alone. */
  setFloorless(floorless: boolean): void {
    this.floorless = floorless;
    this.applyLook();
  }

  /** A divider separates two motions. */
  get isSplit(): boolean {
    return this.viewer.isSplit;
  }

  private applyLook(): void {
    if (this.look) this.viewer.setLook({ ...this.look, floor: this.look.floor && !this.floorless });
  }

  get outOfView(): boolean {
    return !this.viewer.seesShape();
  }

  /** The face at a point of the canvas, in CSS pixels; -1 if none. */
  pick(x: number, y: number): number {
    const at = this.film || this.opening ? null : this.viewer.rayAt(x, y);
    return at && this.info ? pickFace(this.viewer.positions(at.view), this.info.faces, at.ray) : -1;
  }

  thumbnail(frame: Frame): string {
    return this.viewer.thumbnail(frame.positions, frame.normals, THUMBNAIL.width, THUMBNAIL.height, PHASE_COLOURS.key);
  }

  /** An image of the shape at a time of the timeline. */
  timePicture(frame: Frame, state: AppState, range: Range): string {
    const { kind } = phaseOf(onionSkinInput(frame.t, state, range));
    const { width, height } = TIME_PICTURE;
    return this.viewer.thumbnail(frame.positions, frame.normals, width, height, PHASE_COLOURS[kind]);
  }

  /** Other tiles have another shape, so the view is fitted again from the current direction. */
  private setViews(count: number): void {
    this.viewer.setViews(count);
    this.viewer.fit(null, false);
  }

  private tileLabels(
    frames: readonly Frame[],
    sequences: readonly RunningMotion[],
    original: Float32Array | undefined,
    measures: boolean,
  ): TileLabel[] {
    const rects = this.viewer.seen();
    const sizes = sequences.filter(({ ghost }) => ghost > 0).length > 1;
    const tiles = sequences.map((running, index) => ({
      title: sizes ? sizeName(running, rects[index]?.width ?? 0) : titleOf(running, this.viewer.isSplit),
      positions: frames[index]?.positions,
    }));
    if (original) tiles.push({ title: 'The animation', positions: original });
    return tiles.map(({ title, positions }, index) => {
      const { x, y, width } = rects[index] ?? { x: 0, y: 0, width: 0 };
      const known = measures ? this.measures(positions) : this.labels[index]!;
      const { volume, detail } = sizes ? { volume: '', detail: '' } : known;
      return { title, volume, detail, x, y, width };
    });
  }

  /** A shape at rest is always measured. */
  private measuresNow(playing: boolean): boolean {
    const now = performance.now();
    const large = (this.info?.report.faces ?? 0) > MEASURED_FACES;
    if (playing && large && now - this.measuredAt < MEASURE_MS) return false;
    this.measuredAt = now;
    return true;
  }

  private measures(positions: Float32Array | undefined): Pick<TileLabel, 'volume' | 'detail'> {
    if (!positions || !this.base || !this.info) return { volume: '', detail: '' };
    const { volume, area } = measure(positions, this.info.faces);
    const percent = (value: number, base: number, digits: number): string =>
      base === 0 ? '?' : `${((100 * value) / base).toFixed(digits)}\u00a0%`;
    return {
      volume: percent(volume, this.base.volume, 0),
      detail: `volume ${percent(volume, this.base.volume, 1)}, area ${percent(area, this.base.area, 1)}`,
    };
  }

  private async showOnionSkins(
    input: OnionSkinInput,
    sequences: readonly RunningMotion[],
    { view, doc }: AppState,
  ): Promise<void> {
    if (!view.film) this.leaveFilm();
    if (!view.onion && !view.film) {
      if (this.hasOnion) this.viewer.setExtras([]);
      this.hasOnion = false;
      return;
    }
    // The strip does not depend on the time, so it is made once per document.
    if (view.film && this.isFilmOf(doc, view, sequences.length)) return;
    const times = view.film ? filmTimes(input, view.filmShapes) : onionTimes(input, view);
    const frames = await Promise.all(sequences.map(({ sequence }) => sequence.evaluateMany(times)));
    const skins = view.film ? filmStrips(input, frames) : frames.map((of) => onionExtras(input, of));
    this.viewer.setExtras(skins, view.film);
    if (view.film) this.enterFilm({ of: doc, count: view.filmShapes, names: filmNames(input, times) }, skins);
    this.hasOnion = view.onion;
    for (const frame of frames.flat()) frame.release();
  }

  private isFilmOf(doc: Doc, { filmShapes }: View, views: number): boolean {
    return this.film?.of === doc && this.film.count === filmShapes && this.film.views === views;
  }

  private enterFilm(made: Pick<Film, 'of' | 'count' | 'names'>, strips: readonly Extra[][]): void {
    const before = this.film ? this.film.before : this.ordinary ? this.viewer.cameraPose() : null;
    const shapes = strips
      .flat()
      .map(({ positions, offset }) => positions.map((value, index) => (index % 3 === 0 ? value + offset : value)));
    const places = strips.map(filmLabelPositions);
    this.film = {
      ...made,
      views: strips.length,
      shapes: [...shapes, ...this.belowNames(shapes, places)],
      places,
      before,
    };
    this.setExtent(this.film.shapes);
    this.viewer.fit('front', true);
  }

  /** A fitted strip leaves room for the names under it. */
  private belowNames(shapes: readonly Float32Array[], places: readonly Float32Array[]): Float32Array[] {
    const { bounds } = extentOf(shapes);
    const room = ((bounds.max[0] - bounds.min[0]) * NAMES_PX) / this.viewer.rects()[0]!.width;
    return places.map((of) => of.map((value, index) => (index % 3 === 1 ? value - room : value)));
  }

  /** Restores the view from before the strip. */
  private leaveFilm(): void {
    this.ordinary = true;
    if (!this.film) return;
    const { before } = this.film;
    this.film = null;
    this.viewer.setExtras([]);
    if (!before) return this.fit('home', true);
    this.setExtent(this.withGhost(this.shown()));
    this.viewer.setCameraPose(before);
    this.onCamera(before);
  }

  /** Names of a film strip's shapes in a view, in canvas pixels. */
  filmLabels(view: number): FilmLabel[] {
    const film = this.opening ? null : this.film;
    const places = film?.places[view];
    if (!film || !places) return [];
    const at = this.viewer.projectDrawn(places, view);
    return film.names.map((name, i) => ({ ...name, x: at[2 * i]!, y: at[2 * i + 1]! }));
  }

  /** On the page, the names move with every drawn frame, because the camera may rotate. */
  private placeNames(): void {
    if (!this.film && !this.named) return;
    this.named = this.film !== null;
    this.onNames(Array.from({ length: this.film?.views ?? 0 }, (_, view) => this.filmLabels(view)).flat());
  }

  private async showGhost(
    t: number,
    running: RunningMotion | undefined,
    { ghostWire, ghostBeside, film }: View,
  ): Promise<void> {
    const wanted = (ghostWire || ghostBeside) && !film && running?.ghost && METHOD[running.method].space === 'lri';
    const led = wanted ? running : null;
    const shape = led?.sequence.shape;
    if (shape && this.ghost?.of !== shape) this.ghost = { of: shape, mesh: await shape.ghost() };
    const mesh = led ? this.ghost?.mesh : null;
    const offset = mesh && ghostBeside ? this.width * BESIDE : null;
    if (led && mesh) {
      const positions = await led.sequence.ghostPositions(t);
      this.viewer.setGhost({ faces: mesh.faces, vertexOf: mesh.vertexOf, positions, overlay: ghostWire, offset });
    } else {
      this.viewer.setGhost(null);
    }
    if (offset === this.beside) return;
    this.beside = offset;
    this.fit(null, true);
  }

  private *withGhost(shapes: Iterable<Float32Array>): Generator<Float32Array> {
    const { beside } = this;
    for (const positions of shapes) {
      yield positions;
      if (beside !== null) yield positions.map((value, i) => (i % 3 === 0 ? value + beside : value));
    }
  }

  private async showPatches(shape: Shape | undefined, { doc, view }: AppState): Promise<void> {
    const { regions } = doc.motion;
    const of = view.colouring === 'regions' ? regions : view.colouring === 'patches' ? shape : null;
    if (!shape || !this.info || !of || this.patchesOf === of) return;
    const { faces, report } = this.info;
    const groups = of === shape ? await shape.patches() : regionOfFaces(regions, faces.length / 3);
    this.patchesOf = of;
    this.viewer.setPatchColours(patchColours(groups, faces, report.vertices));
  }
}

/** Labels ghosts of several sizes (Fig. 7) by size if there is little room. */
function sizeName({ ghost }: RunningMotion, width: number): string {
  if (ghost === 0) return 'No ghost';
  return `${width < NARROW_PX ? '' : 'Ghost of '}${ghost.toLocaleString('en')} faces`;
}

/** Beside a divider, a blend has the name that is familiar to new users. */
function titleOf({ ghost, ...motion }: RunningMotion, split: boolean): string {
  const name = motionWords(motion)[split || ghost > 0 ? 'short' : 'label'];
  const fitted = fittedText(motion.sequence.fitted);
  const title = fitted === '' ? name : `${name}, ${fitted}`;
  return ghost > 0 ? `${title}, ghost mesh of ${ghost.toLocaleString('en')} faces` : title;
}

export function onionSkinInput(t: number, { doc }: AppState, range: Range): OnionSkinInput {
  return { t, keys: doc.keys, range, periodic: doc.motion.boundary === 'periodic' };
}
