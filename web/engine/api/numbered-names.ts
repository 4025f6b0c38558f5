/**
 * Natural order of file names, and numbered sequences among them: walk0001.obj, walk0002.obj, sim.-1.obj.
 * `wasm/io/numbered_files` has the same rule for frame times; `tests/numbered-names.json` tests both.
 */
import { extensionOf, fileName, isModel } from './paths.ts';

export interface NumberedSequence {
  names: string[];
}

/** A number in a name. */
interface Numbered {
  /** Index among the names. */
  place: number;
  /** Part before the number and its sign. */
  start: string;
  /** Part after the number, with the extension in lower case. */
  end: string;
  number: number;
}

const naturally = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

const MAX_NUMBER = 1e9;
/** Most numbers of a name that are compared, from the end. */
const MAX_NUMBERS = 8;

const sequenceOf = ({ start, end }: Pick<Numbered, 'start' | 'end'>): string => `${start}\0${end}`;

/** Reads the numbers of a name from the end: numbers that could be the frame, and fractional frames. */
function numbersIn(name: string, place: number): { whole: Numbered[]; fractions: Numbered[] } {
  const folder = name.length - fileName(name).length;
  const dot = name.lastIndexOf('.');
  const stem = dot >= folder ? name.slice(0, dot) : name;
  const digits = [...stem.slice(folder).matchAll(/\d+/g)]
    .map(({ 0: text, index }) => ({ from: folder + index, to: folder + index + text.length }))
    .reverse()
    .slice(0, MAX_NUMBERS);
  const numberAt = (from: number, to: number): Numbered[] => {
    const number = Number(stem.slice(from, to));
    const end = `${stem.slice(to)}.${extensionOf(name)}`;
    return number > MAX_NUMBER ? [] : [{ place, start: name.slice(0, from), end, number }];
  };
  return {
    whole: digits.flatMap(({ from, to }) => numberAt(from, to)),
    fractions: digits.flatMap(({ from, to }, index) => {
      const before = digits[index + 1];
      return before?.to === from - 1 && name[from - 1] === '.' ? numberAt(before.from, to) : [];
    }),
  };
}

/**
 * A hyphen or plus before the number is its sign after a dot, after an underscore, or at the start. Elsewhere it is a
 * separator, unless another file has the same name and an unsigned number: walk-1, walk0.
 */
function withSign(file: Numbered, unsigned: ReadonlySet<string>): Numbered {
  const sign = file.start.at(-1);
  if (sign !== '-' && sign !== '+') return file;
  const start = file.start.slice(0, -1);
  const isSign = /(^|[/\\._])$/.test(start) || (!/\d$/.test(start) && unsigned.has(sequenceOf({ ...file, start })));
  return isSign ? { ...file, start, number: sign === '-' ? -file.number : file.number } : file;
}

/**
 * The frame of each name: the number in which most names differ, or the last one. Fractional frames: between sim.1 and
 * sim.2, sim.1.25 is frame 1.25, not frame 25 of a sequence sim.1.
 */
function numbered(names: readonly string[]): Numbered[] {
  const read = names.map(numbersIn);
  const unsigned = new Set(read.flatMap(({ whole }) => whole.map(sequenceOf)));
  const signed = read.map(({ whole, fractions }) => ({
    whole: whole.map((one) => withSign(one, unsigned)),
    fractions: fractions.map((one) => withSign(one, unsigned)),
  }));
  const counts = new Map<string, number>();
  const countOf = (one: Numbered): number => counts.get(sequenceOf(one)) ?? 0;
  for (const one of signed.flatMap(({ whole }) => whole)) counts.set(sequenceOf(one), countOf(one) + 1);
  return signed.flatMap(({ whole, fractions }) => {
    const fraction = fractions.find((one) => countOf(one) > 0);
    const most = Math.max(...whole.map(countOf));
    return fraction ?? whole.find((one) => countOf(one) === most) ?? [];
  });
}

function grouped(names: readonly string[]): Numbered[][] {
  const groups = new Map<string, Numbered[]>();
  for (const file of numbered(names)) {
    const key = sequenceOf(file);
    const group = groups.get(key);
    if (group) group.push(file);
    else groups.set(key, [file]);
  }
  return [...groups.values()];
}

/** Natural order of names. Within a sequence, the order of the numbers: -2, -1, 0, +1, 1.5. */
export function inNaturalOrder<T extends { name: string }>(files: readonly T[]): T[] {
  const sorted = [...files].sort((a, b) => naturally.compare(a.name, b.name));
  const result = [...sorted];
  for (const group of grouped(sorted.map(({ name }) => name))) {
    const byNumber = [...group].sort((a, b) => a.number - b.number);
    group.forEach(({ place }, index) => (result[place] = sorted[byNumber[index]!.place]!));
  }
  return result;
}

/** Numbered sequences of at least two models each, in natural order. */
export function sequencesIn(names: readonly string[]): NumberedSequence[] {
  const models = names.filter(isModel);
  return grouped(models)
    .filter((group) => group.length > 1)
    .map((group) => ({ names: group.map(({ place }) => models[place]!) }));
}

/** Text for a sequence: run_0001.obj to run_0003.obj. */
export const sequenceText = ({ names }: NumberedSequence): string =>
  `${fileName(names[0]!)} to ${fileName(names.at(-1)!)} (${names.length} files)`;
