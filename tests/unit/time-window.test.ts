import { describe, expect, it } from 'vitest';
import {
  MAX_ZOOM,
  fractionIn,
  panned,
  revealing,
  ruler,
  rulerMarks,
  timeIn,
  windowOf,
  zoomed,
} from '../../web/model/time-window.ts';

const scale = { range: [2, 4], whole: [1.2, 4.8] } as const; // time reaches from -2 to 8

describe('the window of the slider', () => {
  it('shows everything by default', () => {
    expect(windowOf(null, scale)).toEqual([1.2, 4.8]);
  });

  it('converts times to positions and back', () => {
    for (const window of [windowOf(null, scale), [2.5, 2.6] as const]) {
      for (const t of [1.2, 2, 2.71, 4, 4.8]) expect(timeIn(fractionIn(t, window), window)).toBeCloseTo(t, 12);
      expect(fractionIn(window[0], window)).toBe(0);
      expect(fractionIn(window[1], window)).toBe(1);
    }
  });

  it('keeps the time under the pointer in place while zooming in and out', () => {
    let window = windowOf(null, scale);
    const at = fractionIn(3.1, window);
    for (const factor of [2, 5, 3, 0.4, 2]) {
      window = windowOf(zoomed(window, scale, factor, 3.1), scale);
      expect(fractionIn(3.1, window)).toBeCloseTo(at, 9);
    }
    expect(3.6 / (window[1] - window[0])).toBeCloseTo(2 * 5 * 3 * 0.4 * 2, 9);
  });

  it('zooms in at least twenty times, up to a limit', () => {
    expect(MAX_ZOOM).toBeGreaterThanOrEqual(20);
    const nearest = zoomed(windowOf(null, scale), scale, 1e9, 3)!;
    expect(3.6 / (nearest[1] - nearest[0])).toBeCloseTo(MAX_ZOOM, 6);
  });

  it('is the whole range again when zoomed out far enough', () => {
    expect(zoomed([3, 3.2], scale, 1e-6, 3.1)).toBeNull();
  });

  it('zooms out to all times that can be reached, and back to the whole range', () => {
    const wider = zoomed([1.2, 4.8], scale, 0.5, 3)!;
    expect(wider[0]).toBeCloseTo(-0.6, 12);
    expect(wider[1]).toBeCloseTo(6.6, 12);
    expect(zoomed(wider, scale, 1e-6, 3)).toEqual([-2, 8]);
    expect(zoomed(wider, scale, 2, 3)).toBeNull();
  });

  it('stays within the times that can be reached', () => {
    expect(panned([3, 3.5], scale, 99)).toEqual([7.5, 8]);
    expect(panned([3, 3.5], scale, -99)).toEqual([-2, -1.5]);
    expect(windowOf([90, 91], scale)).toEqual([7, 8]);
  });

  it('moves by a page when a time leaves it', () => {
    expect(revealing([3, 3.5], scale, 3.2)).toEqual([3, 3.5]);
    const [start, end] = revealing([3, 3.5], scale, 3.51)!;
    expect(start).toBeLessThan(3.51);
    expect(start).toBeGreaterThan(3.4);
    expect(end - start).toBeCloseTo(0.5, 12);
    const back = revealing([3, 3.5], scale, 2.9)!;
    expect(back[1]).toBeGreaterThan(2.9);
    expect(back[1]).toBeLessThan(3);
  });
});

describe('the ruler', () => {
  it('has round numbers in the window, at most the requested number', () => {
    expect(ruler([0, 1], 10).map((t) => Number(t.toFixed(9)))).toEqual([
      0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1,
    ]);
    expect(ruler([-0.4, 1.4], 4).map((t) => Number(t.toFixed(9)))).toEqual([0, 0.5, 1]);
    for (const window of [
      [0.312, 0.347],
      [-7, 912],
      [1e-7, 3e-7],
    ] as const) {
      const marks = ruler(window, 8);
      expect(marks.length).toBeGreaterThan(1);
      expect(marks.length).toBeLessThanOrEqual(9);
      expect(marks[0]).toBeGreaterThanOrEqual(window[0] - 1e-15);
      expect(marks.at(-1)).toBeLessThanOrEqual(window[1] + 1e-12);
    }
  });

  it('counts seconds, or whole frames', () => {
    const read = (fps: number | null) => rulerMarks([-0.1, 0.1], fps, 4).map(({ text }) => text);
    expect(read(null)).toEqual(['-0.10 s', '-0.05 s', '0.00 s', '0.05 s', '0.10 s']);
    expect(read(24)).toEqual(['-2', '0', '2']);
    expect(rulerMarks([-0.1, 0.1], 24, 4)[0]!.time).toBe(-2 / 24);
  });
});
