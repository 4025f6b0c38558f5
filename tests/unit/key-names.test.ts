import { expect, it } from 'vitest';
import { keyLabel, shortNames } from '../../web/model/key-names.ts';

it('omits the common beginning of all names, up to a word', () => {
  expect(shortNames(['cat_run_01', 'cat_run_02', 'cat_run_13'])).toEqual(['01', '02', '13']);
  expect(shortNames(['wolf-1', 'wolf-4', 'wolf-12'])).toEqual(['1', '4', '12']);
  expect(shortNames(['cat_000001', 'cat_000013'])).toEqual(['000001', '000013']);
  expect(shortNames(['victoria0', 'victoria12', 'victoria15'])).toEqual(['0', '12', '15']);
  expect(shortNames(['wild horse.a', 'wild horse.b', 'wild horse.c'])).toEqual(['a', 'b', 'c']);
});

it('keeps names that begin with different words, or that would become empty', () => {
  for (const names of [
    ['bentwards', 'bent-inwards', 'below the knee'],
    ['a rather long_', 'a rather long_1', 'a rather long_2'],
    ['only'],
    [],
  ])
    expect(shortNames(names)).toEqual(names);
});

it('calls a key by its number, and by its name if it has one', () => {
  expect(keyLabel(0, 'Straight')).toBe('Key 1, Straight');
  expect(keyLabel(1, '')).toBe('Key 2');
  expect([keyLabel(1, '2'), keyLabel(1, '1')]).toEqual(['Key 2', 'Key 2, 1']);
});
