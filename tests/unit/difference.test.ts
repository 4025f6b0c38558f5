import { describe, expect, it } from 'vitest';
import { differenceOf, heatColours, roundTop } from '../../web/app/drawing/difference.ts';
import { viridis } from '../../web/plots/viridis.ts';

describe('the difference from the shape without a ghost mesh', () => {
  const difference = differenceOf(Float32Array.of(0, 0, 0, 1, 1, 1), Float32Array.of(0, 0, 0, 1, 4, 5), 50);

  it('is the distance of each vertex, in percent of the diagonal', () => {
    expect([...difference.percent]).toEqual([0, 10]);
    expect([difference.largest, difference.mean]).toEqual([10, 5]);
  });

  it('is coloured over the whole map', () => {
    const linear = ([...rgb]: number[]): number[] =>
      rgb.map((value) => Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055)));
    const colours = [...heatColours(difference, 10)];
    expect(linear(colours.slice(0, 3))).toEqual([68, 1, 84]);
    expect(linear(colours.slice(3))).toEqual([253, 231, 37]);
    expect([...heatColours(difference, 5)]).toEqual(colours);
    expect(viridis(-1)).toEqual(viridis(0));
  });

  it('has a round number at the top of its bar, and does not magnify noise', () => {
    expect([0.03, 0.2, 0.21, 0.6, 3].map(roundTop)).toEqual([0.05, 0.2, 0.5, 1, 5]);
    expect([0, 1e-7, NaN].map(roundTop)).toEqual([0.001, 0.001, 0.001]);
  });
});
