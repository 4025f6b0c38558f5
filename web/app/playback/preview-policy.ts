/**
 * Whether shapes are drawn about right while they move. Measured, not guessed from their size: only where exact ones are too
 * slow for a smooth motion, the cheap ones are much faster, and close at that moment. The page's address may ask for the one or
 * the other.
 */
import type { PreviewError } from '../../engine/api/types.ts';
import { isInLri } from '../../model/state.ts';
import type { RunningSequence } from '../session/sequence-set.ts';
import { PreviewTrust } from './preview-trust.ts';
import type { Sample, TimeLine } from './preview-trust.ts';
import type { FrameSet } from './frame-set.ts';

const MOVING = ['measured', 'close', 'about', 'exact'] as const;

/**
 * How shapes are drawn while they move: as measured; about right where that is close, however fast exact ones are; always about
 * right; always exactly.
 */
export type Moving = (typeof MOVING)[number];

/** What the query of the page's address says, such as `?moving=exact`. */
export function readMoving(search: string): Moving {
  const asked = new URLSearchParams(search).get('moving');
  return MOVING.find((moving) => moving === asked) ?? 'measured';
}

/** Milliseconds in the worker: 30 exact shapes a second need nothing cheaper. */
const SLOW_MS = 30;
/** The cheap shape must take at most this share of the exact one's time. */
const WORTH = 0.7;
/** The least of so many counts: the machine may have been busy with something else. */
const SAMPLES = 3;

export class PreviewPolicy {
  private sequences: readonly RunningSequence[] = [];
  private exact: number[] = [];
  private cheap: number[] = [];
  /** The first cheap shape makes what all need, and says nothing of the time that they take. */
  private prepared = false;
  private trust: PreviewTrust | null = null;

  constructor(private readonly moving: Moving = 'measured') {}

  note({ sequences, about, ms }: FrameSet): void {
    this.follow(sequences);
    const samples = about ? this.cheap : this.exact;
    if (!about || this.prepared) samples.push(ms);
    if (samples.length > SAMPLES) samples.shift();
    this.prepared ||= about;
  }

  about(sequences: readonly RunningSequence[], t: number): boolean {
    this.follow(sequences);
    return this.worthwhile && (this.moving === 'about' || this.trust?.closeAt(t) === true);
  }

  /** Cheap shapes are wanted, or exact ones seem slow, and no cheap one was made yet. */
  untried(sequences: readonly RunningSequence[]): boolean {
    this.follow(sequences);
    if (this.prepared) return false;
    return this.moving === 'measured' ? this.slow : this.moving !== 'exact' && this.possible;
  }

  /** A cheap shape would be drawn at t if it was known to be close. */
  doubts(sequences: readonly RunningSequence[], t: number): boolean {
    this.follow(sequences);
    return this.measures && this.trust?.closeAt(t) === undefined;
  }

  /** Where to measure next what cheap shapes are off, nearest to t first; null where that is known, or does not matter. */
  unmeasured(sequences: readonly RunningSequence[], t: number): Sample | null {
    this.follow(sequences);
    return this.measures ? this.trust?.next(t) ?? null : null;
  }

  /** The error of each sequence's preview. Not noted where the motion is another one now. */
  measured(sequences: readonly RunningSequence[], sample: Sample, errors: readonly PreviewError[]): void {
    if (sequences !== this.sequences) return;
    const most = (of: (error: PreviewError) => number): number => errors.reduce((value, error) => Math.max(value, of(error)), 0);
    this.trust?.note(sample, { mean: most(({ mean }) => mean), largest: most(({ largest }) => largest) });
  }

  private get measures(): boolean {
    return this.worthwhile && this.moving !== 'about';
  }

  /** Cheap shapes are wanted as far as their cost is concerned. The first frames of a sequence are slow: one alone does not tell. */
  private get worthwhile(): boolean {
    if (this.moving !== 'measured') return this.moving !== 'exact' && this.possible;
    return this.exact.length > 1 && this.slow && least(this.cheap) <= WORTH * least(this.exact);
  }

  private get slow(): boolean {
    return this.possible && least(this.exact) > SLOW_MS;
  }

  private get possible(): boolean {
    return this.sequences.some(({ method }) => isInLri(method));
  }

  /** Other sequences have other costs; the same ones keep theirs when they are refitted, but the motion is another. */
  private follow(sequences: readonly RunningSequence[]): void {
    if (sequences === this.sequences) return;
    const same = sequences.length === this.sequences.length && sequences.every(({ sequence }, index) => sequence === this.sequences[index]!.sequence);
    this.sequences = sequences;
    const [main] = sequences;
    this.trust = main ? new PreviewTrust(lineOf(main)) : null;
    if (same) return;
    this.exact = [];
    this.cheap = [];
    this.prepared = false;
  }
}

function lineOf({ sequence: { keyTimes, range, options } }: RunningSequence): TimeLine {
  return { keyTimes, range, periodic: options.boundary === 'periodic' };
}

/** 0 where nothing was measured yet. */
function least(samples: readonly number[]): number {
  return samples.length > 0 ? Math.min(...samples) : 0;
}
