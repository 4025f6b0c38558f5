/** Film strips: positions of their shapes. */
import { describe, expect, it } from 'vitest';
import { columnsOf } from '../../web/app/drawing/onion-skin.ts';

describe('columns of film strips', () => {
  it('have room for their widest shapes, without overlap', () => {
    const widths = [
      [1, 3, 1, 2],
      [2, 1, 1, 4],
    ];
    const columns = columnsOf(widths);
    for (const strip of widths)
      strip.slice(1).forEach((width, i) => {
        expect(columns[i + 1]! - columns[i]!).toBeGreaterThan((width + strip[i]!) / 2);
      });
    // Narrow shapes are closer together than wide ones.
    expect(columns[2]! - columns[1]!).toBeCloseTo(1.08 * 2, 6);
  });

  it('are centred', () => {
    const [first, , last] = columnsOf([[2, 1, 4]]) as [number, number, number];
    expect(first - 1).toBeCloseTo(-(last + 2), 6);
    expect(columnsOf([[5]])).toEqual([0]);
    expect(columnsOf([])).toEqual([]);
  });
});
