import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { inNaturalOrder, sequencesIn, sequenceText } from '../../../web/engine/api/numbered-names.ts';

interface Case {
  names: string[];
  order: string[];
  sequences?: number;
}

const shared = JSON.parse(readFileSync(new URL('../../numbered-names.json', import.meta.url), 'utf8')) as Case[];

const ordered = (names: readonly string[]): string[] =>
  inNaturalOrder(names.map((name) => ({ name }))).map(({ name }) => name);

describe('names with numbers', () => {
  it.each(shared)('are sorted: $names', ({ names, order, sequences = 1 }) => {
    expect(ordered(names)).toEqual(order);
    expect(ordered([...names].reverse())).toEqual(order);
    expect(sequencesIn(order)).toHaveLength(sequences);
  });

  it('determine the sequences, which contain models only', () => {
    const names = ['two/run_0001.obj', 'two/run_0002.obj', 'two/skin_1.png', 'two/skin_2.png', 'two/._walk_1.obj'];
    const [run, ...others] = sequencesIn([...names, 'two/walk_1.obj', 'two/walk_2.obj', 'two/walk_3.obj']);
    expect(sequenceText(run!)).toBe('run_0001.obj to run_0002.obj (2 files)');
    expect(others.map(sequenceText)).toEqual(['walk_1.obj to walk_3.obj (3 files)']);
    expect(sequencesIn(names)).toEqual([run]);
  });

  it('keep every file, also if two have the same name', () => {
    expect(ordered(['a.-1.obj', 'a.-2.obj', 'a.-1.obj'])).toEqual(['a.-2.obj', 'a.-1.obj', 'a.-1.obj']);
  });
});
