/** The playground's state in a URL, and its edits. */
import { describe, expect, it } from 'vitest';
import { derive } from '../../../web/play/derived.ts';
import { number } from '../../../web/play/figures/words.ts';
import { readLink, writeLink } from '../../../web/play/link.ts';
import { bendingNotice, curveNotice } from '../../../web/play/notices.ts';
import { valueAt } from '../../../web/play/splines/curve.ts';
import { MAX_SOLVED_SAMPLES } from '../../../web/play/splines/minimise-bending.ts';
import {
  INITIAL,
  MAX_KEYS,
  addKey,
  moveKey,
  removeKey,
  setEnds,
  setShaping,
  showLayer,
  shownTimes,
  keysValidationError,
} from '../../../web/play/state.ts';
import type { PlayState } from '../../../web/play/state.ts';

const changed: PlayState = {
  ...INITIAL,
  keys: [
    { time: -1, value: 30.5, across: 2, tension: 0, bias: 0 },
    { time: 0.5, value: -12, across: 0, tension: 0.5, bias: -0.25 },
    { time: 2, value: 0, across: 1, tension: 0, bias: 0 },
  ],
  layers: ['linear', 'samples', 'shaped'],
  ends: 'hermite',
  speeds: [0, 9.5],
  samples: 42,
  selected: 1,
  time: -0.75,
  plane: true,
  spacing: 'root',
  taken: null,
};

const at = (time: number) => ({ time, value: 0, across: 0, tension: 0, bias: 0 });

describe('a link', () => {
  it('is empty for the initial state, and complete for any other', () => {
    expect(writeLink(INITIAL)).toBe('');
    expect(readLink('')).toBeNull();
    expect(readLink(`#${writeLink(changed)}`)).toEqual({ state: changed, ignoredValues: null });
  });

  it('keeps a state without any curve', () => {
    const none: PlayState = { ...INITIAL, layers: [] };
    expect(readLink(`#${writeLink(none)}`)?.state.layers).toEqual([]);
  });

  it('distinguishes close times', () => {
    const close: PlayState = { ...changed, keys: [0, 1, 1.00001, 2].map(at), selected: 0, time: 1 };
    expect(readLink(`#${writeLink(close)}`)).toEqual({ state: close, ignoredValues: null });
  });

  it.each([
    'keys=0,1',
    'keys=0,1 0,2',
    'keys=1,1 0,2',
    'keys=0,1 1,x',
    'keys=0,1,0,5 1,2',
    'keys=0,0 1e-12,1 2,2',
    'keys=0,0 1e-300,1',
    'keys=0,0 1,1e308',
    'keys=0,0 1,Infinity',
    'keys=0,0 1e308,1',
    'keys=999999,0 999999.0001,1',
    'keys=0,0 1,1,0,0,NaN',
    `keys=${Array.from({ length: MAX_KEYS + 1 }, (_, i) => `${i},0`).join(' ')}`,
    `keys=${'0,0 '.repeat(100_000)}`,
    'samples=4',
    'samples=61',
    'samples=1e9',
    'ends=none',
    'speeds=1',
    'speeds=1 9999',
    'speeds=1 NaN',
    'speeds=1 1 1',
    'key=0',
    'key=6',
    't=never',
    't=1e308',
    'plane=yes',
    'spacing=wide',
    'show=nothing <script>',
  ])('leaves out what cannot be meant, and says so: %s', (text) => {
    const { state, ignoredValues } = readLink(`#${text}`)!;
    expect(state).toEqual(INITIAL);
    expect(ignoredValues).toContain(`The link has a value that cannot be used and was ignored: ${text.split('=')[0]}`);
  });

  it('names keys that are too close', () => {
    expect(readLink('#keys=0,0+1e-12,1+2,2&samples=1e5')!.ignoredValues).toBe(
      'The link has values that cannot be used and were ignored: keys (key 2 must be later than key 1), samples.',
    );
  });

  it('starts at a visible time', () => {
    expect(readLink('#keys=100,0 101,1')!.state.time).toBe(99.8);
    expect(readLink('#keys=100,0 101,1&t=1000')!.state.time).toBe(101.2);
  });
});

/** Difficult numbers in links. */
const NUMBERS = [0, 1e-300, 1e-12, 1e-6, 5e-5, 1e-4, 0.02, 1, 1.0001, 2, 1e3, 999_999, 1e6, 1e308, -1e6, NaN, Infinity];

