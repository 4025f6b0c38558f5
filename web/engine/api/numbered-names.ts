/**
 * The order of files by their names, and the numbered sequences among them: walk0001.obj, walk0002.obj, sim.-1.obj.
 * `wasm/io/numbered_files` has the same rule for the times of frames; both pass `tests/numbered-names.json`.
 */
import { extensionOf, fileName, isModel } from './paths.ts';

export interface NumberedSequence {
  /** What the names have in common, before the number. */
  start: string;
  extension: string;
  names: string[];
}

interface Numbered {
  name: string;
  /** Among the names. */
  place: number;
  /** Before the number and its sign. */
  start: string;
  extension: string;
  number: number;
}

const naturally = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

const NUMBER_AT_END = /^(.*?)(\d+)\.[^./\\]*$/s;
const MOST_DIGITS = 9;

const sequenceOf = (start: string, extension: string): string => `${start}\0${extension}`;

/**
 * A hyphen before the number is a sign behind a dot, an underscore or nothing. Behind anything else it only parts the
 * number from the name, unless another file has the same name and a number without a hyphen: walk-1, walk0.
 */
function numbered(names: readonly string[]): Numbered[] {
  const files = names.flatMap((name, place): Numbered[] => {
    const [, start = '', digits = ''] = NUMBER_AT_END.exec(name) ?? [];
    const number = Number(digits);
    if (digits === '' || number > 10 ** MOST_DIGITS) return [];
    return [{ name, place, start, extension: extensionOf(name), number }];
  });
  const known = new Set(files.map(({ start, extension }) => sequenceOf(start, extension)));
  return files.map((file) => {
    if (!file.start.endsWith('-')) return file;
    const start = file.start.slice(0, -1);
    const isSign = /(^|[/\\._])$/.test(start) || (!/\d$/.test(start) && known.has(sequenceOf(start, file.extension)));
    return isSign ? { ...file, start, number: -file.number } : file;
  });
}

function grouped(names: readonly string[]): Numbered[][] {
  const groups = new Map<string, Numbered[]>();
  for (const file of numbered(names)) {
    const key = sequenceOf(file.start, file.extension);
    const group = groups.get(key);
    if (group) group.push(file);
    else groups.set(key, [file]);
  }
  return [...groups.values()];
}

/** Natural order of names; what is numbered below zero comes first in its sequence, -2 before -1. */
export function inNaturalOrder<T extends { name: string }>(files: readonly T[]): T[] {
  const sorted = [...files].sort((a, b) => naturally.compare(a.name, b.name));
  const result = [...sorted];
  for (const group of grouped(sorted.map(({ name }) => name))) {
    if (!group.some(({ number }) => number < 0)) continue;
    const byNumber = [...group].sort((a, b) => a.number - b.number);
    group.forEach(({ place }, index) => (result[place] = sorted[byNumber[index]!.place]!));
  }
  return result;
}

/** Numbered sequences of at least two models each, in natural order. */
export function sequencesIn(names: readonly string[]): NumberedSequence[] {
  return grouped(names.filter(isModel))
    .filter((group) => group.length > 1)
    .map((group) => ({
      start: fileName(group[0]!.start),
      extension: group[0]!.extension,
      names: group.map(({ name }) => name),
    }));
}

/** A sequence in a sentence: run_0001.obj to run_0003.obj. */
export const sequenceText = ({ names }: NumberedSequence): string =>
  `${fileName(names[0]!)} to ${fileName(names.at(-1)!)} (${names.length} files)`;
