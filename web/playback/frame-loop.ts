/**
 * Asks for frames and puts them on the screen: one time after another, all views together, as the demand says.
 * What plays is computed ahead.
 */
import type { AheadOptions } from '../engine/api/api.ts';
import type { Demand, Shown, Wanted } from './demand.ts';
import { gather } from './frame-set.ts';
import type { FrameSet } from './frame-set.ts';
import { LookAhead } from './look-ahead.ts';
import type { Clock } from './look-ahead.ts';
import { PreviewSurvey } from './preview-survey.ts';

export interface Screen {
  /** Copies the frames to the screen; they are released afterwards. `eased`: from their previews, shown now. */
  show(frames: FrameSet, eased: boolean): void | Promise<void>;
  /** Resolves when what was shown has been drawn, and none is being eased. */
  drawn(): Promise<void>;
  /** Other work waits for the machine. */
  yields?(): boolean;
  onError(error: unknown): void;
}

/** Milliseconds of a drawing that takes a processor from other work. */
const SLOW_MS = 50;
/** So many times as long as it was drawn, a frame that plays stays then, and no longer than the second in ms. */
const [STAYS, LONGEST_MS] = [4, 1000];

interface Waiting {
  resolve(): void;
  number: number;
}

export class FrameLoop {
  private drawing: Promise<void> = Promise.resolve();
  private lookAhead: LookAhead | null = null;
  private running: Promise<void> | null = null;
  private waiting: Waiting[] = [];
  private calls: (() => void)[] = [];
  /** Until then what plays leaves the machine to other work. */
  private yieldsUntil = -Infinity;
  private readonly survey: PreviewSurvey;

  constructor(
    private readonly screen: Screen,
    private readonly demand: Demand,
  ) {
    this.survey = new PreviewSurvey(demand, () => !this.running);
  }

  get busy(): boolean {
    return this.demand.open;
  }

  get shown(): Shown {
    return this.demand.shown;
  }

  /** The exact frame. Resolves when this time, or a newer one that overtook it, has been drawn. */
  request(t: number): Promise<void> {
    this.demand.want(t);
    this.begin();
    return this.idle();
  }

  /** While the time or the motion changes: a preview where the policy allows, exact at rest. What plays goes on. */
  follow(t: number): void {
    if (this.lookAhead) {
      this.lookAhead.discard();
      this.wake();
      return;
    }
    this.demand.follow(t);
    this.begin();
  }

  /** What moved has come to rest, as when a pointer is lifted. */
  settle(): void {
    if (this.demand.settle()) this.wake();
  }

  /** Shows what plays, until `pause`. The clock calls `advance` when its tick has changed. */
  play(clock: Clock): void {
    this.lookAhead?.discard();
    this.lookAhead = new LookAhead({
      clock,
      source: { evaluateAhead: (t, options) => this.ahead(t, options) },
      frameMs: (t) => this.demand.policy.typicalMs(this.demand.sequences(), t),
      onError: (error) => this.screen.onError(error),
    });
    this.start();
  }

  advance(): void {
    this.wake();
  }

  pause(): void {
    this.lookAhead?.discard();
    this.lookAhead = null;
    this.wake();
  }

  /** Nothing plays any more; resolves when nothing is asked for, either. */
  async rest(): Promise<void> {
    this.pause();
    await this.running;
  }

  /** Resolves when what has been asked for so far is drawn exactly; a motion that plays is not waited for. */
  idle(): Promise<void> {
    if (!this.busy) return Promise.resolve();
    return new Promise((resolve) => this.waiting.push({ resolve, number: this.demand.wanted.number }));
  }

  private begin(): void {
    // Computed ahead for a motion that may be another one now.
    this.lookAhead?.discard();
    this.wake();
    this.start();
  }

  private start(): void {
    this.survey.cancel();
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
    while (this.busy || this.lookAhead) {
      const next = this.demand.next();
      if (!next) await this.playOn();
      else if ('restsIn' in next) await this.sleep(next.restsIn);
      else await this.serve(next.wanted, next.preview);
    }
    this.running = null;
    this.survey.schedule();
  }

