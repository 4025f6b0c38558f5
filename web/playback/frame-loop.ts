/**
 * Requests frames and shows them: one time after another, all views together, by demand. Playback frames are computed
 * ahead.
 */
import type { AheadOptions } from '../engine/api/api.ts';
import type { Demand, Shown, Wanted } from './demand.ts';
import { FrameCost } from './frame-cost.ts';
import { gather } from './frame-set.ts';
import type { FrameSet } from './frame-set.ts';
import { LookAhead } from './look-ahead.ts';
import type { Clock } from './look-ahead.ts';

export interface Screen {
  /** Copies the frames to the screen; they are released afterwards. */
  show(frames: FrameSet): void | Promise<void>;
  /** Resolves when the shown content has been drawn. */
  drawn(): Promise<void>;
  /** Whether other work is waiting for the machine. */
  yields?(): boolean;
  onError(error: unknown): void;
}

/** If drawing takes longer than this, in milliseconds, the processor is drawing and other work has to wait. */
const SLOW_MS = 50;
/** When drawing is slow, a playing frame stays for STAYS times its draw time (at most LONGEST_MS). */
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
  /** Until this time, playback draws no new frames and other work can run. */
  private yieldsUntil = -Infinity;
  private readonly cost = new FrameCost();

  constructor(
    private readonly screen: Screen,
    private readonly demand: Demand,
  ) {}

  get busy(): boolean {
    return this.demand.open;
  }

  get shown(): Shown {
    return this.demand.shown;
  }

  /** Resolves when this time, or a newer requested time, has been drawn. */
  request(t: number): Promise<void> {
    this.demand.want(t);
    this.begin();
    return this.idle();
  }

  /** Shows t; call when the time or the motion changes. Playback continues. */
  follow(t: number): void {
    if (!this.lookAhead) this.demand.want(t);
    this.begin();
  }

  /** Starts playback, until `pause`. The clock calls `advance` when its tick changes. */
  play(clock: Clock): void {
    this.lookAhead?.discard();
    this.lookAhead = new LookAhead({
      clock,
      source: { evaluateAhead: (t, options) => this.ahead(t, options) },
      frameMs: () => this.cost.typical(this.demand.sequences()),
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

  /** Stops playback; resolves when no request is open. */
  async rest(): Promise<void> {
    this.pause();
    await this.running;
  }

  /** Resolves when all requests so far are drawn; does not wait for playback. */
  idle(): Promise<void> {
    if (!this.busy) return Promise.resolve();
    return new Promise((resolve) => this.waiting.push({ resolve, number: this.demand.wanted.number }));
  }

  private begin(): void {
    // Frames ahead may belong to an old motion.
    this.lookAhead?.discard();
    this.wake();
    this.start();
  }

  private start(): void {
    this.running ??= this.run();
  }

  private wake(): void {
    for (const call of this.calls.splice(0)) call();
  }

  private called(): Promise<void> {
    return new Promise((resolve) => this.calls.push(resolve));
  }

  private async run(): Promise<void> {
    // A waiting caller may request the next frame immediately, so the state must be final by then.
    await Promise.resolve();
    while (this.busy || this.lookAhead) {
      if (this.busy) await this.serve(this.demand.wanted);
      else await this.playOn();
    }
    this.running = null;
  }

  private async serve(wanted: Wanted): Promise<void> {
    try {
      if (!(await this.draw(wanted))) return;
    } catch (error) {
      this.screen.onError(error);
    }
    this.demand.close(wanted);
    this.waiting = this.waiting.filter(({ resolve, number }) => {
      if (number <= wanted.number) resolve();
      return number > wanted.number;
    });
  }

  /** False if the sequences were replaced meanwhile. */
  private async draw(wanted: Wanted): Promise<boolean> {
    const frames = await this.ask(wanted);
    if (!frames) return false;
    try {
      await this.show(frames);
      await this.drawing;
      return true;
    } finally {
      frames.release();
    }
  }

  /**
   * Requests the frames of a time; null if the sequence was replaced meanwhile. Its successor must be asked for the
   * same time.
   */
  private async ask({ t, blend }: Wanted): Promise<FrameSet | null> {
    const sequences = this.demand.sequences();
    try {
      const frames = await gather(sequences, t, blend, (sequence) =>
        blend ? sequence.evaluateBlend(blend) : sequence.evaluate(t),
      );
      if (frames && !blend) this.cost.note(frames);
      if (this.demand.isCurrent({ sequences })) return frames;
      frames?.release();
      return null;
    } catch (error) {
      if (this.demand.isCurrent({ sequences })) throw error;
      return null;
    }
  }

  private async playOn(): Promise<void> {
    const from = performance.now();
    const frames = from < this.yieldsUntil ? null : this.lookAhead?.take();
    if (!frames) return this.called();
    try {
      if (this.demand.isCurrent(frames)) await this.show(frames);
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

  private async show(frames: FrameSet): Promise<void> {
    await this.drawing;
    await this.screen.show(frames);
    this.demand.noteShown(frames);
    this.drawing = this.screen.drawn();
  }

  private async ahead(t: number, { signal }: AheadOptions): Promise<FrameSet> {
    const frames = await gather(this.demand.sequences(), t, null, (sequence) => sequence.evaluateAhead(t, { signal }));
    if (!frames) throw new Error('A frame that was fetched ahead is no longer needed.');
    this.cost.note(frames);
    return frames;
  }
}
