/** Shapes computed ahead of the clock while the motion plays; what was computed for another motion is given back. */
import { FramePlayer } from '../../engine/caller/frame-player.ts';
import type { FrameSource } from '../../engine/caller/frame-player.ts';
import type { Shapes } from './frame-set.ts';

/** The time that plays, in ticks: about one a screen refresh. */
export interface Clock {
  readonly tick: number;
  /** Where the time will be at a tick. */
  timeOf(tick: number): number;
  tickSeconds(): number;
}

export class Playback {
  private player: FramePlayer<Shapes> | null = null;

  constructor(
    private readonly clock: Clock, private readonly source: FrameSource<Shapes>, private readonly onError: (error: unknown) => void,
  ) {}

  /** The newest shapes that are due and were not taken yet. */
  take(): Shapes | null {
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
