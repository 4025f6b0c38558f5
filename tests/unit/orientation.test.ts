/** Poses added to an open shape, after the files are read with another orientation or offset. */
import { expect, it } from 'vitest';
import { relativeTo, reoriented, reorientedDoc } from '../../web/model/orientation.ts';
import { setMotion } from '../../web/model/edits.ts';
import type { PathKey } from '../../web/engine/api/types.ts';
import { docOfKeys } from './documents.ts';

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

it('offsets of pins turn and scale with the shape, without its offset, and exactly back', () => {
  const path: PathKey[] = [{ time: 0.5, move: [0.1, 0.25, -2] }];
  const free = { vertex: 3, radius: 0.1, stay: 1 };
  const doc = setMotion(docOfKeys(), { pins: [{ vertex: 2, radius: 0.1, path }, free] });
  const turned = reorientedDoc(doc, { up: 'y', unit: 1 }, { up: 'z', unit: 0.5 });
  expect(turned.motion.pins).toEqual([
    { ...doc.motion.pins[0], path: [{ time: 0.5, move: [0.05, -1, -0.125] }] },
    free,
  ]);
  expect(reorientedDoc(turned, { up: 'z', unit: 0.5 }, { up: 'y', unit: 1 })).toEqual(doc);
  const plain = setMotion(doc, { pins: [free] });
  expect(reorientedDoc(plain, BEFORE, AFTER)).toBe(plain);
});
