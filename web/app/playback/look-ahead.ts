/** FrameSet computed ahead of the clock while the motion plays; what was computed for another motion is given back. */
import { FramePlayer } from '../../engine/caller/frame-player.ts';
import type { FrameSource } from '../../engine/caller/frame-player.ts';
import type { FrameSet } from './frame-set.ts';

/** The time that plays, in ticks: about one a screen refresh. */
export interface Clock {
  readonly tick: number;
  /** Where the time will be at a tick. */
  timeOf(tick: number): number;
  tickSeconds(): number;
}

export class LookAhead {
  private player: FramePlayer<FrameSet> | null = null;

  constructor(
    private readonly clock: Clock, private readonly source: FrameSource<FrameSet>, private readonly onError: (error: unknown) => void,
  ) {}

  /** The newest shapes that are due and were not taken yet. */
  take(): FrameSet | null {
    this.player ??= new FramePlayer(this.source, {
      timeOf: (tick) => this.clock.timeOf(tick),
      tickSeconds: () => this.clock.tickSeconds(),
      onError: (error) => {
        this.player = null;
        this.onError(error);
      },
    });
    return this.player.take(this.clock.tick);
  }

  discard(): void {
    this.player?.stop();
    this.player = null;
  }
}
