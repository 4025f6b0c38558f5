/** The times of a fitted motion's own shapes. */
import { expect, it } from 'vitest';
import { MOTION_DEFAULTS } from '../../web/engine/api/types.ts';
import { fitTimes } from '../../web/engine/caller/fit-times.ts';
import { fitCount } from '../../web/engine/api/methods.ts';

const sampledOptions = (spaceSamples: number) => ({ ...MOTION_DEFAULTS, method: 'lengths' as const, spaceSamples });

it('spaces times evenly between keys, in proportion to their intervals', () => {
  const times = fitTimes([0, 1, 3], sampledOptions(6));
  expect(times.map(({ time }) => time)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3]);
  expect(times.map(({ key }) => key)).toEqual([0, -1, 1, -1, -1, -1, 2]);
});

it('has a time between any two keys, however many keys there are and however uneven their times', () => {
  expect(fitTimes([0, 1, 1.5, 4], sampledOptions(2)).map(({ key }) => key)).toEqual([0, -1, 1, -1, 2, -1, 3]);
  expect(fitTimes([0, 0.02, 1], sampledOptions(6)).map(({ time }) => time)).toEqual([
    0, 0.01, 0.02, 0.265, 0.51, 0.755, 1,
  ]);
  const keys = Array.from({ length: 40 }, (_, i) => i);
  expect(fitTimes(keys, sampledOptions(24)).map(({ time }) => time)).toEqual(
    Array.from({ length: 79 }, (_, i) => i / 2),
  );
});

it('has equally many times in each interval if lengths are kept', () => {
  const times = fitTimes([0, 1, 3], { ...MOTION_DEFAULTS, keepLengths: 1 });
  expect(times).toEqual([
    { time: 0, key: 0 },
    { time: 0.5, key: -1 },
    { time: 1, key: 1 },
    { time: 2, key: -1 },
    { time: 3, key: 2 },
  ]);
});

it.each([sampledOptions(24), sampledOptions(2), { ...MOTION_DEFAULTS, keepLengths: 3 }])(
  'counts the times between the keys without listing them',
  (options) => {
    for (const keys of [2, 3, 25]) {
      const times = fitTimes(
        Array.from({ length: keys }, (_, i) => i),
        options,
      );
      expect(fitCount(keys, options)).toBe(times.length - keys);
    }
  },
);
