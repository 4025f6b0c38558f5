/** How long an export still takes, in words. */
import { expect, it } from 'vitest';
import { leftText } from '../../web/app/export/export-job.ts';

it('tells the time left from the mean pace, once it can be told', () => {
  expect(leftText(2000, 0.01), 'too early').toBe('');
  expect(leftText(30_000, 0.8), 'soon over').toBe('');
  expect(leftText(30_000, 0.5)).toBe(', about 30\u00a0s left');
  expect(leftText(4000, 0.1)).toBe(', about 40\u00a0s left');
  expect(leftText(60_000, 0.25)).toBe(', about 3\u00a0min left');
});
