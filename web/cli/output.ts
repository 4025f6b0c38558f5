/** Files appear whole or not at all: they are written beside their place and moved there last. */
import { mkdir, rename, rm, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';

export interface Output {
  /** Ends in '/' for a folder of several files. */
  path: string;
  files: { name: string; bytes: Uint8Array | string }[];
}

interface Move {
  from: string;
  to: string;
}

/** Writes all outputs or, when anything fails, none. */
export async function writeOutputs(outputs: Output[]): Promise<void> {
  const mark = `.partial-${process.pid}`;
  const partial: string[] = [];
  try {
    const moves: Move[] = [];
    for (const output of outputs) moves.push(...(await writeBeside(output, mark, partial)));
    for (const { to } of moves) await mkdir(path.dirname(to), { recursive: true });
    for (const { from, to } of moves) await rename(from, to);
  } catch (error) {
    throw new EngineError('not-written', `The result cannot be written (${messageOf(error)}).`);
  } finally {
    for (const place of partial) await rm(place, { recursive: true, force: true });
  }
}

async function writeBeside({ path: place, files }: Output, mark: string, partial: string[]): Promise<Move[]> {
  const isFolder = place.endsWith('/');
  const target = path.resolve(place);
  const temporary = path.join(await existing(path.dirname(target)), `${path.basename(target)}${mark}`);
  partial.push(temporary);
  if (isFolder) await mkdir(temporary);
  const moves = files.map(({ name }) =>
    isFolder ? { from: path.join(temporary, name), to: path.join(target, name) } : { from: temporary, to: target },
  );
  for (const [index, { from }] of moves.entries()) await writeFile(from, files[index]!.bytes);
  return moves;
}

/** The nearest folder that is there already. */
async function existing(folder: string): Promise<string> {
  const found = await stat(folder).then(
    (entry) => entry.isDirectory(),
    () => false,
  );
  const above = path.dirname(folder);
  return found || above === folder ? folder : existing(above);
}
