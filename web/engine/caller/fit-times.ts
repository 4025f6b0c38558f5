/** The times at which a fitted motion has a key or a fitted shape. */
import type { MotionOptions } from '../api/types.ts';
import { METHOD } from '../api/methods.ts';

export interface FitTime {
  time: number;
  /** Key at this time, or -1. */
  key: number;
}

/**
 * The times of all keys, and evenly spaced times between them. With a fitted method, `spaceSamples` intervals in total,
 * or two between two keys if these are more. Otherwise, `keepLengths` times between two keys.
 */
export function fitTimes(
  keyTimes: readonly number[],
  { method, keepLengths, spaceSamples }: Pick<MotionOptions, 'method' | 'keepLengths' | 'spaceSamples'>,
): FitTime[] {
  const lengths = keyTimes.slice(1).map((time, i) => time - keyTimes[i]!);
  const counts =
    METHOD[method].curve === 'fitted' ? shareOut(lengths, spaceSamples) : lengths.map(() => keepLengths + 1);
  const times: FitTime[] = [{ time: keyTimes[0]!, key: 0 }];
  counts.forEach((count, i) => {
    const start = keyTimes[i]!;
    for (let j = 1; j < count; ++j) times.push({ time: start + (lengths[i]! * j) / count, key: -1 });
    times.push({ time: keyTimes[i + 1]!, key: i + 1 });
  });
  return times;
}

/** Distributes `total` samples over the intervals, at least 2 each. The next one always goes to the widest spacing. */
function shareOut(lengths: readonly number[], total: number): number[] {
  const counts = lengths.map(() => 2);
  for (let left = total - 2 * lengths.length; left > 0; --left) {
    const spacings = lengths.map((length, i) => length / counts[i]!);
    ++counts[spacings.indexOf(Math.max(...spacings))]!;
  }
  return counts;
}