describe('with any link', () => {
  it('the work is bounded and every number is finite', () => {
    const counts: number[] = [];
    for (const first of [0, -1e6, 999_999, 1e308])
      for (const gap of NUMBERS)
        for (const value of [0, 1e-300, 1e6, NaN]) {
          const keys = [`${first},0`, `${first + gap},${value},${value}`, `${first + gap + 1},1`].join(' ');
          for (const spacing of ['hand', 'root']) {
            const { state } = readLink(`#keys=${keys}&plane=1&ends=periodic&spacing=${spacing}`)!;
            const derived = derive(state);
            for (const { values } of derived.samples) counts.push(values.length);
            const { bending, slopes, curves, weights, samples } = derived;
            const unbounded = { ...bending, linear: 0, samples: samples.length > 0 ? bending.samples : 0 };
            const ends = Object.values(curves)
              .flat()
              .flatMap((curve) => [...curve.values, ...(curve.slopes ?? [])]);
            const shown = shownTimes(derived.range).flatMap((t) => weights.map((weight) => valueAt(weight, t)));
            const all = [
              ...Object.values(unbounded),
              ...slopes,
              ...ends,
              ...shown,
              ...samples.flatMap((one) => one.values),
            ];
            expect(
              all.filter((one) => !Number.isFinite(one)),
              `${keys} ${spacing}`,
            ).toEqual([]);
          }
        }
    expect(Math.max(...counts)).toBeLessThanOrEqual(MAX_SOLVED_SAMPLES);
    expect(counts.length).toBeGreaterThan(100);
  });

  it('keys that are too close for brute force are drawn without it, with a message', () => {
    const { state } = readLink('#keys=0,0+1e-4,1+2,2&show=natural samples')!;
    const derived = derive(state);
    expect([state.keys.length, derived.samples, derived.sampleCount]).toEqual([3, [], 20_001]);
    const sentence = /Brute force is not shown\. Two keys are so close in time that it would need 20001 samples/;
    expect(bendingNotice(state, derived)).toMatch(sentence);
    expect(curveNotice(state, derived, 'samples')).toMatch(sentence);
    expect(number(derived.bending.samples)).toBe('–');
  });
});

describe('an edit', () => {
  it('keeps a dragged key between its neighbours, and the first and last at their times', () => {
    const far = moveKey(INITIAL, 1, { time: 9, value: 3 }).keys[1]!;
    expect(far.value).toBe(3);
    expect(far.time).toBeLessThan(0.5);
    expect(far.time).toBeGreaterThan(0.45);
    expect(moveKey(INITIAL, 0, { time: 0.1, value: 0 }).keys[0]!.time).toBe(0);
    const spaced: PlayState = { ...INITIAL, spacing: 'even' };
    expect(moveKey(spaced, 1, { time: 0.4, value: 0 }).keys[1]!.time).toBe(0.25);
  });

  it('never passes a close neighbour, nor leaves the shown range', () => {
    const close: PlayState = { ...INITIAL, keys: [0, 0.5, 0.501, 0.502, 1].map(at) };
    for (const time of [-1, 0.5011, 9]) {
      const moved = moveKey(close, 2, { time, value: 1e308 });
      expect(keysValidationError(moved.keys)).toBeNull();
    }
    let state: PlayState = { ...INITIAL, keys: [0, 2e-6, 1].map(at), selected: 0 };
    for (let i = 0; i < 5; i += 1) state = addKey({ ...state, selected: 0 }, () => ({ value: 0, across: 0 }));
    expect(keysValidationError(state.keys)).toBeNull();
    expect(state.keys).toHaveLength(4);
  });

  it('adds a key after the selected one, on the curve; two keys always remain', () => {
    const added = addKey(INITIAL, (time) => ({ value: 10 * time, across: time }));
    expect(added.keys[3]).toMatchObject({ time: 0.625, value: 6.25, across: 0.625 });
    expect(added.selected).toBe(3);
    let state: PlayState = { ...added, selected: 5 };
    for (let i = 0; i < 9; i += 1) state = removeKey(state, state.keys.length - 1);
    expect(state.keys.map(({ time }) => time)).toEqual([0, 0.25]);
    expect(state.selected).toBe(1);
    for (let i = 0; i < 20; i += 1) state = addKey(state, () => ({ value: 0, across: 0 }));
    expect(state.keys).toHaveLength(MAX_KEYS);
    const times = state.keys.map(({ time }) => time);
    expect([...new Set(times)].sort((a, b) => a - b)).toEqual(times);
  });

  it('shows the curve that it affects', () => {
    expect(setEnds(INITIAL, 'periodic')).toMatchObject({ ends: 'periodic', layers: ['natural', 'periodic'] });
    expect(setShaping(INITIAL, { bias: 0.5 }).layers).toEqual(['natural', 'shaped']);
    expect(setShaping(INITIAL, { bias: 0.5 }).keys[2]).toMatchObject({ bias: 0.5, tension: 0 });
    expect(showLayer(INITIAL, 'natural', false).layers).toEqual([]);
  });
});
