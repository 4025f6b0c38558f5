/** Pins of the document: their paths, their text in links, and kept positions. */
import { describe, expect, it } from 'vitest';
import type { PathKey, Pin } from '../../web/engine/api/types.ts';
import { MOTION } from '../../web/engine/api/option-table.ts';
import { validationError } from '../../web/engine/api/options.ts';
import {
  changedPin,
  moveAt,
  pinSize,
  pinsFromText,
  pinsText,
  withPathKey,
  withPin,
  withoutPin,
} from '../../web/model/pins.ts';
import { sequencePlan } from '../../web/app/session/sequence-plan.ts';
import { pin } from '../../web/cli/values.ts';
import { docOfKeys, keyRef } from './documents.ts';

const PATH: PathKey[] = [
  { time: 0.5, move: [0, 1, 0] },
  { time: 1.25, move: [2, -1, 0.5] },
  { time: 2, move: [1, 0, 1] },
  { time: 3.5, move: [0, 0, -1] },
];
const shortest = (value: number): string => String(Number(value.toPrecision(6)));

describe('the path of a pin', () => {
  it('goes through its keys, and is constant beyond them', () => {
    for (const { time, move } of PATH)
      moveAt(PATH, time, null).forEach((x, axis) => expect(x).toBeCloseTo(move[axis]!, 12));
    expect(moveAt(PATH, -4, null)).toEqual([0, 1, 0]);
    expect(moveAt(PATH, 9, null)).toEqual([0, 0, -1]);
    expect(moveAt([], 1, null)).toEqual([0, 0, 0]);
    expect(moveAt([PATH[1]!], 9, null)).toEqual([2, -1, 0.5]);
  });

  it.each([
    ['open', null],
    ['of a loop', 4],
  ])('has no corner in its velocity or its acceleration: %s', (_what, period) => {
    const at = (t: number): number => moveAt(PATH, t, period)[1];
    const e = 1e-3;
    for (const { time: t } of PATH) {
      const velocity = (s: number): number => (at(t + s * e) - at(t)) / (s * e);
      const acceleration = (s: number): number => (at(t) - 2 * at(t + s * e) + at(t + 2 * s * e)) / (e * e);
      expect(Math.abs(velocity(1) - velocity(-1))).toBeLessThan(0.05);
      expect(Math.abs(acceleration(1) - acceleration(-1))).toBeLessThan(0.5);
    }
  });

  it('is periodic in a loop', () => {
    const [now, later] = [moveAt(PATH, 2.7, 4), moveAt(PATH, 10.7, 4)];
    now.forEach((x, axis) => expect(x).toBeCloseTo(later[axis]!, 9));
    expect(moveAt(PATH, 0.2, 4)).not.toEqual([0, 1, 0]);
  });

  it('has one key per time, in order', () => {
    const more = withPathKey(PATH, { time: 1, move: [9, 9, 9] }, 1e-6);
    expect(more.map(({ time }) => time)).toEqual([0.5, 1, 1.25, 2, 3.5]);
    expect(withPathKey(more, { time: 1 + 1e-9, move: [8, 8, 8] }, 1e-6)).toHaveLength(5);
  });
});

describe('a list of pins', () => {
  const pins: Pin[] = withPin(withPin([], 7), 3);

  it('adds, changes and removes one', () => {
    expect(pins.map(({ vertex }) => vertex)).toEqual([7, 3]);
    const stays = changedPin(pins, 1, { stay: 2 });
    expect(stays[1]).toEqual({ ...pins[1], stay: 2 });
    expect(changedPin(stays, 1, { stay: undefined })).toEqual(pins);
    expect(withoutPin(pins, 0)).toEqual([pins[1]]);
    expect(pinSize({ vertex: 0, radius: 0 })).toBe(0);
    expect(pinSize({ vertex: 0, radius: 0.02 })).toBeGreaterThan(0);
  });

  it('is the same after a link', () => {
    const all = [
      ...changedPin(pins, 0, { stay: 1, path: PATH }),
      { vertex: 1, radius: 0 },
      { vertex: 2, radius: 0.1, path: PATH },
    ];
    expect(pinsFromText(pinsText(all, shortest))).toEqual(all);
    for (const text of ['', '3', 'x:0.1', '3:2', '3:0.1:-1', '3:0.1::1/2/3', '3:0.1::2/0/0/0,1/0/0/0', '3:0.1:0.5'])
      expect(pinsFromText(text), text).toBeUndefined();
  });

  it('is checked before a request to the core', () => {
    const wrong = (one: object): string | null => validationError(MOTION.pins, [one]);
    expect(wrong({ vertex: 3, radius: 0.1, stay: 0, path: PATH })).toBeNull();
    expect(wrong({ vertex: -1, radius: 0.1 })).toContain('vertex');
    expect(wrong({ vertex: 3, radius: 2 })).toContain('radius');
    expect(wrong({ vertex: 3, radius: 0.1, stay: 0.5 })).toContain('stay');
    expect(wrong({ vertex: 3, radius: 0.1, path: [...PATH].reverse() })).toContain('increasing');
    expect(wrong({ vertex: 3, radius: 0.1, firm: true })).toContain("'firm'");
    expect(validationError(MOTION.pins, 'all')).toContain('array');
    expect(validationError(MOTION.pins, new Array(101).fill({ vertex: 0, radius: 0 }))).toContain('100');
  });

  it('is converted from poses in the document to keys in the engine', () => {
    const before = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
    const [first, second] = before.keys;
    const moved = {
      ...before,
      keys: [second!, first!],
      motion: { ...before.motion, pins: changedPin(pins, 0, { stay: first!.pose }) },
    };
    expect(sequencePlan(moved).motion.pins.map(({ stay }) => stay)).toEqual([1, undefined]);
    expect(sequencePlan({ ...moved, keys: [second!] }).motion.pins).toEqual(pins);
  });
});

describe('a pin on the command line', () => {
  it.each([
    ['12', { vertex: 12, radius: 0.06 }],
    ['12:patch', { vertex: 12, radius: 0 }],
    ['12:0.1:stay=2', { vertex: 12, radius: 0.1, stay: 1 }],
    [
      '0:stay=1:path=0/0/0/0,1.5/0/-0.2/0',
      {
        vertex: 0,
        radius: 0.06,
        stay: 0,
        path: [
          { time: 0, move: [0, 0, 0] },
          { time: 1.5, move: [0, -0.2, 0] },
        ],
      },
    ],
  ])('%s', (text, expected) => expect(pin(text, '--pin')).toEqual(expected));

  it.each(['', 'foot', '-1', '3:0', '3:far', '3:0.1:0.2', '3:stay=0', '3:path=1/2/3', '3:path=1/2/3/4/5', '3:path='])(
    'refuses %s',
    (text) => expect(() => pin(text, '--pin')).toThrow('--pin'),
  );
});
