/** Files appear whole or not at all: they are written beside their place and moved there last. */
import { rmSync, type Stats } from 'node:fs';
import { lstat, mkdir, readlink, rename, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';

interface OutputFile {
  name: string;
  bytes: Uint8Array | string;
}

export interface Output {
  /** Ends in '/' for a folder of several files; else the first file is written there, the others beside it. */
  path: string;
  /** One is asked for when the one before it is written, so that no more than one is held. */
  files: Iterable<OutputFile> | AsyncIterable<OutputFile>;
}

/** One written file: where it is, and where it belongs. */
interface Move {
  from: string;
  to: string;
}

/**
 * Writes all outputs or, when anything fails, none. What is no regular file (a device, a pipe) is written into, last.
 */
export async function writeOutputs(outputs: Output[]): Promise<void> {
  const partial: string[] = [];
  const made: string[] = [];
  const remove = (places: string[]): void => {
    for (const place of places) rmSync(place, { recursive: true, force: true });
  };
  const leave = (signal: NodeJS.Signals): void => {
    remove([...partial, ...made]);
    // No exit of our own: it would wait for a pipe that nobody reads.
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

/** `partial` and `made` take what is there on the way: temporary places, and folders that were not there. */
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

/** Where a path leads through links; whether that is written into as it is. */
async function place(given: string): Promise<{ target: string; stream: boolean }> {
  const target = await followed(path.resolve(given));
  const there = await statsOf(target);
  if (there?.isBlockDevice() || there?.isSocket()) throw new Error(`${given} is a device or a socket, not a file`);
  return { target, stream: Boolean(there?.isCharacterDevice() || there?.isFIFO()) };
}

/** The place that links lead to, also where nothing is there yet. */
async function followed(file: string, links = 0): Promise<string> {
  const there = await lstat(file).catch(() => null);
  if (!there?.isSymbolicLink()) return file;
  if (links === 40) throw new Error(`${file} is a link that leads to itself`);
  // What /dev/stdout leads to has no name of its own.
  const through = await stat(file).catch(() => null);
  if (through && !through.isFile() && !through.isDirectory()) return file;
  return followed(path.resolve(path.dirname(file), await readlink(file)), links + 1);
}

/** Where an output is written first: a file, or a folder that is there now. */
async function partialPlace(target: string, { path: given }: Output, partial: string[]): Promise<string> {
  const mark = `.partial-${process.pid}-${partial.length}`;
  const temporary = path.join(await existing(path.dirname(target)), `${path.basename(target)}${mark}`);
  partial.push(temporary);
  if (given.endsWith('/')) await mkdir(temporary);
  return temporary;
}

/** What would fail when the files are moved fails before any is. */
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

/** The nearest folder that is there already. */
async function existing(folder: string): Promise<string> {
  const found = await statsOf(folder);
  const above = path.dirname(folder);
  return found?.isDirectory() || above === folder ? folder : existing(above);
}
