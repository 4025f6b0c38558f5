/** The element <shape-spline>. Importing it changes nothing, and works without a DOM. */
import { isCancelled, messageOf } from '../engine/api/errors.ts';
import type { EngineError } from '../engine/api/errors.ts';
import type { Keys, Sequence } from '../engine/api/api.ts';
import type { ExportOptions, Frame as Shape, ImportOptions, MeshReport, SequenceOptions } from '../engine/api/types.ts';
import { orbitOf, targetOf } from '../model/camera-words.ts';
import { keyboardStep } from '../model/keyboard-step.ts';
import { GHOST_FACES } from '../model/state.ts';
import { neighbourKey, timeScale } from '../model/time-scale.ts';
import type { Phase, Range } from '../model/time-scale.ts';
import { ATTRIBUTES, PROPERTIES, ROWS, attributeOf, engineCallOf, propertyOf } from './attributes.ts';
import type { Concern, PropertyName, ShapeSplineProperties } from './attributes.ts';
import type { CanvasViewer } from './canvas-viewer.ts';
import type { EventDetails, ShapeSplineEventMap } from './events.ts';
import { Frame } from './frame.ts';
import type { KeysLease, MotionLease } from './motions.ts';
import { sourcesOf } from './sources.ts';
import type { KeySource } from './sources.ts';
import { readAttribute, writeAttribute } from './values.ts';

export type { ShapeSplineProperties } from './attributes.ts';
export type { ShapeSplineEventMap } from './events.ts';
export type { KeySource } from './sources.ts';

/** What leaves the document for a moment, because it is moved, stays as it is. */
const GRACE_MS = 500;
/** How far below the view what is lazy is fetched. */
const NEAR = '256px';
/** Share of the whole work that the keys take. */
const KEYS_SHARE = 0.5;

const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** Loaded when the first element is near the view: the engine's caller and three.js. */
const heavy = () => Promise.all([import('./canvas-viewer.ts'), import('./motions.ts')]);

export interface ShapeSplineStats {
  /** Frames that were computed for this element, and drawn by it. */
  framesComputed: number;
  framesDrawn: number;
  /** Milliseconds that the last one took in the worker. */
  ms: number;
}

