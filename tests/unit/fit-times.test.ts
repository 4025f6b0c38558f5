/** The times of a fitted motion's own shapes. */
import { expect, it } from 'vitest';
import { fitTimes } from '../../web/engine/caller/fit-times.ts';

it('spaces times evenly between keys, in proportion to their intervals', () => {
  const times = fitTimes([0, 1, 3], 6);
  expect(times.map(({ time }) => time)).toEqual([0, 0.5, 1, 1.5, 2, 2.5, 3]);
  expect(times.map(({ key }) => key)).toEqual([0, -1, 1, -1, -1, -1, 2]);
});

it('keeps every key where there are more than samples', () => {
  expect(fitTimes([0, 1, 1.5, 4], 2).map(({ key }) => key)).toEqual([0, 1, 2, 3]);
});
