/** Frames computed ahead of the clock during playback. Frames of a replaced motion are released. */
import { FramePlayer } from '../engine/api/frame-player.ts';
import type { FrameSource } from '../engine/api/frame-player.ts';
import type { FrameSet } from './frame-set.ts';

/** Playback time in ticks, about one per screen refresh. */
export interface Clock {
  readonly tick: number;
  /** The time at a tick. */
  timeOf(tick: number): number;
  tickSeconds(): number;
}

export interface LookAheadParts {
  clock: Clock;
  source: FrameSource<FrameSet>;
  /** Cost of a frame in milliseconds; 0 if unknown. */
  frameMs(): number;
  onError(error: unknown): void;
}

export class LookAhead {
  private player: FramePlayer<FrameSet> | null = null;

  constructor(private readonly parts: LookAheadParts) {}

  /** The newest due frames that were not taken yet. */
  take(): FrameSet | null {
    const { clock, source, frameMs, onError } = this.parts;
    this.player ??= new FramePlayer(source, {
      timeOf: (tick) => clock.timeOf(tick),
      tickSeconds: () => clock.tickSeconds(),
      frameMs,
      onError: (error) => {
        this.player = null;
        onError(error);
      },
    });
    return this.player.take(clock.tick);
  }

  discard(): void {
    this.player?.stop();
    this.player = null;
  }
}
