/**
 * Real inputs outside the repository. Tests that use them are skipped if the folder is missing, or fail if
 * SHAPESPLINE_DATA_REQUIRED is set.
 */
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { InputFile } from '../../../web/engine/api/types.ts';

const folder = process.env.SHAPESPLINE_DATA ?? fileURLToPath(new URL('../../../../shared/data', import.meta.url));

function isThere(file: string): boolean {
  if (existsSync(file)) return true;
  if (process.env.SHAPESPLINE_DATA_REQUIRED) throw new Error(`${file} is missing`);
  return false;
}

export const hasData = isThere(folder);

export function dataFile(name: string): InputFile {
  return { name, bytes: readFileSync(path.join(folder, name)) };
}

/** Paths of all files in a data folder, relative to the data root; empty if it is missing. */
export function dataFiles(inside: string): string[] {
  const start = path.join(folder, inside);
  if (!isThere(start)) return [];
  const all = readdirSync(start, { recursive: true }).map((name) => path.join(inside, name.toString()));
  return all.filter((name) => statSync(path.join(folder, name)).isFile()).sort();
}
