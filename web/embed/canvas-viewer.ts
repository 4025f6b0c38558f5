/**
 * A motion in an element of a page: drawing, playback and rotation. Independent of attributes and files, so it is
 * usable alone.
 */
import type { Keys } from '../engine/api/api.ts';
import { EngineError, isCancelled, messageOf } from '../engine/api/errors.ts';
import { directionOfOrbit } from '../model/camera-words.ts';
import type { CameraOrbit } from '../model/camera-words.ts';
import type { Play } from '../model/state.ts';
import { PHASE_COLOURS, phaseOf } from '../model/time-scale.ts';
import type { Phase, PhaseKind, Range } from '../model/time-scale.ts';
import { Demand } from '../playback/demand.ts';
import { FrameLoop } from '../playback/frame-loop.ts';
import type { FrameSet, RunningMotion } from '../playback/frame-set.ts';
import { Player } from '../playback/player.ts';
import { listenToCamera } from '../viewer/camera-keys.ts';
import { extentOf } from '../viewer/bounds.ts';
import { patchColours } from '../viewer/patch-colours.ts';
import { sharedSurface } from '../viewer/shared-surface.ts';
import type { Surface } from '../viewer/surface.ts';
import type { Look } from '../viewer/types.ts';
import { Viewer } from '../viewer/viewer.ts';
import { userOf } from './motions.ts';

export type { CameraOrbit } from '../model/camera-words.ts';

export interface CanvasViewerEvents {
  /** A new time is shown. */
  onTime(t: number, phase: Phase): void;
  /** Playback without a loop has reached the end. */
  onEnd(): void;
  onError(error: unknown): void;
  onContext(lost: boolean): void;
  /** The views have new positions or sizes. */
  onPlaces(): void;
  /** Height in pixels that other elements cover at the bottom. */
  covered(): number;
  /** Colour of shapes in a phase, in any CSS notation that three.js supports. */
  colourOf(kind: PhaseKind): string;
}

const UNHEARD: CanvasViewerEvents = {
  onTime: () => undefined,
  onEnd: () => undefined,
  onError: (error) => console.error(error),
  onContext: () => undefined,
  onPlaces: () => undefined,
  covered: () => 0,
  colourOf: (kind) => PHASE_COLOURS[kind],
};

/** During playback, times this close to a key (relative to the range) count as being at it. */
const PLAYING_TOLERANCE = 0.006;

export class CanvasViewer {
  readonly viewer: Viewer;
  readonly counts = { computed: 0, drawn: 0, ms: 0 };
  /** Whether the user can rotate the shape. */
  turnable = true;
  play: Play = { playing: false, speed: 1, loop: 'once', between: null, fps: null };
  private motions: readonly RunningMotion[] = [];
  private keys: Keys | null = null;
  private now = 0;
  private seen = true;
  private moved = false;
  private orbit: CameraOrbit | null = null;
  private target: readonly [number, number, number] | null = null;
  private readonly events: CanvasViewerEvents;
  private readonly loop: FrameLoop;
  private readonly player: Player;

  /** Fills `host`, which must have a size. Error: no-webgl. */
  constructor(host: HTMLElement, heard: Partial<CanvasViewerEvents> = {}) {
    const events = { ...UNHEARD, ...heard };
    this.events = events;
    this.viewer = new Viewer(
      host,
      {
        onCamera: () => {
          this.moved = true;
        },
        onContextLost: () => events.onContext(true),
        onContextRestored: () => events.onContext(false),
        onResize: () => this.placed(),
        covered: () => ({ top: 0, bottom: events.covered() }),
      },
      surfaceOfPage(),
    );
    // A vertical swipe scrolls the page.
    this.viewer.canvas.style.touchAction = 'pan-y';
    // The wheel scrolls the page until the shape has been clicked.
    host.addEventListener(
      'wheel',
      (event) => {
        const root = host.getRootNode() as ShadowRoot;
        if (!event.ctrlKey && root.activeElement !== host) event.stopPropagation();
      },
      { capture: true },
    );
    listenToCamera(this.viewer, host, () => this.turnable);
    const screen = {
      show: (frames: FrameSet) => this.show(frames),
      drawn: async () => {
        if (this.motions.length === 0) return;
        await this.viewer.drawn();
        this.counts.drawn += 1;
      },
      onError: (error: unknown) => this.failed(error),
    };
    this.loop = new FrameLoop(screen, new Demand(() => this.motions));
    this.player = new Player(
      () => ({ time: this.now, play: this.play, range: this.range, periodic: this.periodic }),
      (time, playing) => {
        this.now = time;
        if (!playing) this.ended();
      },
      () => this.loop.advance(),
    );
  }

  get time(): number {
    return this.now;
  }

  get range(): Range {
    return this.motions[0]?.sequence.range ?? [0, 1];
  }

  get keyTimes(): readonly number[] {
    return this.motions[0]?.sequence.keyTimes ?? [];
  }

  private get periodic(): boolean {
    return this.motions[0]?.sequence.options.boundary === 'periodic';
  }

