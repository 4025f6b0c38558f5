/**
 * Whether previews are drawn while shapes move. Measured, not guessed from their size: only where exact frames are too
 * slow for a smooth motion, previews are much faster, and close at that time. The page's address may ask for either.
 */
import { METHOD } from '../engine/api/methods.ts';
import type { PreviewError } from '../engine/api/types.ts';
import { FrameCost } from './frame-cost.ts';
import type { FrameSet, RunningMotion } from './frame-set.ts';
import { PreviewTrust } from './preview-trust.ts';
import type { Sample, TimeLine } from './preview-trust.ts';

const MOVING = ['measured', 'close', 'preview', 'exact'] as const;

/**
 * How shapes are drawn while they move: as measured; by previews where they are close, however fast exact frames are;
 * always by previews; always exactly.
 */
export type Moving = (typeof MOVING)[number];

/** What the query of the page's address says, such as `?moving=exact`. */
export function readMoving(search: string): Moving {
  const asked = new URLSearchParams(search).get('moving');
  return MOVING.find((moving) => moving === asked) ?? 'measured';
}

/** Milliseconds in the worker: 30 exact frames a second need nothing cheaper. */
const SLOW_MS = 30;
/** A preview must take at most this share of the exact frame's time. */
const WORTH = 0.7;

export class PreviewPolicy {
  private sequences: readonly RunningMotion[] = [];
  private cost = new FrameCost();
  private trust: PreviewTrust | null = null;

  constructor(private readonly moving: Moving = 'measured') {}

  noteCost(frames: FrameSet): void {
    this.follow(frames.sequences);
    this.cost.note(frames);
  }

  /** Whether a preview is drawn at t while the shape moves. */
  allows(sequences: readonly RunningMotion[], t: number): boolean {
    this.follow(sequences);
    return this.worthwhile && (this.moving === 'preview' || this.trust?.closeAt(t) === true);
  }

  /** What a frame that plays at t costs, in milliseconds; 0 where that is not known yet. */
  typicalMs(sequences: readonly RunningMotion[], t: number): number {
    return this.cost.typical(this.allows(sequences, t));
  }

  /** Previews are wanted, or exact frames seem slow, and no preview was made yet. */
  untried(sequences: readonly RunningMotion[]): boolean {
    this.follow(sequences);
    if (this.cost.hasPreviews) return false;
    return this.moving === 'measured' ? this.slow : this.moving !== 'exact' && this.possible;
  }

  /** A preview would be drawn at t if it was known to be close. */
  doubts(sequences: readonly RunningMotion[], t: number): boolean {
    this.follow(sequences);
    return this.measures && this.trust?.closeAt(t) === undefined;
  }

  /** Where to measure the error of previews next, nearest to t first; null where that is known, or does not matter. */
  unmeasured(sequences: readonly RunningMotion[], t: number): Sample | null {
    this.follow(sequences);
    return this.measures ? (this.trust?.next(t) ?? null) : null;
  }

  /** The errors of the sequences' previews. Not noted where the motion is another one now. */
  noteErrors(sequences: readonly RunningMotion[], sample: Sample, errors: readonly PreviewError[]): void {
    if (sequences !== this.sequences) return;
    const most = (of: (error: PreviewError) => number): number => Math.max(0, ...errors.map(of));
    this.trust?.note(sample, { mean: most(({ mean }) => mean), largest: most(({ largest }) => largest) });
  }

  private get measures(): boolean {
    return this.worthwhile && this.moving !== 'preview';
  }

  /** Previews are wanted as far as their cost is concerned. */
  private get worthwhile(): boolean {
    if (this.moving !== 'measured') return this.moving !== 'exact' && this.possible;
    return this.cost.knowsExact && this.slow && this.cost.least(true) <= WORTH * this.cost.least(false);
  }

  private get slow(): boolean {
    return this.possible && this.cost.least(false) > SLOW_MS;
  }

  private get possible(): boolean {
    return this.sequences.some(({ method }) => METHOD[method].space === 'lri');
  }

  /** Other sequences have other costs; the same ones keep theirs when they are refitted, but the motion is another. */
  private follow(sequences: readonly RunningMotion[]): void {
    if (sequences === this.sequences) return;
    const same =
      sequences.length === this.sequences.length &&
      sequences.every(({ sequence }, index) => sequence === this.sequences[index]!.sequence);
    this.sequences = sequences;
    const [main] = sequences;
    this.trust = main ? new PreviewTrust(lineOf(main)) : null;
    if (!same) this.cost = new FrameCost();
  }
}

function lineOf({ sequence: { keyTimes, range, options } }: RunningMotion): TimeLine {
  return { keyTimes, range, periodic: options.boundary === 'periodic' };
}
