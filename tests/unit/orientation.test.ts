/** Poses added to an open shape, after the files are read with another orientation or offset. */
import { expect, it } from 'vitest';
import { relativeTo, reoriented } from '../../web/model/orientation.ts';

const BEFORE = { up: 'y', unit: 1 } as const;
const AFTER = { up: 'z', unit: 0.001 } as const;

it('a pose keeps its position when axes and unit change, each with its own offset', () => {
  const pose = Float32Array.of(0.5, 1.25, -2);
  const offsets = [[432_100, 4, 5_412_344] as const, [432.125, 5412.5, -0.5] as const] as const;
  const turned = reoriented(pose, BEFORE, AFTER, offsets);
  const absolute = Array.from(turned, (value, i) => value + offsets[1][i]!);
  expect(absolute[0]).toBeCloseTo(432.1005, 6);
  expect(absolute[1]).toBeCloseTo(5412.342, 6);
  expect(absolute[2]).toBeCloseTo(-0.00525, 6);
  const back = reoriented(turned, AFTER, BEFORE, [offsets[1], offsets[0]]);
  back.forEach((value, i) => expect(value).toBeCloseTo(pose[i]!, 3));
});

it('a pose stored near the origin moves to the offset of the files', () => {
  const far = Float32Array.of(1000.5, 2, -499.75);
  expect(relativeTo(far, [0, 0, 0], [1000, 0, -500])).toEqual(Float32Array.of(0.5, 2, 0.25));
  expect(relativeTo(far, [4, 5, 6], [4, 5, 6])).toEqual(far);
});
