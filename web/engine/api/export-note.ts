/**
 * Comments in our OBJ and PLY files: up axis, unit, and frame times of the file or of its point cache. Neither format
 * has fields for these.
 */

import { MAX_EXPORTED_FRAMES } from './option-table.ts';
import { extensionOf } from './paths.ts';
import type { InputFile } from './types.ts';

const MARK = 'shapespline: Y up, metres';
/** Times on a line. Some programs refuse lines of more than 64 kB. */
const PER_LINE = 500;
/** Longest note. */
const HEAD = 26 * MAX_EXPORTED_FRAMES;
/** A note starts a file; in a PLY it follows the magic word and the format. */
const BEFORE_MARK = 200;
/** Tolerance of even spacing, relative to the covered time. */
const EVEN = 1e-9;

export interface ExportNote {
  /** Frame times on the timeline of the keys; null if not specified. */
  times: number[] | null;
}

const evenly = (count: number, first: number, last: number): number[] =>
  Array.from({ length: count }, (_, i) => (i === count - 1 ? last : first + ((last - first) * i) / (count - 1)));

function timesText(times: readonly number[]): string[] {
  const [first, last] = [times[0]!, times.at(-1)!];
  const even = evenly(times.length, first, last);
  if (times.length > 2 && times.every((t, i) => Math.abs(t - even[i]!) <= EVEN * Math.abs(last - first)))
    return [`frames ${times.length} from ${first} to ${last}`];
  const lines: string[] = [];
  for (let i = 0; i < times.length; i += PER_LINE) lines.push(`times ${times.slice(i, i + PER_LINE).join(' ')}`);
  return lines;
}

/** An OBJ or PLY with a note; other files unchanged. `times`: the file's frame times, or empty. */
export function withNote(format: string, bytes: Uint8Array, times: readonly number[]): Uint8Array {
  if (format !== 'obj' && format !== 'ply') return bytes;
  const start = format === 'obj' ? '# ' : 'comment ';
  const note = new TextEncoder().encode([MARK, ...timesText(times)].map((line) => `${start}${line}\n`).join(''));
  const at = format === 'obj' ? 0 : endOfLine(bytes, endOfLine(bytes, 0)); // after a PLY's mark and format
  const result = new Uint8Array(bytes.length + note.length);
  result.set(bytes.subarray(0, at));
  result.set(note, at);
  result.set(bytes.subarray(at), at + note.length);
  return result;
}

const endOfLine = (bytes: Uint8Array, from: number): number => bytes.indexOf(10, from) + 1;

/**
 * The common note of our files: that of the first file, and for a series the frame times. null if any file is not ours.
 */
export function noteOf(files: readonly InputFile[]): ExportNote | null {
  const notes: ExportNote[] = [];
  for (const { name, bytes } of files) {
    if (!['obj', 'ply'].includes(extensionOf(name))) continue;
    const note = readNote(bytes);
    if (!note) return null;
    notes.push(note);
  }
  if (notes.length < 2) return notes[0] ?? null;
  const times = notes.flatMap((note) => note.times ?? []);
  return { times: times.length === notes.length ? times : null };
}

/** Reads the note of a file; null if it has none. */
export function readNote(bytes: Uint8Array): ExportNote | null {
  if (!new TextDecoder().decode(bytes.subarray(0, BEFORE_MARK)).includes(MARK)) return null;
  const head = new TextDecoder().decode(bytes.subarray(0, HEAD));
  const [start] = head.split(/\r?\n(?!#|comment |format )/, 1);
  const lines = start!.split(/\r?\n/).map((line) => line.replace(/^(#|comment) /, ''));
  if (!lines.includes(MARK)) return null;
  const listed = lines.flatMap((line) => (line.startsWith('times ') ? line.slice(6).split(' ').map(Number) : []));
  const [, count, , first, , last] = lines.find((line) => line.startsWith('frames '))?.split(' ') ?? [];
  const even = Number(count) <= MAX_EXPORTED_FRAMES ? evenly(Number(count), Number(first), Number(last)) : [];
  const times = [...listed, ...even];
  return { times: times.length > 0 && times.every(Number.isFinite) ? times : null };
}
