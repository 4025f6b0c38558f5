/** The times of a fitted motion's own shapes. */
import { expect, it } from 'vitest';
import { MOTION_DEFAULTS } from '../../web/engine/api/types.ts';
import { fitTimes } from '../../web/engine/caller/fit-times.ts';

const sampled = (spaceSamples: number) => ({ ...MOTION_DEFAULTS, method: 'lengths' as const, spaceSamples });

it('spaces times evenly between keys, in proportion to their intervals', () => {
  const times = fitTimes([0, 1, 3], sampled(6));
  expect(times.map(({ time }) => time)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3]);
  expect(times.map(({ key }) => key)).toEqual([0, -1, 1, -1, -1, -1, 2]);
});

it('includes every key if there are more keys than samples', () => {
  expect(fitTimes([0, 1, 1.5, 4], sampled(2)).map(({ key }) => key)).toEqual([0, 1, 2, 3]);
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
