import { describe, expect, it } from 'vitest';
import { commonBox, drawnBox } from '../../web/app/export/crop.ts';
import { frameTimestamps } from '../../web/app/export/frame-timestamps.ts';
import { pingPong } from '../../web/engine/caller/bounce.ts';

describe('a recorded video', () => {
  it('gets the intended times, in the display order of the frames', () => {
    // The recorded times are slow, uneven, and not in display order.
    const times = frameTimestamps([0.1, 0.9, 0.3], 3, 30);
    expect(times.map(({ timestamp }) => timestamp)).toEqual([0, 2 / 30, 1 / 30]);
    for (const { duration } of times) expect(duration).toBeCloseTo(1 / 30, 12);
  });

  it('fills the time where frames were left out', () => {
    const times = frameTimestamps([0, 1, 2], 4, 4);
    expect(times.map(({ timestamp }) => timestamp)).toEqual([0, 1 / 3, 2 / 3]);
    expect(times.reduce((sum, { duration }) => sum + duration, 0)).toBeCloseTo(1, 12);
    expect(frameTimestamps([0.5], 3, 30)).toEqual([{ timestamp: 0, duration: 0.1 }]);
  });
});

describe('an animation that plays back and forth', () => {
  it('shows each shape twice except the last', () => {
    const { seconds, weights } = pingPong({ seconds: [0, 1, 3], weights: null }, 3);
    expect(seconds).toEqual([0, 1, 3, 5, 6]);
    // The third target is a still, which is stored but never shown.
    expect([...weights!]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0]);
  });

  it('keeps its own weights, and is refused if it would not open again', () => {
    const { weights } = pingPong({ seconds: [0, 1], weights: Float32Array.of(1, 2, 3, 4) }, 2);
    expect([...weights!]).toEqual([1, 2, 3, 4, 1, 2]);
    const many = Array.from({ length: 3000 }, (_, i) => i);
    expect(() => pingPong({ seconds: many, weights: null }, 2999)).toThrow(/forwards only/);
  });
});

describe('cropping', () => {
  const picture = (width: number, height: number, drawn: readonly [number, number][]) => {
    const data = new Uint8ClampedArray(4 * width * height);
    for (const [x, y] of drawn) data[4 * (y * width + x) + 3] = 255;
    return { data, width, height };
  };

  it('finds the drawn area', () => {
    expect(
      drawnBox(
        picture(8, 6, [
          [2, 1],
          [5, 4],
        ]),
      ),
    ).toEqual({ left: 2, top: 1, right: 6, bottom: 5 });
    expect(drawnBox(picture(8, 6, []))).toBeNull();
  });

  it('gives all views the same box, with a margin inside them', () => {
    const boxes = [{ left: 100, top: 50, right: 200, bottom: 90 }, null, { left: 80, top: 60, right: 150, bottom: 99 }];
    expect(commonBox(boxes, { width: 300, height: 100 })).toEqual({ left: 76, top: 46, right: 204, bottom: 100 });
    expect(commonBox([null], { width: 300, height: 100 })).toEqual({ left: 0, top: 0, right: 300, bottom: 100 });
  });
});
