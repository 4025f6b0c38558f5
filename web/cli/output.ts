/**
 * Writes files completely or not at all: first next to their destination, then moved there. Replaces no input, and
 * beside the named outputs only files that are still as they were written.
 */
import { mkdirSync, rmSync, type Stats } from 'node:fs';
import { lstat, readFile, readdir, readlink, realpath, rename, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { readNote } from '../engine/api/export-note.ts';
import { sequencesIn } from '../engine/api/numbered-names.ts';
import { extensionOf } from '../engine/api/paths.ts';
import { KnownFiles, identityOf } from './known-files.ts';
import { LIST, WHOLE_FOLDER, isOneOf, listText, readList, written, type Written } from './written-list.ts';

interface OutputFile {
  name: string;
  bytes: Uint8Array | string;
}

export interface Output {
  /** The option that names the path. */
  flag: string;
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

/** The files that belong to one output, apart from the file that it names. */
interface Beside {
  /** Their folder, and as the user gave it. */
  folder: string;
  shown: string;
  /** The main file's name, or WHOLE_FOLDER. */
  of: string;
  files: Written[];
  /** Temporary path of the new list. */
  list: string;
}

/**
 * Refuses outputs that would replace an input, a changed file or each other, before the work. `beside`: files that are
 * certainly written next to the output.
 */
export async function checkOutputs(
  outputs: (Pick<Output, 'flag' | 'path'> & { beside?: string[] })[],
  known: KnownFiles,
): Promise<void> {
  const flags = new Map<string, string>();
  for (const { flag, path: given, beside = [] } of outputs) {
    // What cannot be written is reported when it is written.
    const found = await place(given).catch(() => null);
    if (!found || found.stream) continue;
    const { target } = found;
    if (given.endsWith('/')) {
      await checkBeside({ folder: target, shown: given, of: WHOLE_FOLDER, files: [], list: '' }, known);
      continue;
    }
    await known.check(target, given, flag);
    for (const name of beside)
      await known.check(path.join(path.dirname(target), name), path.join(path.dirname(given), name), null);
    const key = (await identityOf(target)) ?? (await canonical(target));
    const other = flags.get(key);
    if (other)
      throw new EngineError('would-overwrite', `${other} and ${flag} are the same file ${given}. Give two names.`);
    flags.set(key, flag);
  }
}

/**
 * Writes all outputs or, on any failure, none. Destinations that are not regular files (a device, a pipe) are written
 * directly, last.
 */
export async function writeOutputs(outputs: Output[], known = new KnownFiles()): Promise<void> {
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
    await move(outputs, known, partial, made);
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
async function move(outputs: Output[], known: KnownFiles, partial: string[], made: string[]): Promise<void> {
  const whole: Move[] = [];
  const streams: { to: string; bytes: OutputFile['bytes'] }[] = [];
  const companions: Beside[] = [];
  for (const output of outputs) {
    const { target, stream } = await place(output.path);
    const isFolder = output.path.endsWith('/');
    const temporary = stream ? null : await partialPlace(target, output, partial);
    const beside = besideOf(output, target, temporary);
    let isFirst = true;
    for await (const { name, bytes } of output.files) {
      const isMain = isFirst && !isFolder;
      isFirst = false;
      if (temporary === null) {
        if (isMain || isFolder) streams.push({ to: target, bytes });
        continue;
      }
      const to = isMain ? target : path.join(beside.folder, name);
      const from = isFolder ? path.join(temporary, name) : `${temporary}${isMain ? '' : `.${whole.length}`}`;
      if (!isFolder && !isMain) partial.push(from);
      await writeFile(from, bytes);
      whole.push({ from, to });
      if (isMain) await known.check(to, output.path, output.flag);
      else beside.files.push(written(name, bytes, beside.of));
    }
    if (beside.files.length > 0) companions.push(beside);
  }
  await checkPlaces(whole);
  const stale: string[] = [];
  for (const beside of companions) {
    const { list, removed } = await checkBeside(beside, known);
    stale.push(...removed);
    partial.push(beside.list);
    await writeFile(beside.list, list);
    whole.push({ from: beside.list, to: path.join(beside.folder, LIST) });
  }
  for (const { to } of whole) {
    // No signal may come between a folder and its entry in the list.
    const first = mkdirSync(path.dirname(to), { recursive: true });
    if (first !== undefined) made.push(first);
  }
  for (const { to, bytes } of streams) await writeFile(to, bytes);
  for (const { from, to } of whole) await rename(from, to);
  for (const file of stale) rmSync(file, { force: true });
}

function besideOf({ path: given }: Output, target: string, temporary: string | null): Beside {
  const isFolder = given.endsWith('/');
  return {
    folder: isFolder ? target : path.dirname(target),
    shown: isFolder ? given : path.dirname(given),
    of: isFolder ? WHOLE_FOLDER : path.basename(target),
    files: [],
    list: isFolder ? path.join(temporary ?? '', LIST) : `${temporary}.list`,
  };
}

/**
 * Refuses to replace or remove a file beside an output that is an input, or is not as we wrote it. Returns the new
 * list, and the files of the folder's earlier output that the new one does not have.
 */
async function checkBeside(beside: Beside, known: KnownFiles): Promise<{ list: string; removed: string[] }> {
  const { folder, shown, of, files } = beside;
  const isFolder = of === WHOLE_FOLDER;
  const listed = await readList(folder);
  const names = new Set(files.map(({ name }) => name));
  const stale = listed.filter((one) => isFolder && one.of === of && !names.has(one.name));
  for (const file of [...files, ...stale]) {
    const there = path.join(folder, file.name);
    if (!(await statsOf(there))) continue;
    await known.check(there, path.join(shown, file.name), null);
    const entries = listed.filter(({ name }) => name === file.name);
    if (await isOneOf(there, [file, ...entries])) continue;
    if (!isFolder && entries.length === 0 && (await isFormerObj(there, path.join(folder, of)))) continue;
    throw new EngineError(
      'would-overwrite',
      `${path.join(shown, file.name)} belongs to the output, but a file of this name is there that shapespline did ` +
        `not write, or that has changed since. Give --output another ${isFolder ? 'folder' : 'name'}, or move the file.`,
      { file: file.name },
    );
  }
  if (isFolder) await checkSequence(beside, listed);
  const kept = listed.filter((one) => !names.has(one.name) && !stale.includes(one));
  return { list: listText([...kept, ...files]), removed: stale.map(({ name }) => path.join(folder, name)) };
}

/** Whether it is the OBJ of a point cache from a version that kept no list. */
async function isFormerObj(file: string, cache: string): Promise<boolean> {
  return extensionOf(file) === 'obj' && (await statsOf(cache)) !== null && readNote(await readFile(file)) !== null;
}

/** Refuses files that readers of the folder would take for frames. */
async function checkSequence({ folder, shown, files }: Beside, listed: readonly Written[]): Promise<void> {
  const ours = new Set([...files, ...listed].map(({ name }) => name));
  const others = (await readdir(folder).catch(() => [])).filter((name) => !ours.has(name) && !name.startsWith('.'));
  const frames = new Set(files.map(({ name }) => name));
  for (const { names } of sequencesIn([...others, ...frames])) {
    const other = names.find((name) => !frames.has(name));
    if (other === undefined || !names.some((name) => frames.has(name))) continue;
    throw new EngineError(
      'would-overwrite',
      `${path.join(shown, other)} would be read as a frame of the new motion, but shapespline did not write it. ` +
        'Give --output another folder, or move the file.',
      { file: other },
    );
  }
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
  if (given.endsWith('/')) mkdirSync(temporary);
  return temporary;
}

/** Checks all moves before the first one. */
async function checkPlaces(moves: Move[]): Promise<void> {
  const taken = new Set<string>();
  for (const { to } of moves) {
    const place = await canonical(to);
    if (taken.has(place)) throw new Error(`two results would be written to ${to}`);
    taken.add(place);
    const there = await statsOf(to);
    if (there?.isDirectory()) throw new Error(`${to} is a folder`);
    if (there && !there.isFile()) throw new Error(`${to} is not a regular file`);
  }
}

/** The path without links in the folders that exist. */
async function canonical(file: string): Promise<string> {
  const folder = path.dirname(file);
  if (folder === file) return file;
  return path.join(await realpath(folder).catch(() => canonical(folder)), path.basename(file));
}

const statsOf = (file: string): Promise<Stats | null> => stat(file).catch(() => null);

/** The nearest existing ancestor folder. */
async function existing(folder: string): Promise<string> {
  const found = await statsOf(folder);
  const above = path.dirname(folder);
  return found?.isDirectory() || above === folder ? folder : existing(above);
}
