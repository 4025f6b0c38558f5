/**
 * Playback: frames on a fixed grid of ticks, computed ahead of the clock in the sequence's worker. The look-ahead is
 * bounded, frames that came too late are skipped, and where the worker is slower than the clock only every second, third, ...
 * tick is asked for, so that what arrives is still to be shown.
 */
import type { Sequence } from './api.ts';
import type { Frame } from './types.ts';

export interface PlayerOptions {
  /** Time of the sequence that a tick shows: speed, direction and loops are the caller's. */
  timeOf: (tick: number) => number;
  /** Seconds from tick to tick. */
  tickSeconds: number;
  /** Frames under way or waiting to be shown; default 4. */
  ahead?: number;
  /** Called once with what went wrong; the player has stopped then. */
  onError?: (error: unknown) => void;
}

interface Ready {
  tick: number;
  frame: Frame;
}

/** How much of the latest cost enters the running mean. */
const NEW_SHARE = 0.25;

export class FramePlayer {
  private readonly sequence: Pick<Sequence, 'evaluateAhead'>;
  private readonly options: Required<PlayerOptions>;
  private ready: Ready[] = [];
  private underWay = 0;
  private asked = -Infinity;
  private meanMs = 0;
  private stopped = false;

  constructor(sequence: Pick<Sequence, 'evaluateAhead'>, options: PlayerOptions) {
    this.sequence = sequence;
    this.options = { ahead: 4, onError: () => undefined, ...options };
  }

  /** The newest frame that is due at this tick and was not taken yet, or null: then the one on show stays. */
  take(tick: number): Frame | null {
    const due = this.ready.filter((entry) => entry.tick <= tick);
    this.ready = this.ready.filter((entry) => entry.tick > tick);
    const newest = due.pop() ?? null;
    for (const { frame } of due) frame.release();
    this.ask(tick);
    return newest?.frame ?? null;
  }

  /** Gives back what waits and what still arrives. Idempotent. */
  stop(): void {
    this.stopped = true;
    for (const { frame } of this.ready.splice(0)) frame.release();
  }

  private ask(tick: number): void {
    // In ticks: what one frame costs.
    const stride = Math.max(1, Math.ceil(this.meanMs / 1000 / this.options.tickSeconds));
    while (!this.stopped && this.underWay + this.ready.length < this.options.ahead) {
      this.asked = this.asked < tick ? tick + (this.asked === -Infinity ? 0 : stride) : this.asked + stride;
      void this.fetch(this.asked);
    }
  }

  private async fetch(tick: number): Promise<void> {
    ++this.underWay;
    try {
      const frame = await this.sequence.evaluateAhead(this.options.timeOf(tick));
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
