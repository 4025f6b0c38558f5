import { describe, expect, it } from 'vitest';
import { extent, linearScale, padded, path, tickLabel, ticks } from '../../web/plots/scale.ts';

describe('scales', () => {
  it('carry the ends of the domain to the ends of the picture', () => {
    const x = linearScale([-2, 6], 10, 90);
    expect([x(-2), x(2), x(6)]).toEqual([10, 50, 90]);
  });

  it('put everything in the middle where all values are the same', () => {
    expect(linearScale([3, 3], 0, 10)(3)).toBe(5);
  });

  it('ignore what is not finite', () => {
    expect(extent([NaN, 2, Infinity, -1])).toEqual([-1, 2]);
    expect(extent([NaN])).toEqual([0, 1]);
  });

  it('never shrink a point to nothing', () => {
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

  it('are written shortly', () => {
    expect([100, 0.05, 123456, 0].map(tickLabel)).toEqual(['100', '0.05', '1e+5', '0']);
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
