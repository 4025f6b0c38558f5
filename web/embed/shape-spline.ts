/** The element <shape-spline>. Importing it has no side effects and works without a DOM. */
import { ghostFor, motionFor } from '../engine/api/method-options.ts';
import { RULES, settled } from '../engine/api/rules.ts';
import { EngineError, isCancelled, messageOf } from '../engine/api/errors.ts';
import type { Keys, Motion } from '../engine/api/api.ts';
import { SEQUENCE_DEFAULTS } from '../engine/api/types.ts';
import type {
  ExportOptions,
  Frame as Shape,
  ImportOptions,
  MeshReport,
  Method,
  SequenceOptions,
} from '../engine/api/types.ts';
import { orbitOf, targetOf } from '../model/camera-words.ts';
import { keyboardStep } from '../model/keyboard-step.ts';
import { METHOD_WORDS } from '../model/method-words.ts';
import { GHOST_FACES } from '../model/state.ts';
import { PHASE_COLOURS, clamp, neighbourKey } from '../model/time-scale.ts';
import type { Phase, PhaseKind, Range } from '../model/time-scale.ts';
import { ATTRIBUTES, PROPERTIES, ROWS, attributeOf, engineCallOf, propertyOf } from './attributes.ts';
import type { Concern, PropertyName, ShapeSplineProperties } from './attributes.ts';
import type { CanvasViewer } from './canvas-viewer.ts';
import type { EventDetails, ShapeSplineEventMap } from './events.ts';
import { Frame } from './frame.ts';
import type { KeysLease } from './motions.ts';
import type { Lease } from './shared.ts';
import { listOf, sourcesOf } from './sources.ts';
import type { KeySource, Sources } from './sources.ts';
import { isDark, lessMotion, watch } from './surroundings.ts';
import { readAttribute, writeAttribute } from './values.ts';

export type { ShapeSplineProperties } from './attributes.ts';
export type { ShapeSplineEventMap } from './events.ts';
export type { KeySource } from './sources.ts';

/** A removed element keeps its state for this long, because moving an element removes and inserts it. */
const GRACE_MS = 500;
/** An element in view without a source reports the missing source after this time. */
const SOURCE_MS = 1000;
/** Share of loading the keys in the total progress. */
const KEYS_SHARE = 0.5;
/** Heights in pixels, at the bottom, of the controls and of the names of compared methods. */
const CONTROLS_PX = 44;
const NAMES_PX = 24;

const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** Loaded for the first element that shows a shape: three.js and the code that calls the engine. */
const heavy = () => Promise.all([import('./canvas-viewer.ts'), import('./motions.ts')]);

export interface ShapeSplineStats {
  /** Number of frames computed for this element and drawn by it. */
  framesComputed: number;
  framesDrawn: number;
  /** Worker time of the last frame, in milliseconds. */
  ms: number;
}

/** The element's own events and those of every HTML element. */
type Events = ShapeSplineEventMap & Omit<HTMLElementEventMap, keyof ShapeSplineEventMap>;

/** Loaded content, ready to be shown. */
interface LoadedSource {
  Viewer: typeof CanvasViewer;
  keys: KeysLease;
  held: Keys;
  methods: readonly Method[];
  motions: Lease<Motion>[];
  sequences: readonly Motion[];
}

