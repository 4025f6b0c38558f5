/** The times of a fitted motion's own shapes. */
import { expect, it } from 'vitest';
import { MOTION_DEFAULTS } from '../../web/engine/api/types.ts';
import { fitTimes, sampledIntervals } from '../../web/engine/caller/fit-times.ts';

const sampledOptions = (spaceSamples: number) => ({ ...MOTION_DEFAULTS, method: 'lengths' as const, spaceSamples });

it('spaces times evenly between keys, in proportion to their intervals', () => {
  const times = fitTimes([0, 1, 3], sampledOptions(6));
  expect(times.map(({ time }) => time)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3]);
  expect(times.map(({ key }) => key)).toEqual([0, -1, 1, -1, -1, -1, 2]);
});

it('includes every key if there are more keys than samples', () => {
  expect(fitTimes([0, 1, 1.5, 4], sampledOptions(2)).map(({ key }) => key)).toEqual([0, 1, 2, 3]);
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

it.each([
  [[0, 1, 2, 3], 3, [false, false, false]],
  [[0, 1, 2, 3], 4, [true, false, false]],
  [[0, 1, 2, 3], 6, [true, true, true]],
  [[0, 0.9, 2, 3], 3, [false, false, false]],
  [[0, 0.4, 10, 20], 2, [false, false, false]],
  [[0, 0.02, 1], 24, [true, true]],
])('intervals of %j with %i samples have shapes of their own or need none: %j', (keyTimes, samples, sampled) => {
  expect(sampledIntervals(fitTimes(keyTimes, sampledOptions(samples)))).toEqual(sampled);
});
