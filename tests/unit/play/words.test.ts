import { expect, it } from 'vitest';
import { number } from '../../../web/play/figures/words.ts';

it('numbers have three digits, however large they are', () => {
  expect([0, 1e-5, -0.12345, 396.04, 123_456, -987_654].map(number)).toEqual([
    '0',
    '0',
    '−0.123',
    '396',
    '123000',
    '−988000',
  ]);
  expect([1e6, 150_000_000, -2.345e12].map(number)).toEqual(['1e6', '1.5e8', '−2.35e12']);
  expect([NaN, Infinity].map(number)).toEqual(['–', '∞']);
});