  /** Shows motions of the same keys side by side at t; resolves when they are drawn. */
  async open(keys: Keys, motions: readonly RunningMotion[], t: number): Promise<void> {
    const count = (ms: number): void => {
      this.counts.computed += 1;
      this.counts.ms = ms;
    };
    this.motions = motions.map((one) => ({ ...one, sequence: userOf(one.sequence, count) }));
    const others = this.keys !== keys || this.viewer.views !== motions.length;
    if (this.keys !== keys) {
      this.keys = keys;
      const { bounds, points } = extentOf(keys.info.times.map((_, key) => keys.positions(key)));
      this.viewer.setImport(keys.info, bounds, points);
    }
    this.viewer.setViews(motions.length);
    // If only the motion changes, a camera moved by the user stays.
    if (others) this.moved = false;
    this.placed();
    await this.seek(t);
  }

  /** Resolves when this time, or a newer requested time, has been drawn. */
  async seek(t: number): Promise<void> {
    this.now = t;
    await this.loop.request(t);
  }

  /** Shows the time as soon as possible, once the viewer is in view. */
  follow(t: number): void {
    this.now = t;
    if (this.seen) this.loop.follow(t);
  }

  setPlaying(playing: boolean): void {
    this.play = { ...this.play, playing };
    this.run();
  }

  /** Pauses computing and drawing while the viewer is out of view. `open` and `seek` still draw. */
  setSeen(seen: boolean): void {
    if (seen === this.seen) return;
    this.seen = seen;
    this.run();
    if (seen && !this.play.playing && this.motions.length > 0) this.loop.follow(this.now);
  }

  /** Discards the user's camera if the configured camera changed. */
  setCamera(orbit: CameraOrbit | null, target: readonly [number, number, number] | null): void {
    const same = JSON.stringify([orbit, target]) === JSON.stringify([this.orbit, this.target]);
    [this.orbit, this.target] = [orbit, target];
    if (same) return;
    this.moved = false;
    this.frameShape();
  }

  setLook(look: Pick<Look, 'colouring' | 'dark'>): void {
    this.viewer.setLook({ shading: 'smooth', wireframe: false, floor: true, ...look });
    if (look.colouring === 'patches') void this.colourPatches().catch((error: unknown) => this.failed(error));
  }

  private async colourPatches(): Promise<void> {
    const [main] = this.motions;
    const { keys } = this;
    if (!main || !keys) return;
    const patches = await main.sequence.shape.patches();
    if (this.motions[0] === main)
      this.viewer.setPatchColours(patchColours(patches, keys.info.faces, keys.info.report.vertices));
  }

  private failed(error: unknown): void {
    if (!isCancelled(error)) this.events.onError(error);
  }

  dispose(): void {
    this.player.stop();
    this.loop.pause();
    this.motions = [];
    this.viewer.dispose();
  }

  private run(): void {
    this.player.stop();
    this.loop.pause();
    if (!this.play.playing || !this.seen || this.motions.length === 0) return;
    this.loop.play(this.player);
    this.player.start();
  }

  private ended(): void {
    this.play = { ...this.play, playing: false };
    this.loop.pause();
    this.loop.follow(this.now);
    this.events.onEnd();
  }

  private show({ t, frames }: FrameSet): void {
    if (frames.length === 0) return;
    const keys = this.keyTimes.map((time, index) => ({ time, name: this.keys?.info.names[index] ?? '' }));
    const tolerance = this.play.playing ? PLAYING_TOLERANCE : undefined;
    const phase = phaseOf({ t, keys, range: this.range, periodic: this.periodic, tolerance });
    const colour = this.events.colourOf(phase.kind);
    frames.forEach((frame, view) => this.viewer.setFrame(view, frame.positions, frame.normals, colour));
    this.events.onTime(t, phase);
  }

  private placed(): void {
    this.frameShape();
    this.events.onPlaces();
  }

  /** Fits the whole shape, with the page's orbit and target, unless the user has moved the camera. */
  private frameShape(): void {
    if (this.moved || !this.keys) return;
    this.viewer.fit('home', false);
    const fitted = this.viewer.cameraPose();
    const target = fitted.target.map((at, i) => {
      const wanted = this.target?.[i] ?? NaN;
      return Number.isNaN(wanted) ? at : wanted;
    }) as [number, number, number];
    if (this.orbit) {
      const way = directionOfOrbit(this.orbit);
      const from = (distance: number): [number, number, number] =>
        target.map((at, i) => at + distance * way[i]!) as [number, number, number];
      this.viewer.setCameraPose({ position: from(1), target });
      this.viewer.fit(null, false);
      const whole = this.viewer.cameraPose();
      const full = Math.hypot(...whole.position.map((at, i) => at - whole.target[i]!));
      const { radius } = this.orbit;
      const distance = 'share' in radius ? radius.share * full : radius.distance;
      this.viewer.setCameraPose({ position: from(distance), target });
    } else if (this.target) {
      const position = fitted.position.map((at, i) => at + target[i]! - fitted.target[i]!);
      this.viewer.setCameraPose({ position: position as [number, number, number], target });
    }
    this.moved = false;
  }
}

/** The page's shared surface. Error: no-webgl. */
function surfaceOfPage(): Surface {
  try {
    return sharedSurface();
  } catch (cause) {
    const reason = document.createElement('canvas').getContext('webgl2')
      ? messageOf(cause)
      : 'it does not support WebGL 2';
    throw new EngineError('no-webgl', `This browser cannot draw the shape: ${reason}.`, {}, cause);
  }
}
