/**
 * On which stretches of the timeline a preview may stand for the shape: those on which it was measured to be close. A
 * stretch reaches from key to key, or lies beyond the keys; nothing is known of it before all its moments were
 * measured.
 */
import type { PreviewError } from '../engine/api/types.ts';
import { timeScale, wrap } from '../model/time-scale.ts';
import type { Range } from '../model/time-scale.ts';

/** What the motion is measured over. */
export interface TimeLine {
  keyTimes: readonly number[];
  /** Where the keys define the motion: for a closed one its whole period. */
  range: Range;
  periodic: boolean;
}

/** A moment to be measured. */
export interface Sample {
  t: number;
  stretch: number;
}

/** Between the measured moments real shapes were off by up to 1.1 times what they were at those. */
const HEADROOM = 1.1;
/**
 * What cannot be seen while the shape moves, as shares of the diagonal: between the keys, and beyond them, where no
 * pose is near.
 */
const BETWEEN: PreviewError = { mean: 0.001, largest: 0.005 };
const BEYOND: PreviewError = { mean: 0.01, largest: 0.05 };
/**
 * Moments of a stretch as shares of it: previews meet the keys, and are off the most about halfway; beyond the keys at
 * the far end.
 */
const MOMENTS_BETWEEN = [0.5, 0.25, 0.75] as const;
const MOMENTS_BEYOND = [1, 2 / 3, 1 / 3] as const;
/** Stretches beyond either end. */
const STEPS_BEYOND = 4;

interface Stretch {
  start: number;
  end: number;
  limit: PreviewError;
  /** Yet to be measured. */
  moments: number[];
  close: boolean;
}

export class PreviewTrust {
  private readonly stretches: Stretch[];

  constructor(private readonly line: TimeLine) {
    this.stretches = stretchesOf(line);
  }

  /** Whether the preview at t is close to the shape; undefined as long as that is not known. */
  closeAt(t: number): boolean | undefined {
    const stretch = this.stretches[this.nearest(t, this.stretches)];
    if (!stretch || !contains(stretch, this.wrapped(t))) return false;
    return stretch.moments.length > 0 ? undefined : stretch.close;
  }

  /** What to measure next, on the stretch nearest to t of those that are not known; null where all are. */
  next(t: number): Sample | null {
    const stretch = this.nearest(
      t,
      this.stretches.filter(({ moments }) => moments.length > 0),
    );
    const moment = this.stretches[stretch]?.moments[0];
    return moment === undefined ? null : { t: moment, stretch };
  }

  /** One moment that is too far off decides for its stretch. */
  note({ t, stretch: index }: Sample, { mean, largest }: PreviewError): void {
    const stretch = this.stretches[index]!;
    stretch.close &&= HEADROOM * mean <= stretch.limit.mean && HEADROOM * largest <= stretch.limit.largest;
    stretch.moments = stretch.close ? stretch.moments.filter((moment) => moment !== t) : [];
  }

  private wrapped(t: number): number {
    return this.line.periodic ? wrap(t, this.line.range) : t;
  }

  /** Index among all stretches of the one of `candidates` that is nearest to t; -1 without any. */
  private nearest(t: number, candidates: readonly Stretch[]): number {
    const inside = this.wrapped(t);
    const distance = ({ start, end }: Stretch): number => Math.max(start - inside, inside - end, 0);
    const [first, ...rest] = candidates;
    if (!first) return -1;
    return this.stretches.indexOf(
      rest.reduce((best, other) => (distance(other) < distance(best) ? other : best), first),
    );
  }
}

function contains({ start, end }: Stretch, t: number): boolean {
  return t >= start && t <= end;
}

function stretchesOf({ keyTimes, range, periodic }: TimeLine): Stretch[] {
  const [low, high] = timeScale(range, keyTimes.length).whole;
  const ends = [...keyTimes.filter((t) => t > range[0] && t < range[1]), range[1]];
  const between = ends.map((end, index) => stretchOf(ends[index - 1] ?? range[0], end, BETWEEN, MOMENTS_BETWEEN));
  if (periodic) return between;
  const beyond = (from: number, to: number): Stretch[] =>
    Array.from({ length: STEPS_BEYOND }, (_, step) => {
      const at = (index: number): number => (index === STEPS_BEYOND ? to : from + ((to - from) * index) / STEPS_BEYOND);
      return stretchOf(at(step), at(step + 1), BEYOND, MOMENTS_BEYOND);
    });
  return [...between, ...beyond(range[0], low), ...beyond(range[1], high)];
}

/** `from` may be later than `to`: moments are counted from it. */
function stretchOf(from: number, to: number, limit: PreviewError, moments: readonly number[]): Stretch {
  return {
    start: Math.min(from, to),
    end: Math.max(from, to),
    limit,
    close: true,
    moments: moments.map((share) => from + share * (to - from)),
  };
}
