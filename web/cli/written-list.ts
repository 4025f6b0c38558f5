/**
 * A list beside written files, with their sizes and hashes. Only files that are still as listed are replaced or
 * removed. Its name is hidden, so folders are read without it.
 */
import { createHash } from 'node:crypto';
import { readFile, stat } from 'node:fs/promises';
import path from 'node:path';
import { EngineError } from '../engine/api/errors.ts';

export const LIST = '.shapespline.json';

export interface Written {
  name: string;
  size: number;
  sha256: string;
  /** The output that the file belongs to: the name of a file, or WHOLE_FOLDER. */
  of: string;
}

export const WHOLE_FOLDER = './';

export function written(name: string, bytes: Uint8Array | string, of: string): Written {
  return { name, size: Buffer.byteLength(bytes), sha256: hashOf(bytes), of };
}

const hashOf = (bytes: Uint8Array | string): string => createHash('sha256').update(bytes).digest('hex');

/** Whether a file has the size and the hash of one of these. */
export async function isOneOf(file: string, entries: readonly Written[]): Promise<boolean> {
  const { size } = await stat(file);
  const similar = entries.filter((entry) => entry.size === size);
  if (similar.length === 0) return false;
  const hash = hashOf(await readFile(file));
  return similar.some(({ sha256 }) => sha256 === hash);
}

/** The list of a folder; empty without one. */
export async function readList(folder: string): Promise<Written[]> {
  const file = path.join(folder, LIST);
  const text = await readFile(file, 'utf8').catch(() => null);
  if (text === null) return [];
  const files = parsed(text);
  if (files === null)
    throw new EngineError(
      'would-overwrite',
      `${file} is not a list of files that shapespline wrote. Remove it, or give --output another folder.`,
      { file },
    );
  return files;
}

function parsed(text: string): Written[] | null {
  try {
    const { files } = JSON.parse(text) as { files: Written[] };
    // A name with a folder would reach files elsewhere.
    return files.every(({ name, size, sha256, of }) => isName(name) && size >= 0 && typeof sha256 === 'string' && of)
      ? files
      : null;
  } catch {
    return null;
  }
}

const isName = (name: unknown): boolean =>
  typeof name === 'string' && name !== '' && !/[/\\]/.test(name) && name !== '.' && name !== '..';

export const listText = (files: readonly Written[]): string =>
  `${JSON.stringify({ about: 'Files that shapespline wrote and may replace while they are unchanged', files }, null, 1)}\n`;
