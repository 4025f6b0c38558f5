/** Writes files completely or not at all: first next to their destination, then moved there. */
import { rmSync, type Stats } from 'node:fs';
import { lstat, mkdir, readlink, rename, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';

interface OutputFile {
  name: string;
  bytes: Uint8Array | string;
}

export interface Output {
  /**
   * Ends in '/' for a folder with several files. Otherwise the first file has this path, and the others are next to it.
   */
  path: string;
  /** Each file is requested after the previous one is written, so only one is in memory. */
  files: Iterable<OutputFile> | AsyncIterable<OutputFile>;
}

/** A written file: its temporary path and its destination. */
interface Move {
  from: string;
  to: string;
}

/**
 * Writes all outputs or, on any failure, none. Destinations that are not regular files (a device, a pipe) are written
 * directly, last.
 */
export async function writeOutputs(outputs: Output[]): Promise<void> {
  const partial: string[] = [];
  const made: string[] = [];
  const remove = (places: string[]): void => {
    for (const place of places) rmSync(place, { recursive: true, force: true });
  };
  const leave = (signal: NodeJS.Signals): void => {
    remove([...partial, ...made]);
    // Does not exit normally, because that would wait for a pipe without a reader.
    process.kill(process.pid, signal);
  };
  const signals = ['SIGINT', 'SIGTERM', 'SIGHUP', 'SIGQUIT'] as const;
  for (const signal of signals) process.once(signal, leave);
  try {
    await move(outputs, partial, made);
  } catch (error) {
    remove(made);
    if (error instanceof EngineError) throw error;
    throw new EngineError('not-written', `Cannot write the result (${messageOf(error)}).`);
  } finally {
    for (const signal of signals) process.off(signal, leave);
    remove(partial);
  }
}

/** `partial` and `made` collect temporary paths and new folders for cleanup. */
async function move(outputs: Output[], partial: string[], made: string[]): Promise<void> {
  const whole: Move[] = [];
  const streams: { to: string; bytes: OutputFile['bytes'] }[] = [];
  for (const output of outputs) {
    const { target, stream } = await place(output.path);
    const isFolder = output.path.endsWith('/');
    const beside = stream ? null : await partialPlace(target, output, partial);
    let isFirst = true;
    for await (const { name, bytes } of output.files) {
      const isMain = isFirst && !isFolder;
      isFirst = false;
      if (beside === null) {
        if (isMain || isFolder) streams.push({ to: target, bytes });
        continue;
      }
      const to = isMain ? target : path.join(isFolder ? target : path.dirname(target), name);
      const from = isFolder ? path.join(beside, name) : `${beside}${isMain ? '' : `.${whole.length}`}`;
      if (!isFolder && !isMain) partial.push(from);
      await writeFile(from, bytes);
      whole.push({ from, to });
    }
  }
  await checkPlaces(whole);
  for (const { to } of whole) {
    const first = await mkdir(path.dirname(to), { recursive: true });
    if (first !== undefined) made.push(first);
  }
  for (const { to, bytes } of streams) await writeFile(to, bytes);
  for (const { from, to } of whole) await rename(from, to);
}

/** The destination with links resolved, and whether to write it directly. */
async function place(given: string): Promise<{ target: string; stream: boolean }> {
  const target = await followed(path.resolve(given));
  const there = await statsOf(target);
  if (there?.isBlockDevice() || there?.isSocket()) throw new Error(`${given} is a device or a socket, not a file`);
  return { target, stream: Boolean(there?.isCharacterDevice() || there?.isFIFO()) };
}

/** Resolves links, even if the target does not exist yet. */
async function followed(file: string, links = 0): Promise<string> {
  const there = await lstat(file).catch(() => null);
  if (!there?.isSymbolicLink()) return file;
  if (links === 40) throw new Error(`${file} is a link to itself`);
  // The target of /dev/stdout may have no name.
  const through = await stat(file).catch(() => null);
  if (through && !through.isFile() && !through.isDirectory()) return file;
  return followed(path.resolve(path.dirname(file), await readlink(file)), links + 1);
}

/** Temporary location of an output: a file, or an existing folder. */
async function partialPlace(target: string, { path: given }: Output, partial: string[]): Promise<string> {
  const mark = `.partial-${process.pid}-${partial.length}`;
  const temporary = path.join(await existing(path.dirname(target)), `${path.basename(target)}${mark}`);
  partial.push(temporary);
  if (given.endsWith('/')) await mkdir(temporary);
  return temporary;
}

/** Checks all moves before the first one. */
async function checkPlaces(moves: Move[]): Promise<void> {
  const taken = new Set<string>();
  for (const { to } of moves) {
    if (taken.has(to)) throw new Error(`two results would be written to ${to}`);
    taken.add(to);
    const there = await statsOf(to);
    if (there?.isDirectory()) throw new Error(`${to} is a folder`);
    if (there && !there.isFile()) throw new Error(`${to} is not a regular file`);
  }
}

const statsOf = (file: string): Promise<Stats | null> => stat(file).catch(() => null);

/** The nearest existing ancestor folder. */
async function existing(folder: string): Promise<string> {
  const found = await statsOf(folder);
  const above = path.dirname(folder);
  return found?.isDirectory() || above === folder ? folder : existing(above);
}
