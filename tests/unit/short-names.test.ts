import { expect, it } from 'vitest';
import { shortNames } from '../../web/model/short-names.ts';

it('leaves out what all names begin with, up to a word', () => {
  expect(shortNames(['cat_run_01', 'cat_run_02', 'cat_run_13'])).toEqual(['01', '02', '13']);
  expect(shortNames(['wild horse.a', 'wild horse.b', 'wild horse.c'])).toEqual(['a', 'b', 'c']);
});

it('leaves names alone that a card has room for, that begin with different words, that would end up empty, or that are two', () => {
  for (const names of [
    ['cat_1', 'cat_2', 'cat_3'],
    ['bentwards', 'bent-inwards', 'below the knee'],
    ['a rather long_', 'a rather long_1', 'a rather long_2'],
    ['pose 1', 'pose 2'],
    ['only'],
    [],
  ])
    expect(shortNames(names)).toEqual(names);
});
