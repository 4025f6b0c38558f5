import { describe, expect, it } from 'vitest';
import { momentOf, warningItems } from '../../web/app/drawing/marking.ts';
import { NO_PLACE, type Warning } from '../../web/engine/api/types.ts';

const warning = (change: Partial<Warning>): Warning => ({
  ...NO_PLACE,
  code: 'ambiguous-component-turn',
  message: 'Large rotations.',
  count: 1,
  ...change,
});
const times = [0, 0.4, 1];

describe('the time of a warning', () => {
  it('is the middle of the interval before its key', () => {
    expect(momentOf(warning({ key: 1 }), times, [0, 1])).toBeCloseTo(0.2, 12);
    expect(momentOf(warning({ key: 2 }), times, [0, 1])).toBeCloseTo(0.7, 12);
  });

  it('of a closed motion is between its last key and its first', () => {
    expect(momentOf(warning({ key: 0 }), times, [0, 1.5])).toBeCloseTo(1.25, 12);
    expect(momentOf(warning({ key: 3 }), times, [0, 1.5])).toBeCloseTo(1.25, 12);
  });

  it('is that of the key if the warning is about a pose', () => {
    expect(momentOf(warning({ code: 'mirrored', key: 1 }), times, [0, 1])).toBe(0.4);
  });

  it('is null without a key, or for a removed key', () => {
    expect(momentOf(warning({}), times, [0, 1])).toBeNull();
    expect(momentOf(warning({ code: 'mirrored', key: 5 }), times, [0, 1])).toBeNull();
  });
});

it('a warning with a location or a key can be shown', () => {
  const warnings = [warning({}), warning({ patches: [3] }), warning({ face: 0 }), warning({ key: 2 })];
  expect(warningItems(warnings).map(({ shows }) => shows)).toEqual([false, true, true, true]);
});
