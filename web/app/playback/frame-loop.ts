/**
 * Asks for shapes and puts them on the screen: one at a time, always the newest moment, all views together. What moves is
 * drawn about right where exact shapes are slow and the cheap ones known to be close, and exactly as soon as it rests; what plays
 * is computed ahead.
 */
import type { AheadOptions } from '../../engine/api/api.ts';
import { PreviewPolicy } from './preview-policy.ts';
import { LookAhead } from './look-ahead.ts';
import type { Clock } from './look-ahead.ts';
import { gather } from './frame-set.ts';
import type { FrameSet } from './frame-set.ts';
import type { RunningSequence } from '../session/sequence-set.ts';

export interface FrameLoopTarget {
  sequences(): readonly RunningSequence[];
  /** Copies the shapes to the screen; they are released afterwards. `eased`: from those on the screen, about right at this moment. */
  show(shapes: FrameSet, eased: boolean): void | Promise<void>;
  /** Resolves when what was shown has been drawn, and none is being eased. */
  drawn(): Promise<void>;
  onError(error: unknown): void;
}

interface Waiting {
  resolve(): void;
  ticket: number;
}

/** What moves rests when no newer moment has come for so long. */
const REST_MS = 80;
/** The first cheap shape takes a moment: it is made before it is needed, when nothing else is asked for. */
const PREPARE_MS = 300;

export class FrameLoop {
  private wanted = 0;
  private ticket = 0;
  /** The newest tickets that were served about right, and exactly. */
  private about = 0;
  private exact = 0;
  private restsAt = -Infinity;
  private screen: Pick<FrameSet, 't' | 'sequences' | 'about'> = { t: NaN, sequences: [], about: false };
  private drawing: Promise<void> = Promise.resolve();
  private playback: LookAhead | null = null;
  private running: Promise<void> | null = null;
  private waiting: Waiting[] = [];
  private calls: (() => void)[] = [];
  private preparing: ReturnType<typeof setTimeout> | undefined;
  private measuring = false;

  constructor(private readonly target: FrameLoopTarget, private readonly policy = new PreviewPolicy()) {}

  get busy(): boolean {
    return this.exact < this.ticket;
  }

  /** What is on the screen. */
  get shown(): { t: number; about: boolean } {
    return this.screen;
  }

  /** The exact shape. Resolves when this moment, or a newer one that overtook it, has been drawn. */
  request(t: number): Promise<void> {
    this.want(t, -Infinity);
    return this.idle();
  }

  /**
   * For while the time or the motion changes: about right where exact shapes are slow, and exact when it rests. A motion that
   * plays goes on.
   */
  follow(t: number): void {
    if (this.playback) {
      this.playback.discard();
      this.wake();
    } else this.want(t, performance.now() + REST_MS);
  }

  /** What moved has come to rest, as when a pointer is lifted. */
  settle(): void {
    if (performance.now() >= this.restsAt) return;
    this.restsAt = -Infinity;
    this.wake();
  }

  /** Shows what plays, until `pause`. The clock calls `advance` when its tick has changed. */
  play(clock: Clock): void {
    this.playback?.discard();
    const source = { evaluateAhead: (t: number, options: AheadOptions) => this.ahead(t, options) };
    this.playback = new LookAhead(clock, source, (error) => this.target.onError(error));
    this.start();
  }

  advance(): void {
    this.wake();
  }

  pause(): void {
    this.playback?.discard();
    this.playback = null;
    this.wake();
  }

  /** Resolves when what has been asked for so far is drawn exactly; a motion that plays is not waited for. */
  idle(): Promise<void> {
    if (!this.busy) return Promise.resolve();
    return new Promise((resolve) => this.waiting.push({ resolve, ticket: this.ticket }));
  }

  private want(t: number, restsAt: number): void {
    this.wanted = t;
    this.ticket += 1;
    this.restsAt = restsAt;
    // Computed ahead for a motion that may be another one now.
    this.playback?.discard();
    this.wake();
    this.start();
  }

  private start(): void {
    clearTimeout(this.preparing);
    this.running ??= this.run();
  }

  private wake(): void {
    for (const call of this.calls.splice(0)) call();
  }

  private called(): Promise<void> {
    return new Promise((resolve) => this.calls.push(resolve));
  }

  private async run(): Promise<void> {
    // Whoever waits for a frame may ask for the next one at once: that the work has ended must be known by then.
    await Promise.resolve();
    while (this.busy || this.playback) {
      if (this.busy) await this.serve();
      else await this.playOn();
    }
    this.running = null;
    this.preparing = setTimeout(() => void this.prepare(), PREPARE_MS);
  }

  /** The newest ticket: about right while it moves, where that is worth it; else exactly, which ends it. */
  private async serve(): Promise<void> {
    const { ticket, wanted } = this;
    const rest = this.restsAt - performance.now();
    const about = rest > 0 && this.policy.about(this.target.sequences(), this.wanted);
    if (about && this.about === ticket) return this.sleep(rest);
    try {
      const drawn = await this.frame(wanted, ticket, about);
      if (!drawn) return;
    } catch (error) {
      this.target.onError(error);
    }
    this.about = ticket;
    if (about) return;
    this.exact = ticket;
    this.waiting = this.waiting.filter(({ resolve, ticket: mine }) => {
      if (mine <= ticket) resolve();
      return mine > ticket;
    });
  }

