/**
 * Natural order of file names, and numbered sequences among them: walk0001.obj, walk0002.obj, sim.-1.obj.
 * `wasm/io/numbered_files` has the same rule for frame times; `tests/numbered-names.json` tests both.
 */
import { extensionOf, fileName, isModel } from './paths.ts';

export interface NumberedSequence {
  names: string[];
}

interface Numbered {
  name: string;
  /** Index among the names. */
  place: number;
  /** Part before the number and its sign. */
  start: string;
  extension: string;
  number: number;
}

const naturally = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

const NUMBER_AT_END = /^(.*?)(\d+)\.[^./\\]*$/s;
const FRACTION_AT_END = /^(.*?)(\d+\.\d+)\.[^./\\]*$/s;
const MOST = 1e9;

const sequenceOf = ({ start, extension }: Pick<Numbered, 'start' | 'extension'>): string => `${start}\0${extension}`;

function numberAt(pattern: RegExp, name: string, place: number): Numbered | null {
  const [, start = '', digits = ''] = pattern.exec(name) ?? [];
  const number = Number(digits);
  return digits === '' || number > MOST ? null : { name, place, start, extension: extensionOf(name), number };
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

/** Fractional frames: between sim.1 and sim.2, sim.1.25 is frame 1.25, not frame 25 of a sequence sim.1. */
function numbered(names: readonly string[]): Numbered[] {
  const files = names.flatMap((name, place) => numberAt(NUMBER_AT_END, name, place) ?? []);
  const unsigned = new Set(files.map(sequenceOf));
  const whole = files.map((file) => withSign(file, unsigned));
  const known = new Set(whole.map(sequenceOf));
  return whole.map((file) => {
    const read = numberAt(FRACTION_AT_END, file.name, file.place);
    const fraction = read && withSign(read, unsigned);
    return fraction && known.has(sequenceOf(fraction)) ? fraction : file;
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
  return grouped(names.filter(isModel))
    .filter((group) => group.length > 1)
    .map((group) => ({ names: group.map(({ name }) => name) }));
}

/** Text for a sequence: run_0001.obj to run_0003.obj. */
export const sequenceText = ({ names }: NumberedSequence): string =>
  `${fileName(names[0]!)} to ${fileName(names.at(-1)!)} (${names.length} files)`;
