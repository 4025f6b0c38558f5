/**
 * Playback: frames on a fixed grid of ticks, computed ahead of the clock in the sequence's worker. The look-ahead is
 * bounded and late frames are skipped. If the worker or drawing is slower than the clock, only every second, third, ...
 * tick is requested, so frames arrive in time to be shown.
 */
import type { AheadOptions } from './api.ts';
import type { Frame } from './types.ts';

export interface PlayerOptions {
  /** Sequence time of a tick. The caller applies speed, direction and loops. */
  timeOf: (tick: number) => number;
  /** Current seconds per tick. */
  tickSeconds: () => number;
  /** Number of frames requested or waiting to be shown; default 4. */
  ahead?: number;
  /** Current milliseconds per frame, if the caller measures them; default: the mean of received frames. */
  frameMs?: () => number;
  /** Called once with the error, after the player has stopped. */
  onError?: (error: unknown) => void;
}

/** One sequence, or several whose frames are shown together. */
export interface FrameSource<F> {
  evaluateAhead(t: number, options: AheadOptions): Promise<F>;
}

interface Ready<F> {
  tick: number;
  frame: F;
}

/** Weight of the latest cost in the running mean. */
const NEW_SHARE = 0.25;
/** Upper bound on the ticks between two calls of take, as longer gaps may be pauses. */
const MAX_APART = 12;
/** Number of ticks to search for a different time. */
const FARTHEST = 30;

export class FramePlayer<F extends Pick<Frame, 'ms' | 'release'> = Frame> {
  private readonly source: FrameSource<F>;
  private readonly options: Required<PlayerOptions>;
  private readonly abort = new AbortController();
  private ready: Ready<F>[] = [];
  private underWay = 0;
  private asked = { tick: -Infinity, t: NaN };
  private meanMs = 0;
  private taken = -Infinity;
  private ticksApart = 1;

  constructor(source: FrameSource<F>, options: PlayerOptions) {
    this.source = source;
    this.options = { ahead: 4, frameMs: () => this.meanMs, onError: () => undefined, ...options };
  }

  /** The newest due frame at this tick that was not taken yet; null to keep the current one. */
  take(tick: number): F | null {
    this.noteTaken(tick);
    let newest: F | null = null;
    while (this.ready[0] && this.ready[0].tick <= tick) {
      newest?.release();
      newest = this.ready.shift()!.frame;
    }
    this.ask(tick);
    return newest;
  }

  /** Releases waiting and arriving frames, and cancels requests that have not started. Idempotent. */
  stop(): void {
    this.abort.abort();
    for (const { frame } of this.ready.splice(0)) frame.release();
  }

  private get stopped(): boolean {
    return this.abort.signal.aborted;
  }

  // No frame is taken while drawing.
  private noteTaken(tick: number): void {
    const apart = tick - this.taken;
    this.taken = tick;
    if (apart > 0 && apart < Infinity) this.ticksApart += NEW_SHARE * (Math.min(apart, MAX_APART) - this.ticksApart);
  }

  private ask(now: number): void {
    while (!this.stopped && this.underWay + this.ready.length < this.options.ahead) {
      const next = this.next(now);
      if (!next) return;
      this.asked = next;
      void this.fetch(next.tick, next.t);
    }
  }

  /** The next tick with a different time; null if it is far ahead. */
  private next(now: number): { tick: number; t: number } | null {
    // The cost of a frame in ticks, and the share of frames drawn.
    const cost = Math.ceil(this.options.frameMs() / 1000 / this.options.tickSeconds());
    const stride = Math.max(1, cost, Math.floor(this.ticksApart));
    const late = this.asked.tick < now;
    const first = this.asked.tick === -Infinity ? now : (late ? now : this.asked.tick) + stride;
    for (let tick = first; tick < first + FARTHEST; ++tick) {
      const t = this.options.timeOf(tick);
      if (t !== this.asked.t) return { tick, t };
    }
    return null;
  }

  private async fetch(tick: number, t: number): Promise<void> {
    ++this.underWay;
    try {
      const frame = await this.source.evaluateAhead(t, { signal: this.abort.signal });
      this.meanMs = this.meanMs === 0 ? frame.ms : (1 - NEW_SHARE) * this.meanMs + NEW_SHARE * frame.ms;
      if (this.stopped) frame.release();
      else this.ready.push({ tick, frame });
    } catch (error) {
      const first = !this.stopped;
      this.stop();
      if (first) this.options.onError(error);
    } finally {
      --this.underWay;
    }
  }
}
