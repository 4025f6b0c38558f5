/**
 * Which time is wanted, or which blend of the keys instead, which one is shown, and at what quality. The only place
 * that decides what is asked for next and what is dropped:
 * - of the times that are asked for while a frame is under way only the newest stays wanted;
 * - while the time moves a preview may serve it, where the policy allows; when it rests the exact frame does;
 * - a frame of sequences that were exchanged meanwhile is not shown;
 * - an exact frame that would be eased in after its own preview is not shown any more when another time is wanted.
 */
import type { FrameSet, RunningMotion } from './frame-set.ts';
import type { PreviewPolicy } from './preview-policy.ts';

/** A time that was asked for; a later one has a higher number. */
export interface Wanted {
  readonly t: number;
  /** Instead of the motion's shape at t: the one that the keys blend to in these weights. */
  readonly blend: readonly number[] | null;
  readonly number: number;
}

/** What is on the screen. */
export type Shown = Pick<FrameSet, 't' | 'sequences' | 'preview'>;

/** What is to be done: draw a frame, or wait until the time rests unless something happens before. */
export type Next = { wanted: Wanted; preview: boolean } | { restsIn: number };

/** The time rests when no newer one has come for so long. */
const REST_MS = 80;

export class Demand {
  private newest: Wanted = { t: 0, blend: null, number: 0 };
  /** The newest that was served by a preview, and by an exact frame. */
  private previewed = 0;
  private served = 0;
  /** -Infinity where the exact frame is wanted at once. */
  private restsAt = -Infinity;
  private screen: Shown = { t: NaN, sequences: [], preview: false };

  constructor(
    readonly sequences: () => readonly RunningMotion[],
    readonly policy: PreviewPolicy,
    /** The blend that is wanted from here on; null: the motion. */
    private readonly blend: () => readonly number[] | null = () => null,
  ) {}

  get wanted(): Wanted {
    return this.newest;
  }

  get shown(): Shown {
    return this.screen;
  }

  /** Whether the wanted time is not shown exactly yet. */
  get open(): boolean {
    return this.served < this.newest.number;
  }

  /** The exact frame, at once. */
  want(t: number): void {
    this.newest = { t, blend: this.blend(), number: this.newest.number + 1 };
    this.restsAt = -Infinity;
  }

  /** The time, or the motion, is changing: the exact frame when that rests. */
  follow(t: number): void {
    this.want(t);
    this.restsAt = performance.now() + REST_MS;
  }

  /** The time has come to rest, as when a pointer is lifted. Returns whether it had not before. */
  settle(): boolean {
    if (performance.now() >= this.restsAt) return false;
    this.restsAt = -Infinity;
    return true;
  }

  /** Null where nothing is open. */
  next(): Next | null {
    if (!this.open) return null;
    const restsIn = this.restsAt - performance.now();
    // Blends have no previews.
    const preview = restsIn > 0 && !this.newest.blend && this.previewsAt(this.newest.t);
    if (preview && this.previewed === this.newest.number) return { restsIn };
    return { wanted: this.newest, preview };
  }

  /** The quality at which a time is shown that moves or plays. */
  previewsAt(t: number): boolean {
    return this.policy.allows(this.sequences(), t);
  }

  isNewest({ number }: Wanted): boolean {
    return number === this.newest.number;
  }

  /** Whether the sequences that made it are still those that run. */
  isCurrent({ sequences }: Pick<FrameSet, 'sequences'>): boolean {
    return sequences === this.sequences();
  }

  /** Whether an exact frame takes the place of its own preview. */
  eases({ t, sequences, preview }: FrameSet): boolean {
    return !preview && this.screen.preview && this.screen.t === t && this.screen.sequences === sequences;
  }

  noteShown({ t, sequences, preview }: FrameSet): void {
    this.screen = { t, sequences, preview };
  }

  /** Drawing may take long, and nobody hears of a newer time meanwhile: what moves rests so long after that. */
  noteDrawn(wanted: Wanted): void {
    if (this.isNewest(wanted) && this.restsAt !== -Infinity) this.restsAt = performance.now() + REST_MS;
  }

  /** A frame of this quality was shown for it, or could not be made. */
  close({ number }: Wanted, preview: boolean): void {
    this.previewed = number;
    if (!preview) this.served = number;
  }
}