  /** False where the sequences were exchanged meanwhile, or a newer moment came before an eased shape was there. */
  private async frame(t: number, ticket: number, about: boolean): Promise<boolean> {
    const shapes = await this.ask(t, about);
    if (!shapes) return false;
    try {
      const eased = !about && this.screen.about && this.screen.t === t && this.screen.sequences === shapes.sequences;
      if (eased && ticket !== this.ticket) return false;
      await this.show(shapes, eased);
      // While a shape that is about right is drawn, the next one is computed.
      if (about) {
        void this.drawing.then(() => this.awaitRest(ticket));
        return true;
      }
      if (eased) return await this.drawnBefore(ticket);
      await this.drawing;
      return true;
    } finally {
      shapes.release();
    }
  }

  /** To draw may take long, and nobody heard of a newer moment meanwhile: it rests so long after that. */
  private awaitRest(ticket: number): void {
    if (ticket === this.ticket && this.restsAt !== -Infinity) this.restsAt = performance.now() + REST_MS;
  }

  /** A sequence that was exchanged meanwhile answers no more: null, the same moment is to be asked of its successor. */
  private async ask(t: number, about: boolean): Promise<FrameSet | null> {
    const sequences = this.target.sequences();
    try {
      const shapes = await gather(sequences, t, about, (sequence) => (about ? sequence.preview(t) : sequence.evaluate(t)));
      if (shapes) this.policy.note(shapes);
      if (sequences === this.target.sequences()) return shapes;
      shapes?.release();
      return null;
    } catch (error) {
      if (sequences === this.target.sequences()) throw error;
      return null;
    }
  }

  /** Waits until what is shown has been drawn; false as soon as a newer moment is asked for. */
  private async drawnBefore(ticket: number): Promise<boolean> {
    let drawn = false;
    const drawing = this.drawing.then(() => { drawn = true; });
    while (!drawn && ticket === this.ticket) await Promise.race([drawing, this.called()]);
    if (!drawn) this.drawing = Promise.resolve();
    return drawn;
  }

  private async playOn(): Promise<void> {
    const shapes = this.playback?.take();
    if (!shapes) return this.called();
    try {
      if (shapes.sequences !== this.target.sequences()) this.playback?.discard();
      else await this.show(shapes, false);
    } catch (error) {
      this.target.onError(error);
    } finally {
      shapes.release();
    }
    await this.drawing;
  }

  private async show(shapes: FrameSet, eased: boolean): Promise<void> {
    await this.drawing;
    await this.target.show(shapes, eased);
    this.screen = { t: shapes.t, sequences: shapes.sequences, about: shapes.about };
    this.drawing = this.target.drawn();
  }

  private async ahead(t: number, { signal }: AheadOptions): Promise<FrameSet> {
    const sequences = this.target.sequences();
    const preview = this.policy.about(sequences, t);
    // What plays never rests: where nothing is known it goes on exactly and waits a little for that to change.
    void this.measure(t, () => this.playback !== null && this.policy.doubts(sequences, t));
    const shapes = await gather(sequences, t, preview, (sequence) => sequence.evaluateAhead(t, { preview, signal }));
    if (!shapes) throw new Error('A frame that was fetched ahead was overtaken.');
    this.policy.note(shapes);
    return shapes;
  }

  private async prepare(): Promise<void> {
    const t = this.wanted;
    if (this.policy.untried(this.target.sequences())) await this.tryCheap(t);
    await this.measure(t, () => !this.running);
  }

  /** Finds out what cheap shapes take, and makes what they need; a failure is left to whoever asks for one. */
  private async tryCheap(t: number): Promise<void> {
    const sequences = this.target.sequences();
    for (let times = 0; times < 2 && !this.running && sequences === this.target.sequences(); times += 1) {
      const shapes = await gather(sequences, t, true, (sequence) => sequence.evaluateAhead(t, { preview: true })).catch(() => null);
      if (!shapes) return;
      this.policy.note(shapes);
      shapes.release();
    }
  }

  /** Finds out where cheap shapes are close, nearest to t first and as long as `wanted`; a failure is left to whoever asks for a shape. */
  private async measure(t: number, wanted: () => boolean): Promise<void> {
    if (this.measuring) return;
    this.measuring = true;
    const sequences = this.target.sequences();
    while (wanted() && sequences === this.target.sequences()) {
      const sample = this.policy.unmeasured(sequences, t);
      const errors = sample && await Promise.all(sequences.map(({ sequence }) => sequence.previewError(sample.t))).catch(() => null);
      if (!sample || !errors) break;
      this.policy.measured(sequences, sample, errors);
    }
    this.measuring = false;
  }

  private sleep(ms: number): Promise<void> {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, ms);
      this.calls.push(() => {
        clearTimeout(timer);
        resolve();
      });
    });
  }
}
