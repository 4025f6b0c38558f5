/** The median of values, or another quantile. */
export function quantile(values: readonly number[], q = 0.5): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN;
}

/** Median and 95th percentile. */
export interface Spread {
  median: number;
  slow: number;
}

export function spread(values: readonly number[]): Spread {
  return { median: quantile(values), slow: quantile(values, 0.95) };
}
