import { expect, it } from 'vitest';
import { number } from '../../../web/play/figures/words.ts';

it('numbers of any size have three significant digits', () => {
  expect([0, 1e-5, -0.12345, 396.04, 123_456, -987_654].map(number)).toEqual([
    '0',
    '0',
    '−0.123',
    '396',
    '123000',
    '−988000',
  ]);
  expect([1e6, 150_000_000, -2.345e12].map(number)).toEqual(['10⁶', '1.5·10⁸', '−2.35·10¹²']);
  expect([NaN, Infinity].map(number)).toEqual(['–', '∞']);
});