  private async serve(wanted: Wanted, preview: boolean): Promise<void> {
    try {
      if (!(await this.draw(wanted, preview))) return;
    } catch (error) {
      this.screen.onError(error);
    }
    this.demand.close(wanted, preview);
    if (preview) return;
    this.waiting = this.waiting.filter(({ resolve, number }) => {
      if (number <= wanted.number) resolve();
      return number > wanted.number;
    });
  }

  /** False where the sequences were exchanged meanwhile, or a newer time came before an eased frame was there. */
  private async draw(wanted: Wanted, preview: boolean): Promise<boolean> {
    const frames = await this.ask(wanted, preview);
    if (!frames) return false;
    try {
      const eased = this.demand.eases(frames);
      if (eased && !this.demand.isNewest(wanted)) return false;
      await this.show(frames, eased);
      // While a preview is drawn, the next frame is computed.
      if (preview) void this.drawing.then(() => this.demand.noteDrawn(wanted));
      else if (eased) return await this.drawnBeforeNewer(wanted);
      else await this.drawing;
      return true;
    } finally {
      frames.release();
    }
  }

  /** A sequence that was exchanged meanwhile answers no more: null, the same time is to be asked of its successor. */
  private async ask({ t, blend }: Wanted, preview: boolean): Promise<FrameSet | null> {
    const sequences = this.demand.sequences();
    try {
      const frames = await gather(sequences, t, { preview, blend }, (sequence) => {
        if (blend) return sequence.evaluateBlend(blend);
        return preview ? sequence.preview(t) : sequence.evaluate(t);
      });
      if (frames && !blend) this.demand.policy.noteCost(frames);
      if (this.demand.isCurrent({ sequences })) return frames;
      frames?.release();
      return null;
    } catch (error) {
      if (this.demand.isCurrent({ sequences })) throw error;
      return null;
    }
  }

  /** Waits until what is shown has been drawn; false as soon as a newer time is asked for. */
  private async drawnBeforeNewer(wanted: Wanted): Promise<boolean> {
    let drawn = false;
    const drawing = this.drawing.then(() => {
      drawn = true;
    });
    while (!drawn && this.demand.isNewest(wanted)) await Promise.race([drawing, this.called()]);
    if (!drawn) this.drawing = Promise.resolve();
    return drawn;
  }

  private async playOn(): Promise<void> {
    const from = performance.now();
    const frames = from < this.yieldsUntil ? null : this.lookAhead?.take();
    if (!frames) return this.called();
    try {
      if (this.demand.isCurrent(frames)) await this.show(frames, false);
      else this.lookAhead?.discard();
    } catch (error) {
      this.screen.onError(error);
    } finally {
      frames.release();
    }
    await this.drawing;
    const took = performance.now() - from;
    if (took > SLOW_MS && this.screen.yields?.())
      this.yieldsUntil = performance.now() + Math.min(STAYS * took, LONGEST_MS);
  }

  private async show(frames: FrameSet, eased: boolean): Promise<void> {
    await this.drawing;
    await this.screen.show(frames, eased);
    this.demand.noteShown(frames);
    this.drawing = this.screen.drawn();
  }

  private async ahead(t: number, { signal }: AheadOptions): Promise<FrameSet> {
    const { policy } = this.demand;
    const sequences = this.demand.sequences();
    const preview = this.demand.previewsAt(t);
    // What plays never rests: where nothing is known it goes on exactly and waits a little for that to change.
    void this.survey.measure(t, () => this.lookAhead !== null && policy.doubts(sequences, t));
    const frames = await gather(sequences, t, { preview, blend: null }, (sequence) =>
      sequence.evaluateAhead(t, { preview, signal }),
    );
    if (!frames) throw new Error('A frame that was fetched ahead was overtaken.');
    policy.noteCost(frames);
    return frames;
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
