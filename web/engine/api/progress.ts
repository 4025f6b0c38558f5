/** Progress of work that is a part of other work. */
import type { Progress } from './types.ts';

type Report = (progress: Progress) => void;

/** Share of encoding in the time to the first motion in LRI space; the rest is the creation of that space. */
export const ENCODING_SHARE = 0.15;

/** Reports fractions of the part as fractions of the whole, between `from` and `to`. */
export function partOf(report: Report, from: number, to: number): Report {
  return ({ stage, fraction }) => report({ stage, fraction: from + fraction * (to - from) });
}
