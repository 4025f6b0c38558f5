/** The times at which a fitted motion has shapes of its own. */
import type { MotionOptions } from '../api/types.ts';
import { METHOD } from '../api/methods.ts';

export interface FitTime {
  time: number;
  /** Key at this time, or -1. */
  key: number;
}

/**
 * Every key and evenly spaced times between neighbours. With a fitted method: `spaceSamples` intervals in all, at least
 * one between two keys. Otherwise: `keepLengths` times between two keys.
 */
export function fitTimes(
  keyTimes: readonly number[],
  { method, keepLengths, spaceSamples }: Pick<MotionOptions, 'method' | 'keepLengths' | 'spaceSamples'>,
): FitTime[] {
  const lengths = keyTimes.slice(1).map((time, i) => time - keyTimes[i]!);
  const counts =
    METHOD[method].curve === 'fitted' ? shareOut(lengths, spaceSamples) : lengths.map(() => keepLengths + 1);
  const times: FitTime[] = [{ time: keyTimes[0]!, key: 0 }];
  for (const [i, count] of counts.entries()) {
    const start = keyTimes[i]!;
    for (let j = 1; j < count; ++j) times.push({ time: start + (lengths[i]! * j) / count, key: -1 });
    times.push({ time: keyTimes[i + 1]!, key: i + 1 });
  }
  return times;
}

/** Whole numbers of at least 1, one more at a time where intervals are longest. */
function shareOut(lengths: readonly number[], total: number): number[] {
  const counts = lengths.map(() => 1);
  for (let left = total - lengths.length; left > 0; --left) {
    const spacings = lengths.map((length, i) => length / counts[i]!);
    ++counts[spacings.indexOf(Math.max(...spacings))]!;
  }
  return counts;
}
