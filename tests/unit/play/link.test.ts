/** The playground's state in an address, and its edits. */
import { describe, expect, it } from 'vitest';
import { readLink, writeLink } from '../../../web/play/link.ts';
import {
  INITIAL,
  MAX_KEYS,
  addKey,
  moveKey,
  removeKey,
  setEnds,
  setShaping,
  showLayer,
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

describe('a link', () => {
  it('says nothing of the page as it opens, and everything of another state', () => {
    expect(writeLink(INITIAL)).toBe('');
    expect(readLink('')).toBeNull();
    expect(readLink(`#${writeLink(changed)}`)).toEqual(changed);
  });

  it('keeps a state without any curve', () => {
    const none: PlayState = { ...INITIAL, layers: [] };
    expect(readLink(`#${writeLink(none)}`)?.layers).toEqual([]);
  });

  it.each([
    'keys=0,1',
    'keys=0,1 0,2',
    'keys=1,1 0,2',
    'keys=0,1 1,x',
    'keys=0,1,0,5 1,2',
    `keys=${Array.from({ length: MAX_KEYS + 1 }, (_, i) => `${i},0`).join(' ')}`,
    'samples=4',
    'samples=61',
    'ends=none',
    'speeds=1',
    'speeds=1 9999',
    'key=0',
    'key=6',
    't=never',
    'spacing=wide',
    'show=nothing <script>',
  ])('leaves out what cannot be meant: %s', (text) => {
    const read = readLink(`#${text}`);
    expect(read).toEqual({ ...INITIAL, layers: text.startsWith('show') ? [] : INITIAL.layers });
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

  it('adds a key after the selected one, on the curve; and keeps two', () => {
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

  it('shows the curve that it is about', () => {
    expect(setEnds(INITIAL, 'periodic')).toMatchObject({ ends: 'periodic', layers: ['natural', 'periodic'] });
    expect(setShaping(INITIAL, { bias: 0.5 }).layers).toEqual(['natural', 'shaped']);
    expect(setShaping(INITIAL, { bias: 0.5 }).keys[2]).toMatchObject({ bias: 0.5, tension: 0 });
    expect(showLayer(INITIAL, 'natural', false).layers).toEqual([]);
  });
});
