/**
 * The wanted time (or blend of the keys) and the shown one. Of the times requested while a frame is being computed,
 * only the newest stays wanted.
 */
import type { FrameSet, RunningMotion } from './frame-set.ts';

/** A time that was asked for; a later one has a higher number. */
export interface Wanted {
  readonly t: number;
  /** Instead of the motion's shape at t: the one that the keys blend to in these weights. */
  readonly blend: readonly number[] | null;
  readonly number: number;
}

/** The content of the screen. */
export type Shown = Pick<FrameSet, 't' | 'sequences'>;

export class Demand {
  private newest: Wanted = { t: 0, blend: null, number: 0 };
  /** The newest that was shown, or could not be made. */
  private served = 0;
  private screen: Shown = { t: NaN, sequences: [] };

  constructor(
    readonly sequences: () => readonly RunningMotion[],
    /** The wanted blend; null: the motion. */
    private readonly blend: () => readonly number[] | null = () => null,
  ) {}

  get wanted(): Wanted {
    return this.newest;
  }

  get shown(): Shown {
    return this.screen;
  }

  /** Whether the wanted time is not shown yet. */
  get open(): boolean {
    return this.served < this.newest.number;
  }

  want(t: number): void {
    this.newest = { t, blend: this.blend(), number: this.newest.number + 1 };
  }

  /** Whether the sequences that made it are still those that run. */
  isCurrent({ sequences }: Pick<FrameSet, 'sequences'>): boolean {
    return sequences === this.sequences();
  }

  noteShown({ t, sequences }: FrameSet): void {
    this.screen = { t, sequences };
  }

  /** A frame was shown for it, or could not be made. */
  close({ number }: Wanted): void {
    this.served = number;
  }
}
