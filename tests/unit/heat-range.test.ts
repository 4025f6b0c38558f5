import { describe, expect, it } from 'vitest';
import { quantile, robustLargest } from '../../web/app/drawing/heat-range.ts';

/** Evenly spaced values from 0 to `most`, in random order. */
const even = (count: number, most: number): Float32Array =>
  Float32Array.from({ length: count }, (_, i) => (most * ((i * 7919) % count)) / (count - 1));

const largestOf = (values: Float32Array): number => values.reduce((a, b) => Math.max(a, b), 0);

describe('the upper end of a colour scale', () => {
  it('is the largest amount if it is similar to others', () => {
    for (const most of [0.03, 5, 300]) {
      const values = even(10_007, most);
      expect(robustLargest(values, largestOf(values))).toBe(largestOf(values));
    }
  });

  it('is not determined by a few slivers', () => {
    const values = even(10_007, 20);
    for (let i = 0; i < 90; i += 1) values[100 * i] = 50_000;
    const end = robustLargest(values, 50_000);
    expect(end).toBeGreaterThan(39);
    expect(end).toBeLessThan(42);
  });

  it('includes amounts of more than a few vertices', () => {
    const values = even(10_007, 20);
    for (let i = 0; i < 200; i += 1) values[50 * i] = 400;
    expect(robustLargest(values, 400)).toBe(400);
  });

  it('does not magnify noise: the scale is at least 1 %', () => {
    const values = new Float32Array(1000);
    values[3] = 80;
    expect(robustLargest(values, 80)).toBe(1);
    expect(robustLargest(new Float32Array(10), 0)).toBe(0);
    expect(robustLargest(new Float32Array(0), 0)).toBe(0);
  });
});

describe('a quantile by counting', () => {
  it('is at most 3 % above that of sorted values, and never below', () => {
    for (const most of [1e-6, 1, 1e7]) {
      const values = even(5003, most);
      const sorted = [...values].sort((a, b) => a - b);
      for (const share of [0.1, 0.5, 0.99, 1]) {
        const exact = sorted[Math.ceil(share * sorted.length) - 1]!;
        expect(quantile(values, share)).toBeGreaterThanOrEqual(exact);
        expect(quantile(values, share)).toBeLessThan(1.04 * exact);
      }
    }
  });
});
