import { describe, expect, it } from 'vitest';
import { alignmentWarnings, timeWarnings } from '../../../web/cli/comparison-warnings.ts';
import type { Pair } from '../../../web/cli/comparison-warnings.ts';

const motion = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, 0, 0.3, 0.4, 1);

const pairs = (turn: (x: number, y: number, z: number) => number[]): Pair[] => {
  const points = [0, 3, 6, 9].map((at) => turn(...(motion.slice(at, at + 3) as unknown as [number, number, number])));
  return [{ motion, animation: Float32Array.from(points.flat()) }];
};
const same = pairs((x, y, z) => [x, y, z]);

describe('a comparison is doubted', () => {
  it('if the times differ, or few are compared', () => {
    const spans = { keys: [0, 2], animation: [0, 2], frames: 60, compared: 60 } as const;
    expect(timeWarnings(spans)).toEqual([]);
    expect(timeWarnings({ ...spans, animation: [0, 2.5], compared: 48 })[0]).toMatch(
      /from 0 to 2 s, and the animation from 0 to 2.5 s\. 48 of its 60 frames .* --key-times/,
    );
    expect(timeWarnings({ ...spans, compared: 3 })).toEqual([
      'only 3 frames are compared, too few to judge the motion',
    ]);
    expect(timeWarnings({ ...spans, compared: 1 })[0]).toBe('only 1 frame is compared, too few to judge the motion');
  });

  it('if another axis is up: of the animation, or of the keys according to the animation', () => {
    const read = (up: 'y' | 'z' | null) => ({ up, unit: 1 });
    expect(alignmentWarnings(same, read('y'))).toEqual([]);
    const laidBack = pairs((x, y, z) => [x, -z, y]);
    const stoodUp = pairs((x, y, z) => [x, z, -y]);
    expect(alignmentWarnings(laidBack, read('y'))[0]).toMatch(/Give --against-up z$/);
    expect(alignmentWarnings(stoodUp, read('z'))[0]).toMatch(/Give --against-up y$/);
    expect(alignmentWarnings(laidBack, read(null))[0]).toMatch(/Give --up y$/);
    expect(alignmentWarnings(stoodUp, read(null))[0]).toMatch(/Give --up z$/);
  });

  it('if the animation has another size or position', () => {
    const large = pairs((x, y, z) => [1000 * x, 1000 * y, 1000 * z]);
    expect(alignmentWarnings(large, { up: 'y', unit: 1 })[0]).toMatch(/1000 times as large .* --against-unit 0.001$/);
    expect(
      alignmentWarnings(
        pairs((x, y, z) => [x + 40, y, z]),
        { up: 'y', unit: 1 },
      )[0],
    ).toMatch(/is offset from the motion/);
    const beside = pairs((x, y, z) => [x + 0.2, y, z]);
    expect(alignmentWarnings(beside, { up: 'y', unit: 1 })[0]).toMatch(
      /is offset from the motion by 8.16 % of the shape's size\. This offset causes most of the error/,
    );
  });
});