export interface ShapeSplineElement extends ShapeSplineProperties {
  addEventListener<N extends keyof ShapeSplineEventMap>(
    type: N,
    listener: (this: ShapeSplineElement, event: ShapeSplineEventMap[N]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | object): void;
}

// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: its properties come from the table.
export class ShapeSplineElement extends Base {
  static readonly observedAttributes = ATTRIBUTES;
  #frame: Frame | null = null;
  #view: CanvasViewer | null = null;
  #keys: KeysLease | null = null;
  #motions: MotionLease[] = [];
  #sequence: Sequence | null = null;
  #given: readonly KeySource[] | null = null;
  #info: Keys['info'] | null = null;
  #loading: Promise<void> | null = null;
  /** Of the newest loading; an older one ends unheard. */
  #round = 0;
  #near = false;
  #inView = false;
  #playing = false;
  #begun = false;
  #time = NaN;
  #before = { time: NaN, step: 0, key: -1 };
  #changed = new Set<Concern>();
  #warned = new Set<string>();
  #leaving: ReturnType<typeof setTimeout> | undefined;
  #watch: (() => void) | null = null;
  #fraction = 0;
  #contextLost = false;
  #dismissed = false;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    this.#frame = new Frame(root, {
      onToggle: () => (this.paused ? this.play() : this.pause()),
      onSeek: (t) => this.#byHand(t),
      onKey: (event) => this.#pressed(event),
    });
  }

  connectedCallback(): void {
    clearTimeout(this.#leaving);
    // What was set before the element was known.
    for (const name of [...PROPERTIES, 'keys'] as (PropertyName | 'keys')[]) {
      if (!Object.hasOwn(this, name)) continue;
      const value: unknown = this[name];
      delete this[name];
      Object.assign(this, { [name]: value });
    }
    this.#watch ??= this.#observe();
    this.#change('page');
    if (this.loading === 'eager') void this.#load();
  }

  disconnectedCallback(): void {
    this.#watch?.();
    this.#watch = null;
    this.#view?.setSeen(false);
    this.#inView = false;
    this.#near = false;
    this.#leaving = setTimeout(() => this.#dispose(), GRACE_MS);
  }

  attributeChangedCallback(attribute: string, before: string | null, text: string | null): void {
    const property = propertyOf(attribute);
    if (!property || before === text) return;
    if (property === 'currentTime' && text !== null) this.#setTime(this.#read('currentTime') as number);
    else this.#change(ROWS[property].concern);
  }

  /** Comes before `src`: addresses, Blobs or ArrayBuffers of one key each, or of a file with all. */
  get keys(): readonly KeySource[] | null {
    return this.#given;
  }

  set keys(keys: readonly KeySource[] | null) {
    this.#given = keys;
    this.#change('source');
  }

  /** Length of what plays, in the unit of the keys; NaN before it is loaded. */
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

  /** What was found in the files; null before it is loaded. */
  get report(): MeshReport | null {
    return this.#info?.report ?? null;
  }

  play(): void {
    if (this.#playing) return;
    this.#setPlaying(true);
    void this.#load();
  }

  pause(): void {
    this.#setPlaying(false);
  }

  /** Resolves when that moment is drawn, even where the element is out of view. */
  async seek(t: number): Promise<void> {
    if (!Number.isFinite(t)) throw new RangeError('seek takes a time: a finite number.');
    this.#time = t;
    await this.#load();
    await this.#view?.seek(t);
    this.#tell('seeked', { currentTime: t });
  }

  /** The shape at t, drawn or not; `release()` gives its arrays back. */
  async evaluate(t: number): Promise<Shape> {
    return (await this.#loaded()).evaluateAhead(t);
  }

  /** A picture of what is shown. */
  async toBlob({ type = 'image/png', quality }: { type?: string; quality?: number } = {}): Promise<Blob> {
    await this.#loaded();
    const blob = await new Promise<Blob | null>((done) => {
      this.#view!.viewer.snapshot((canvas) => canvas.toBlob(done, type, quality));
    });
    if (!blob) throw new Error(`This browser cannot write ${type}.`);
    return blob;
  }

  /** A GLB with the motion as a morph-target animation, which is a project for shapespline, too. */
  async exportGLB(options: Partial<Omit<ExportOptions, 'format'>> = {}): Promise<Blob> {
    const [file] = await (await this.#loaded()).export({ ...options, format: 'glb' });
    return new Blob([file!.bytes as Uint8Array<ArrayBuffer>], { type: 'model/gltf-binary' });
  }

  dismissPoster(): void {
    this.#dismissed = true;
    this.#page();
  }

  async #loaded(): Promise<Sequence> {
    await this.#load();
    if (!this.#sequence) throw new Error('The shape could not be loaded; the event `error` says why.');
    return this.#sequence;
  }

  /** The property's value: its attribute as the table says, with one warning where that is wrong. */
  #read(property: PropertyName): unknown {
    const text = this.getAttribute(attributeOf(property));
    const { value, problem } = readAttribute(ROWS[property], text);
    if (problem && !this.#warned.has(`${property} ${text}`)) {
      this.#warned.add(`${property} ${text}`);
      console.warn(`<shape-spline>: ${attributeOf(property)}="${text}" ${problem}.`);
    }
    return value;
  }

  /** Called by the properties that the table describes. */
  static read(element: ShapeSplineElement, property: PropertyName): unknown {
    if (property === 'currentTime' && !Number.isNaN(element.#time)) return element.#view?.time ?? element.#time;
    return element.#read(property);
  }

  static write(element: ShapeSplineElement, property: PropertyName, value: unknown): void {
    if (property === 'currentTime') {
      if (!Number.isFinite(value)) throw new TypeError('currentTime must be a finite number.');
      return element.#setTime(value as number);
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

  /** Several changes at once are one. */
  #change(concern: Concern): void {
    if (this.#changed.size === 0) queueMicrotask(() => this.#apply());
    this.#changed.add(concern);
  }

  #apply(): void {
    const changed = this.#changed;
    this.#changed = new Set();
    if (!this.isConnected) return;
    this.#page();
    if (changed.has('source') || changed.has('motion')) {
      // What asks for keys that are wrong is told so when they are asked for again.
      const wanted = this.#loading !== null || this.#near || this.loading === 'eager';
      this.#loading = null;
      if (wanted) void this.#load();
    } else if (this.#view) this.#settings(this.#view);
  }

  #page(): void {
    const frame = this.#frame!;
    frame.setLabel(this.alt);
    frame.controls.hidden = !this.controls;
    const hidden = this.#dismissed || (this.reveal === 'auto' && this.#sequence !== null);
    frame.setPoster(this.poster, this.#contextLost || !hidden);
    frame.setPlaying(this.#playing);
    const turnable = this.hasAttribute('camera-controls') ? this.cameraControls : this.controls;
    frame.viewport.style.pointerEvents = turnable ? '' : 'none';
  }

  #observe(): () => void {
    const near = new IntersectionObserver(
      (entries) => {
        this.#near = entries.at(-1)!.isIntersecting;
        if (this.#near) void this.#load();
      },
      { rootMargin: NEAR },
    );
    const inView = new IntersectionObserver((entries) => {
      this.#inView = entries.at(-1)!.isIntersecting;
      this.#view?.setSeen(this.#inView);
    });
    for (const observer of [near, inView]) observer.observe(this);
    const children = new MutationObserver(() => this.#change('source'));
    children.observe(this, { childList: true, subtree: true, attributes: true, attributeFilter: ['src', 'time'] });
    return () => {
      for (const observer of [near, inView, children]) observer.disconnect();
    };
  }

  #load(): Promise<void> {
    this.#loading ??= this.#open();
    return this.#loading;
  }

  async #open(): Promise<void> {
    this.#round += 1;
    const round = this.#round;
    const current = (): boolean => round === this.#round;
    const sources = sourcesOf(this.#given, this.src, this);
    if (sources.list.length === 0) return;
    const frame = this.#frame!;
    this.#fraction = 0;
    frame.setMessage(null);
    const begun: { release(): void }[] = [];
    try {
      const [{ CanvasViewer }, { takeKeys, takeMotion }] = await heavy();
      const keys = takeKeys(sources, this.#options('import') as ImportOptions, (part) =>
        this.#progress(current, part.stage, KEYS_SHARE * part.fraction),
      );
      begun.push(keys);
      const held = await keys.value;
      const options: Partial<SequenceOptions> = { ...held.info.project, ...this.#options('sequence') };
      if (this.ghost && !options.ghostFaces) options.ghostFaces = GHOST_FACES;
      const method = options.method ?? this.method;
      const methods = [method, ...this.compare.filter((one) => one !== method)];
      const leases = methods.map((one) =>
        takeMotion(keys, { ...options, method: one }, (part) =>
          this.#progress(current, part.stage, KEYS_SHARE + (1 - KEYS_SHARE) * part.fraction),
        ),
      );
      begun.push(...leases);
      const sequences = await Promise.all(leases.map(({ value }) => value));
      if (!current()) throw new DOMException('Something else is shown by now.', 'AbortError');
      const first = this.#sequence === null;
      this.#view ??= this.#newView(CanvasViewer);
      const view = this.#view;
      for (const lease of [this.#keys, ...this.#motions]) lease?.release();
      [this.#keys, this.#motions, this.#info] = [keys, leases, held.info];
      this.#sequence = sequences[0]!;
      if (Number.isNaN(this.#time)) this.#time = this.#startTime();
      view.setSeen(true);
      this.#settings(view);
      const motions = sequences.map((sequence, i) => ({ sequence, method: methods[i]!, ghost: 0 }));
      const drawn = view.open(held, motions);
      view.follow(this.#time);
      this.#settings(view);
      await drawn;
      if (!current()) return;
      this.#progress(current, 'drawn', 1);
      frame.setProgress(null);
      this.#page();
      const { vertices, faces } = held.info.report;
      this.#tell('load', { vertices, faces, keyTimes: [...this.#sequence.keyTimes] });
      if (first && this.autoplay && !matchMedia('(prefers-reduced-motion: reduce)').matches) this.#setPlaying(true);
      view.setPlaying(this.#playing);
      view.setSeen(this.#inView);
    } catch (error) {
      for (const lease of begun) lease.release();
      if (current() && !isCancelled(error)) this.#fail(error);
    }
  }

  #startTime(): number {
    const [start] = this.range ?? this.#sequence!.range;
    return this.hasAttribute('current-time') ? (this.#read('currentTime') as number) : start;
  }

  #newView(Viewer: typeof CanvasViewer): CanvasViewer {
    return new Viewer(this.#frame!.viewport, {
      onTime: (t, phase) => this.#shown(t, phase),
      onEnd: () => {
        this.#tell('loopend', { currentTime: this.#view!.time });
        this.#setPlaying(false);
      },
      onError: (error) => this.#fail(error),
      onContext: (lost) => {
        this.#contextLost = lost;
        this.#page();
      },
      covered: () => (this.controls ? 44 : 0),
    });
  }

  /** The engine's options that the page gives. */
  #options(call: 'import' | 'sequence'): Record<string, unknown> {
    const given = PROPERTIES.filter((name) => engineCallOf(name) === call && this.hasAttribute(attributeOf(name)));
    const entries = given.map((name) => {
      const value = this.#read(name);
      // One number says how many moments, several say which.
      return [name, name === 'sample' && Array.isArray(value) && value.length === 1 ? value[0] : value] as const;
    });
    return Object.fromEntries(entries.filter(([, value]) => value !== null && value !== ''));
  }

  #settings(view: CanvasViewer): void {
    const style = getComputedStyle(this);
    const scheme = style.colorScheme;
    const dark = scheme === 'dark' || (/dark/.test(scheme) && matchMedia('(prefers-color-scheme: dark)').matches);
    for (const kind of ['key', 'between', 'beyond'] as const) {
      const own = style.getPropertyValue(`--shape-spline-${kind}`).trim();
      if (CSS.supports('color', own)) view.colours[kind] = own;
    }
    void view.setLook({ colouring: this.colour, dark });
    view.setCamera(this.cameraOrbit ? orbitOf(this.cameraOrbit) : null, targetOf(this.cameraTarget));
    const speed = this.playbackRate * (this.#info?.speed ?? 1);
    view.play = { ...view.play, speed, loop: this.loop || 'once', between: this.range };
    if (this.#sequence) this.#frame!.setKeys(this.#shownRange(), this.#sequence.keyTimes);
  }

  #shownRange(): Range {
    return this.range ?? this.#sequence?.range ?? [0, 1];
  }

  #shown(t: number, phase: Phase): void {
    this.#time = t;
    this.#frame!.setTime(t, phase.text);
    this.#tell('timeupdate', { currentTime: t });
    const { time, step, key } = this.#before;
    const next = t - time;
    // Where it plays back and forth, or begins again, it goes the other way at once.
    if (this.#playing && next * step < 0) this.#tell('loopend', { currentTime: t });
    const reached = this.#sequence!.keyTimes.filter((one) => one <= t + 1e-9).length - 1;
    if (reached !== key && reached >= 0) this.#tell('keychange', { index: reached });
    const turned = this.loop !== 'bounce' && next * step < 0;
    this.#before = { time: t, step: turned ? 0 : next, key: reached };
  }

  #setPlaying(playing: boolean): void {
    if (playing === this.#playing && this.#begun) return;
    this.#begun = true;
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
    const { code = 'failed', place } = error as Partial<EngineError>;
    const message = /WebGL/.test(messageOf(error))
      ? 'This browser cannot draw it: it has no WebGL 2.'
      : messageOf(error);
    this.#frame!.setProgress(null);
    this.#frame!.setMessage(message);
    this.#tell('error', { code: String(code), message, key: place?.key ?? -1 });
  }

  /** Space plays; arrows, Home, End and brackets move the time, but turn the shape where that has the focus. */
  #pressed(event: KeyboardEvent): void {
    if (!this.#sequence || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const onButton = event.target instanceof HTMLButtonElement;
    if (event.key === ' ' && !onButton) {
      event.preventDefault();
      return this.paused ? this.play() : this.pause();
    }
    const { keyTimes, range } = this.#sequence;
    const now = this.#view!.time;
    const to = { '[': -1, ']': 1 }[event.key] as 1 | -1 | undefined;
    const t = to
      ? neighbourKey(now, keyTimes, to, range)
      : keyboardStep(event, now, timeScale(range, keyTimes.length), null);
    if (t === null) return;
    event.preventDefault();
    this.#byHand(t);
  }

  #dispose(): void {
    this.#round += 1;
    this.#loading = null;
    this.#sequence = null;
    this.#view?.dispose();
    this.#view = null;
    for (const lease of [this.#keys, ...this.#motions]) lease?.release();
    this.#keys = null;
    this.#motions = [];
    this.#page();
  }
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
