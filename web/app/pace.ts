/**
 * Whether shapes are drawn about right while they move. Measured, not guessed from their size: only where exact ones are too
 * slow for a smooth motion, and the cheap ones are much faster. The page's address may ask for the one or the other.
 */
import { isInLri } from '../model/state.ts';
import type { Lane } from './lanes.ts';
import type { Shapes } from './shapes.ts';

const MOVING = ['measured', 'about', 'exact'] as const;

/** How shapes are drawn while they move: as their times say, always about right, or always exactly. */
export type Moving = (typeof MOVING)[number];

/** What the query of the page's address says: `?moving=about` or `?moving=exact`. */
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

export class Pace {
  private lanes: readonly Lane[] = [];
  private exact: number[] = [];
  private cheap: number[] = [];
  /** The first cheap shape makes what all need, and says nothing of the time that they take. */
  private prepared = false;

  constructor(private readonly moving: Moving = 'measured') {}

  note({ lanes, about, ms }: Shapes): void {
    this.follow(lanes);
    const samples = about ? this.cheap : this.exact;
    if (!about || this.prepared) samples.push(ms);
    if (samples.length > SAMPLES) samples.shift();
    this.prepared ||= about;
  }

  /** The first frames of a sequence are slow on any shape: one alone does not tell. */
  about(lanes: readonly Lane[]): boolean {
    this.follow(lanes);
    if (this.moving !== 'measured') return this.moving === 'about' && this.possible;
    return this.exact.length > 1 && this.slow && least(this.cheap) <= WORTH * least(this.exact);
  }

  /** Cheap shapes are wanted, or exact ones seem slow, and no cheap one was made yet. */
  untried(lanes: readonly Lane[]): boolean {
    this.follow(lanes);
    return !this.prepared && (this.moving === 'measured' ? this.slow : this.moving === 'about' && this.possible);
  }

  private get slow(): boolean {
    return this.possible && least(this.exact) > SLOW_MS;
  }

  private get possible(): boolean {
    return this.lanes.some(({ method }) => isInLri(method));
  }

  /** Other sequences have other costs; the same ones keep theirs when they are refitted. */
  private follow(lanes: readonly Lane[]): void {
    const same = lanes.length === this.lanes.length && lanes.every(({ sequence }, index) => sequence === this.lanes[index]!.sequence);
    this.lanes = lanes;
    if (same) return;
    this.exact = [];
    this.cheap = [];
    this.prepared = false;
  }
}

/** 0 where nothing was measured yet. */
function least(samples: readonly number[]): number {
  return samples.length > 0 ? Math.min(...samples) : 0;
}