export interface ShapeSplineElement extends ShapeSplineProperties {
  addEventListener<N extends keyof Events>(
    type: N,
    listener: (this: ShapeSplineElement, event: Events[N]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<N extends keyof Events>(
    type: N,
    listener: (this: ShapeSplineElement, event: Events[N]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: its properties come from the table.
export class ShapeSplineElement extends Base {
  static readonly observedAttributes = ATTRIBUTES;
  #frame: Frame | null = null;
  #view: CanvasViewer | null = null;
  #keys: KeysLease | null = null;
  #motions: Lease<Motion>[] = [];
  /** The content being loaded. */
  #opening: { keys: KeysLease | null; motions: Lease<Motion>[] } = { keys: null, motions: [] };
  #sequence: Motion | null = null;
  #given: readonly KeySource[] | null = null;
  #info: Keys['info'] | null = null;
  #loading: Promise<void> | null = null;
  /** Number of the newest loading. Older ones end silently. */
  #round = 0;
  #near = false;
  #inView = false;
  #playing = false;
  /** Whether `autoplay` may still start playback; actions of the page or the user take precedence. */
  #mayBegin = true;
  #automatic = false;
  /** Error of the newest loading; null for none. */
  #failure: unknown = null;
  /** The shown time, or the initial time of the next motion; NaN: the start of the motion. */
  #time = NaN;
  /** Range of the shown motion. */
  #range: Range = [NaN, NaN];
  /** The shown keys are not the requested ones. */
  #outdated = false;
  #before = { time: NaN, step: 0, key: -1 };
  #changed = new Set<Concern>();
  #warned = new Set<string>();
  #leaving: ReturnType<typeof setTimeout> | undefined;
  /** Timer until the missing source is reported. */
  #missing: ReturnType<typeof setTimeout> | undefined;
  #watch: (() => void) | null = null;
  #fraction = 0;
  #contextLost = false;
  #dismissed = false;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open', delegatesFocus: true });
    this.#frame = new Frame(root, {
      onToggle: () => (this.paused ? this.play() : this.pause()),
      onSeek: (t) => this.#byHand(t),
      onKey: (event) => this.#pressed(event),
    });
  }

  connectedCallback(): void {
    clearTimeout(this.#leaving);
    // Applies properties that were set before the element was defined.
    for (const name of [...PROPERTIES, 'keys'] as (PropertyName | 'keys')[]) {
      if (!Object.hasOwn(this, name)) continue;
      const value: unknown = this[name];
      delete this[name];
      try {
        Object.assign(this, { [name]: value });
      } catch (error) {
        // No caller can catch this error now.
        console.warn(`<shape-spline>: ${messageOf(error)}`);
      }
    }
    this.#watch ??= watch(this, {
      onNear: (near) => {
        this.#near = near;
        if (near) void this.#load();
      },
      onSeen: (seen) => {
        this.#inView = seen;
        this.#view?.setSeen(seen);
      },
      onChildren: () => this.#change('source'),
      onPreference: () => {
        if (this.#automatic && lessMotion()) this.pause();
        this.#change('look');
      },
    });
    this.#change('page');
    if (this.loading === 'eager') void this.#load();
  }

  disconnectedCallback(): void {
    clearTimeout(this.#missing);
    this.#watch?.();
    this.#watch = null;
    this.#view?.setSeen(false);
    this.#inView = false;
    this.#near = false;
    this.#leaving = setTimeout(() => this.#dispose(), GRACE_MS);
  }

  /** A constructed style sheet applies only in its own document. */
  adoptedCallback(): void {
    this.#frame?.restyle();
  }

  attributeChangedCallback(attribute: string, before: string | null, text: string | null): void {
    const property = propertyOf(attribute);
    if (!property || before === text) return;
    // Report errors immediately, even before anything is loaded.
    this.#read(property);
    if (property === 'currentTime' && text !== null) this.#setTime(this.#read('currentTime') as number);
    else this.#change(ROWS[property].concern);
  }

  /** Takes precedence over `src`: URLs, Blobs or ArrayBuffers of one key each, or of one file with all keys. */
  get keys(): readonly KeySource[] | null {
    return this.#given;
  }

  set keys(keys: readonly KeySource[] | null) {
    this.#given = listOf(keys);
    this.#change('source');
  }

  /** Length of the playing range, in seconds on the scale of the key times; NaN before loading. */
  get duration(): number {
    if (!this.#sequence) return NaN;
    const [start, end] = this.range ?? this.#sequence.range;
    return end - start;
  }

  get paused(): boolean {
    return !this.#playing;
  }

  get stats(): ShapeSplineStats {
    const { computed = 0, drawn = 0, ms = 0 } = this.#view?.counts ?? {};
    return { framesComputed: computed, framesDrawn: drawn, ms };
  }

  /** Report on the files; null before loading. */
  get report(): MeshReport | null {
    return this.#info?.report ?? null;
  }

  play(): void {
    this.#mayBegin = false;
    this.#setPlaying(true);
    void this.#load();
  }

  pause(): void {
    this.#mayBegin = false;
    this.#setPlaying(false);
  }

  /** Resolves when this time is drawn, even if the element is out of view. */
  async seek(t: number): Promise<void> {
    if (!Number.isFinite(t)) throw new RangeError('The time for seek must be a finite number.');
    this.#time = t;
    await this.#loaded();
    await this.#view!.seek(t);
    this.#tell('seeked', { currentTime: t });
  }

  /** The shape at t, without showing it. Its `release()` allows its arrays to be reused. */
  async evaluate(t: number): Promise<Shape> {
    return (await this.#loaded()).evaluateAhead(t);
  }

  /** An image of the current view. */
  async toBlob({ type = 'image/png', quality }: { type?: string; quality?: number } = {}): Promise<Blob> {
    await this.#loaded();
    const blob = await new Promise<Blob | null>((done) => {
      this.#view!.viewer.snapshot((canvas) => canvas.toBlob(done, type, quality));
    });
    // Browsers write unknown types as PNG.
    if (blob?.type !== type) throw new EngineError('invalid-option', `This browser cannot write ${type}.`);
    return blob;
  }

  /** A GLB with the motion as a morph-target animation, which the app opens as a project. */
  async exportGLB(options: Partial<Omit<ExportOptions, 'format'>> = {}): Promise<Blob> {
    const [file] = await (await this.#loaded()).export({ ...options, format: 'glb' });
    return new Blob([file!.bytes as Uint8Array<ArrayBuffer>], { type: 'model/gltf-binary' });
  }

  dismissPoster(): void {
    this.#dismissed = true;
    this.#page();
  }

  /** Resolves with the current motion after all changes. */
  async #loaded(): Promise<Motion> {
    await null;
    for (let loading: Promise<void> | null = null; loading === null || loading !== this.#loading; ) {
      if (!this.isConnected) throw new EngineError('not-connected', 'The element is not in the document.');
      if (this.#sources().list.length === 0) throw noSource();
      loading = this.#load();
      await loading;
    }
    if (this.#failure) throw this.#failure;
    return this.#sequence!;
  }

  /** Value of the property: its attribute parsed by the table, with one warning if invalid. */
  #read(property: PropertyName): unknown {
    const text = this.getAttribute(attributeOf(property));
    const { value, problem } = readAttribute(ROWS[property], text);
    if (problem && !this.#warned.has(`${property} ${text}`)) {
      this.#warned.add(`${property} ${text}`);
      console.warn(`<shape-spline>: ${attributeOf(property)}="${text}" ${problem}.`);
    }
    return value;
  }

  /** Getter of the properties in the table. */
  static read(element: ShapeSplineElement, property: PropertyName): unknown {
    if (property === 'currentTime' && !Number.isNaN(element.#time)) return element.#view?.time ?? element.#time;
    return element.#read(property);
  }

  static write(element: ShapeSplineElement, property: PropertyName, value: unknown): void {
    if (property === 'currentTime') {
      if (value === null || value === undefined) return element.removeAttribute('current-time');
      // Frameworks pass text as written in the markup.
      const t = Number(value);
      if (!Number.isFinite(t)) throw new TypeError('currentTime must be a finite number.');
      return element.#setTime(t);
    }
    const text = writeAttribute(ROWS[property], value);
    if (text === null) element.removeAttribute(attributeOf(property));
    else element.setAttribute(attributeOf(property), text);
  }

  #setTime(t: number): void {
    this.#time = t;
    this.#view?.follow(t);
  }

  #byHand(t: number): void {
    this.pause();
    this.#setTime(t);
  }

  #tell<N extends keyof EventDetails>(type: N, detail: EventDetails[N]): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Several changes in one task are handled together. */
  #change(concern: Concern): void {
    // A new source starts at its own initial time.
    if (concern === 'source' && this.#sequence) [this.#time, this.#outdated] = [NaN, true];
    if (this.#changed.size === 0) queueMicrotask(() => this.#apply());
    this.#changed.add(concern);
  }

  #apply(): void {
    const changed = this.#changed;
    this.#changed = new Set();
    const again = changed.has('source') || changed.has('motion');
    if (again) this.#loading = null;
    if (!this.isConnected) return;
    if (changed.has('source') && this.#sequence) {
      this.#mayBegin = true;
      // Pause the shown content.
      this.#view?.setSeen(false);
    }
    this.#page();
    if (this.#near || this.loading === 'eager') void this.#load();
    if (!again && this.#view && this.#sequence) {
      this.#settings(this.#view);
      this.#begin();
    }
  }

  #page(): void {
    const frame = this.#frame!;
    frame.setLabel(this.alt);
    frame.controls.hidden = !this.controls;
    const hidden = this.#dismissed || (this.reveal === 'auto' && this.#sequence !== null);
    frame.setPoster(this.poster, !hidden || (this.#contextLost && this.poster !== ''));
    frame.setPlaying(this.#playing);
    frame.setTurnable(this.#turnable, this.controls || this.autoplay);
  }

  get #turnable(): boolean {
    return this.hasAttribute('camera-controls') ? this.cameraControls : this.controls;
  }

  #sources(): Sources {
    return sourcesOf(this.#given, this.src, this);
  }

  #load(): Promise<void> {
    if (!this.isConnected) return Promise.resolve();
    clearTimeout(this.#missing);
    if (this.#sources().list.length === 0) {
      // Scripts may set keys slightly later.
      this.#missing = setTimeout(() => this.#fail(noSource()), SOURCE_MS);
      return Promise.resolve();
    }
    this.#loading ??= this.#open();
    return this.#loading;
  }

  async #open(): Promise<void> {
    this.#round += 1;
    const round = this.#round;
    const current = (): boolean => round === this.#round;
    this.#fraction = 0;
    this.#failure = null;
    this.#frame!.setMessage(null);
    try {
      const opened = await this.#fetch(current);
      if (opened && current()) await this.#show(opened, current);
    } catch (error) {
      if (!current() || isCancelled(error)) return;
      this.#failure = error;
      this.#giveBack();
      this.#fail(error);
    }
  }

  /** Keys and motions for the attributes; null if these changed meanwhile. */
  async #fetch(current: () => boolean): Promise<LoadedSource | null> {
    const [{ CanvasViewer }, { takeKeys, takeMotion }] = await heavy();
    if (!current()) return null;
    const from = (share: number) => (part: { stage: string; fraction: number }) =>
      this.#progress(current, part.stage, share + KEYS_SHARE * part.fraction);
    const sources = this.#sources();
    const keys = takeKeys(sources, this.baseURI, this.#options('import') as ImportOptions, from(0));
    // Releases the previous objects only now, so shared ones are reused.
    this.#opening.keys?.release();
    this.#opening.keys = keys;
    const held = await keys.value;
    if (!current()) return null;
    const given: Partial<SequenceOptions> = this.#options('sequence');
    const merged = { ...SEQUENCE_DEFAULTS, ...held.info.project, ...given };
    const { options, left } = settled(merged, (option) => given[option] !== undefined);
    for (const { dropped } of left)
      console.warn(`<shape-spline>: left out ${RULES[dropped].words}, which the attributes exclude.`);
    if (this.ghost && !options.ghostFaces) options.ghostFaces = GHOST_FACES;
    const { method } = options;
    const methods = [method, ...this.compare.filter((one) => one !== method)];
    const times = this.keyTimes ?? sources.times;
    const motions = methods.map((one) => {
      const own = one === method ? options : motionFor(ghostFor(options, one), { method: one });
      return takeMotion({ keys, times, options: own }, from(KEYS_SHARE));
    });
    for (const lease of this.#opening.motions) lease.release();
    this.#opening.motions = motions;
    const sequences = await Promise.all(motions.map(({ value }) => value));
    return { Viewer: CanvasViewer, keys, held, methods, motions, sequences };
  }

  /** Releases the content being loaded. */
  #giveBack(): void {
    for (const lease of [this.#opening.keys, ...this.#opening.motions]) lease?.release();
    this.#opening = { keys: null, motions: [] };
  }

  async #show(
    { Viewer, keys, held, methods, motions, sequences }: LoadedSource,
    current: () => boolean,
  ): Promise<void> {
    this.#view ??= this.#newView(Viewer);
    const view = this.#view;
    for (const lease of [this.#keys, ...this.#motions]) lease?.release();
    [this.#keys, this.#motions] = [keys, motions];
    this.#opening = { keys: null, motions: [] };
    this.#info = held.info;
    this.#sequence = sequences[0]!;
    this.#frame!.setNames(methods.length > 1 ? methods.map((method) => METHOD_WORDS[method].short) : []);
    const t = this.#timeWithin(this.#shownRange());
    this.#outdated = false;
    view.setSeen(true);
    this.#settings(view);
    const drawn = view.open(
      held,
      sequences.map((sequence, i) => ({ sequence, method: methods[i]!, ghost: 0 })),
      t,
    );
    this.#colour(view);
    await drawn;
    if (!current()) return;
    this.#progress(current, 'drawn', 1);
    this.#frame!.setProgress(null);
    this.#page();
    const { vertices, faces } = held.info.report;
    this.#tell('load', { vertices, faces, keyTimes: [...this.#sequence.keyTimes] });
    this.#begin();
    view.setPlaying(this.#playing);
    view.setSeen(this.#inView);
  }

  /** Initial or previous time. A previous time within the old range is clamped to the new one. */
  #timeWithin(range: Range): number {
    const [first, last] = this.#range;
    if (Number.isNaN(this.#time)) return this.hasAttribute('current-time') ? this.currentTime : range[0];
    return first <= this.#time && this.#time <= last ? clamp(this.#time, range[0], range[1]) : this.#time;
  }

  /** Starts playback for `autoplay`, unless the user prefers reduced motion. */
  #begin(): void {
    if (!this.#mayBegin || !this.autoplay || lessMotion()) return;
    this.#mayBegin = false;
    this.#setPlaying(true);
    this.#automatic = true;
  }

  #newView(Viewer: typeof CanvasViewer): CanvasViewer {
    const frame = this.#frame!;
    const covered = (): number => (this.controls ? CONTROLS_PX : 0) + (frame.named ? NAMES_PX : 0);
    const view = new Viewer(frame.viewport, {
      onTime: (t, phase) => this.#shown(t, phase),
      colourOf: (kind) => this.#phaseColour(kind),
      onEnd: () => {
        this.#reach(this.#view!.time);
        this.#tell('loopend', { currentTime: this.#view!.time });
        this.#setPlaying(false);
      },
      onError: (error) => this.#fail(error),
      onContext: (lost) => {
        this.#contextLost = lost;
        this.#page();
      },
      onPlaces: () => frame.placeNames(view.viewer.rects(), covered()),
      covered,
    });
    return view;
  }

  /** The engine options that the page sets. */
  #options(call: 'import' | 'sequence'): Record<string, unknown> {
    const given = PROPERTIES.filter((name) => engineCallOf(name) === call && this.hasAttribute(attributeOf(name)));
    const entries = given.map((name) => {
      const value = this.#read(name);
      // For `sample`, one number is a count and several are times.
      return [name, name === 'sample' && Array.isArray(value) && value.length === 1 ? value[0] : value] as const;
    });
    return Object.fromEntries(entries.filter(([, value]) => value !== null && value !== ''));
  }

  #settings(view: CanvasViewer): void {
    this.#colour(view);
    view.setCamera(this.cameraOrbit ? orbitOf(this.cameraOrbit) : null, targetOf(this.cameraTarget));
    view.turnable = this.#turnable;
    const speed = this.playbackRate * (this.#info?.speed ?? 1);
    view.play = { ...view.play, speed, loop: this.loop || 'once', between: this.range };
    this.#range = this.#shownRange();
    this.#frame!.setKeys(this.#range, this.#sequence!.keyTimes);
  }

  #colour(view: CanvasViewer): void {
    const colouring = this.hasAttribute('colour') ? this.colour : this.color;
    view.setLook({ colouring, dark: isDark(getComputedStyle(this)) });
  }

  /** Colour of a phase from the page's current style. */
  #phaseColour(kind: PhaseKind): string {
    const own = getComputedStyle(this).getPropertyValue(`--shape-spline-${kind}`).trim();
    return CSS.supports('color', own) ? own : PHASE_COLOURS[kind];
  }

  #shownRange(): Range {
    return this.range ?? this.#sequence?.range ?? [0, 1];
  }

  #shown(t: number, phase: Phase): void {
    if (!this.#outdated) this.#time = t;
    this.#frame!.setTime(t, phase.text);
    this.#tell('timeupdate', { currentTime: t });
    const { time, step } = this.#before;
    const next = t - time;
    // Playback that reversed or restarted has passed an end between two frames.
    if (this.#playing && next * step < 0) {
      const end = this.#range[step > 0 ? 1 : 0];
      this.#reach(end);
      this.#tell('loopend', { currentTime: end });
    }
    this.#reach(t);
    const turned = this.loop !== 'bounce' && next * step < 0;
    this.#before = { ...this.#before, time: t, step: turned ? 0 : next };
  }

  #reach(t: number): void {
    const { key } = this.#before;
    const reached = this.#sequence!.keyTimes.filter((one) => one <= t + 1e-9).length - 1;
    this.#before = { ...this.#before, key: reached };
    if (reached !== key && reached >= 0) this.#tell('keychange', { index: reached });
  }

  #setPlaying(playing: boolean): void {
    this.#automatic = false;
    if (playing === this.#playing) return;
    this.#playing = playing;
    this.#before = { ...this.#before, time: NaN, step: 0 };
    this.#view?.setPlaying(playing);
    this.#frame!.setPlaying(playing);
    this.#tell(playing ? 'play' : 'pause', null);
  }

  #progress(current: () => boolean, stage: string, fraction: number): void {
    if (!current() || fraction <= this.#fraction) return;
    this.#fraction = fraction;
    this.#frame!.setProgress(fraction);
    this.#tell('progress', { stage, fraction });
  }

  #fail(error: unknown): void {
    const { code, place } = error as Partial<EngineError>;
    this.#frame!.setProgress(null);
    const retry = code === 'not-loaded' ? () => this.#change('source') : undefined;
    this.#frame!.setMessage(messageOf(error), retry);
    this.#tell('error', { code: String(code ?? 'failed'), message: messageOf(error), key: place?.key ?? -1 });
  }

  /**
   * Space toggles playback. Arrow keys, Home, End, [ and ] change the time; but on a focused shape that can be rotated,
   * arrow keys rotate it.
   */
  #pressed(event: KeyboardEvent): void {
    if (!this.#sequence || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const onButton = event.target instanceof HTMLButtonElement;
    if (event.key === ' ' && !onButton) {
      event.preventDefault();
      return this.paused ? this.play() : this.pause();
    }
    const { keyTimes } = this.#sequence;
    const range = this.#range;
    const now = this.#view!.time;
    const to = { '[': -1, ']': 1 }[event.key] as 1 | -1 | undefined;
    const t = to
      ? clamp(neighbourKey(now, keyTimes, to, range), ...range)
      : keyboardStep(event, now, { range, whole: range }, null);
    if (t === null) return;
    event.preventDefault();
    this.#byHand(t);
  }

  #dispose(): void {
    this.#round += 1;
    this.#loading = null;
    this.#sequence = null;
    this.#info = null;
    this.#mayBegin ||= this.#playing;
    this.#setPlaying(false);
    this.#view?.dispose();
    this.#view = null;
    for (const lease of [this.#keys, ...this.#motions]) lease?.release();
    [this.#keys, this.#motions] = [null, []];
    this.#giveBack();
    this.#frame!.setProgress(null);
    this.#page();
  }
}

function noSource(): EngineError {
  return new EngineError('no-source', 'Nothing to show: set src, add <source src> children or set keys.');
}

for (const property of PROPERTIES)
  Object.defineProperty(ShapeSplineElement.prototype, property, {
    get(this: ShapeSplineElement) {
      return ShapeSplineElement.read(this, property);
    },
    set(this: ShapeSplineElement, value: unknown) {
      ShapeSplineElement.write(this, property, value);
    },
    enumerable: true,
    configurable: true,
  });

declare global {
  interface HTMLElementTagNameMap {
    'shape-spline': ShapeSplineElement;
  }
}
