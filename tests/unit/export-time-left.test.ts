/** The remaining time of an export, in words. */
import { expect, it } from 'vitest';
import { timeLeft } from '../../web/app/export/time-left.ts';

it('estimates the time left from the mean speed, once it is known', () => {
  expect(timeLeft(2000, 0.01), 'too early').toBe('');
  expect(timeLeft(30_000, 0.8), 'soon over').toBe('');
  expect(timeLeft(30_000, 0.5)).toBe(', about 30\u00a0s left');
  expect(timeLeft(4000, 0.1)).toBe(', about 40\u00a0s left');
  expect(timeLeft(60_000, 0.25)).toBe(', about 3\u00a0min left');
});
