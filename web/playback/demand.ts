/**
 * The requested time (or blend of the keys) and the shown one. Only the newest request is kept while a frame is being
 * computed.
 */
import type { FrameSet, RunningMotion } from './frame-set.ts';

/** A requested time; later requests have higher numbers. */
export interface Wanted {
  readonly t: number;
  /** Weights of a blend of the keys that replaces the motion's shape at t. */
  readonly blend: readonly number[] | null;
  readonly number: number;
}

/** The content of the screen. */
export type Shown = Pick<FrameSet, 't' | 'sequences'>;

export class Demand {
  private newest: Wanted = { t: 0, blend: null, number: 0 };
  /** Number of the newest request that was shown or has failed. */
  private served = 0;
  private screen: Shown = { t: NaN, sequences: [] };

  constructor(
    readonly sequences: () => readonly RunningMotion[],
    /** The requested blend; null: the motion. */
    private readonly blend: () => readonly number[] | null = () => null,
  ) {}

  get wanted(): Wanted {
    return this.newest;
  }

  get shown(): Shown {
    return this.screen;
  }

  /** Whether the requested time is not shown yet. */
  get open(): boolean {
    return this.served < this.newest.number;
  }

  want(t: number): void {
    this.newest = { t, blend: this.blend(), number: this.newest.number + 1 };
  }

  /** Whether the frames' sequences are still running. */
  isCurrent({ sequences }: Pick<FrameSet, 'sequences'>): boolean {
    return sequences === this.sequences();
  }

  noteShown({ t, sequences }: FrameSet): void {
    this.screen = { t, sequences };
  }

  /** The request's frame was shown or has failed. */
  close({ number }: Wanted): void {
    this.served = number;
  }
}
