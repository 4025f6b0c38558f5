import { describe, expect, it } from 'vitest';
import { doubtsOfPlace, doubtsOfTime } from '../../../web/cli/doubts.ts';
import type { Pair } from '../../../web/cli/doubts.ts';

const motion = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, 0, 0.3, 0.4, 1);

const pairs = (turn: (x: number, y: number, z: number) => number[]): Pair[] => {
  const points = [0, 3, 6, 9].map((at) => turn(...(motion.slice(at, at + 3) as unknown as [number, number, number])));
  return [{ motion, animation: Float32Array.from(points.flat()) }];
};
const same = pairs((x, y, z) => [x, y, z]);

describe('a comparison is doubted', () => {
  it('if the times differ, or few are compared', () => {
    const spans = { keys: [0, 2], animation: [0, 2], frames: 60, compared: 60 } as const;
    expect(doubtsOfTime(spans)).toEqual([]);
    expect(doubtsOfTime({ ...spans, animation: [0, 2.5], compared: 48 })[0]).toMatch(
      /from 0 to 2 s, and the animation from 0 to 2.5 s\. 48 of its 60 frames .* --key-times/,
    );
    expect(doubtsOfTime({ ...spans, compared: 3 })).toEqual([
      'only 3 frames are compared, too few to judge the motion',
    ]);
    expect(doubtsOfTime({ ...spans, compared: 1 })[0]).toBe('only 1 frame is compared, too few to judge the motion');
  });

  it('if another axis is up: of the animation, or of the keys according to the animation', () => {
    const read = (up: 'y' | 'z' | null) => ({ up, unit: 1 });
    expect(doubtsOfPlace(same, read('y'))).toEqual([]);
    const lying = pairs((x, y, z) => [x, -z, y]);
    const stoodUp = pairs((x, y, z) => [x, z, -y]);
    expect(doubtsOfPlace(lying, read('y'))[0]).toMatch(/Give --against-up z$/);
    expect(doubtsOfPlace(stoodUp, read('z'))[0]).toMatch(/Give --against-up y$/);
    expect(doubtsOfPlace(lying, read(null))[0]).toMatch(/Give --up y$/);
    expect(doubtsOfPlace(stoodUp, read(null))[0]).toMatch(/Give --up z$/);
  });

  it('if the animation has another size or position', () => {
    const large = pairs((x, y, z) => [1000 * x, 1000 * y, 1000 * z]);
    expect(doubtsOfPlace(large, { up: 'y', unit: 1 })[0]).toMatch(/1000 times as large .* --against-unit 0.001$/);
    expect(
      doubtsOfPlace(
        pairs((x, y, z) => [x + 40, y, z]),
        { up: 'y', unit: 1 },
      )[0],
    ).toMatch(/is offset from the motion/);
    const beside = pairs((x, y, z) => [x + 0.2, y, z]);
    expect(doubtsOfPlace(beside, { up: 'y', unit: 1 })[0]).toMatch(
      /is offset from the motion by 8.16 % of the shape's size\. This offset causes most of the error/,
    );
  });
});
