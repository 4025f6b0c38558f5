/** Progress of work as part of larger work. */
import type { Progress } from './types.ts';

type Report = (progress: Progress) => void;

/** Share of encoding in the time to the first motion in LRI space. The rest is the creation of that space. */
export const ENCODING_SHARE = 0.15;

/** Converts fractions of a part to fractions of the whole, between `from` and `to`. */
export function partOf(report: Report, from: number, to: number): Report {
  return ({ stage, fraction }) => report({ stage, fraction: from + fraction * (to - from) });
}
