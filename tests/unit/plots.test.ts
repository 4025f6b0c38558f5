import { describe, expect, it } from 'vitest';
import {
  apart,
  decades,
  extent,
  linearScale,
  logFloor,
  logScale,
  padded,
  path,
  tickLabel,
  ticks,
} from '../../web/plots/scale.ts';

describe('scales', () => {
  it('map the ends of the domain to the ends of the plot', () => {
    const x = linearScale([-2, 6], 10, 90);
    expect([x(-2), x(2), x(6)]).toEqual([10, 50, 90]);
  });

  it('put everything in the middle if all values are equal', () => {
    expect(linearScale([3, 3], 0, 10)(3)).toBe(5);
  });

  it('ignore values that are not finite', () => {
    expect(extent([NaN, 2, Infinity, -1])).toEqual([-1, 2]);
    expect(extent([NaN])).toEqual([0, 1]);
  });

  it('never reduce a range to a point', () => {
    const [low, high] = padded([5, 5], 0.1);
    expect(high).toBeGreaterThan(low);
  });
});

describe('ticks', () => {
  it('are round numbers inside the interval', () => {
    expect(ticks([0.3, 9.8], 4)).toEqual([5]);
    expect(ticks([0, 1], 4)).toEqual([0, 0.5, 1]);
    expect(ticks([-0.1, 0.1], 4)).toEqual([-0.1, -0.05, 0, 0.05, 0.1]);
    expect(ticks([97.3, 102.9], 3)).toEqual([98, 100, 102]);
  });

  it('are none without an interval', () => {
    expect(ticks([1, 1], 4)).toEqual([]);
    expect(ticks([0, Infinity], 4)).toEqual([]);
  });

  it('that are close are thinned out, keeping the first', () => {
    expect(apart([0, 5, 13, 14, 26.5], 13)).toEqual([0, 2, 4]);
    expect(apart([], 13)).toEqual([]);
  });

  it('have short labels', () => {
    expect([100, 0.05, 123456, 0].map(tickLabel)).toEqual(['100', '0.05', '10⁵', '0']);
    expect([-0.5, -1e-10, 2.4e-4, -3e17].map(tickLabel)).toEqual(['−0.5', '−10⁻¹⁰', '2·10⁻⁴', '−3·10¹⁷']);
  });
});

describe('path', () => {
  it('lifts the pen over gaps', () => {
    expect(
      path([
        [0, 0],
        [1, 2],
        [2, NaN],
        [3, 4],
        [4, 4],
      ]),
    ).toBe('M0.00 0.00L1.00 2.00M3.00 4.00L4.00 4.00');
  });
});

describe('an axis in powers of ten', () => {
  const peaks = [1e-23, 11_581, 1e-22, NaN];
  const smooth = [0.0009, 20, 75, 20];

  it('is used if a curve would be flat on a linear one, two powers below its peak', () => {
    expect(logFloor([smooth, peaks])).toBe(0.1);
    expect(logFloor([smooth, [2000, 0, 100, 0]])).toBeNull();
    expect(logFloor([smooth])).toBeNull();
  });

  it('is not used for rounding errors, nor without values', () => {
    expect(logFloor([peaks, [1e-20, 1e-21, 0, 0]])).toBeNull();
    expect(logFloor([[0, 0], [NaN]])).toBeNull();
    expect(logFloor([])).toBeNull();
  });

  it('spaces powers evenly, with smaller values at the edge and gaps for unknown values', () => {
    const y = logScale([0.1, 1000], 100, 0);
    expect([0.1, 1, 10, 1000].map((value) => Math.round(y(value)))).toEqual([100, 75, 50, 0]);
    expect([0, 1e-20, -1].map(y)).toEqual([100, 100, 100]);
    expect(y(NaN)).toBeNaN();
  });

  it('has few round labels', () => {
    expect(decades([0.1, 29_000], 3)).toEqual([0.1, 10, 1000]);
    expect(decades([1, 300], 3)).toEqual([1, 10, 100]);
  });
});
