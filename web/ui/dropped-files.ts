/** Converts dropped items to files. Searches folders and leaves out files that do not belong to a model. */

import { CACHES, COMPANIONS, MODELS, isImportable, isModel } from '../engine/api/paths.ts';

export interface PickedFile {
  /** Path relative to the dropped item. */
  name: string;
  file: File;
}

/** The file that names a group: the first that is not a material, buffer or image. */
export function leadingName(names: readonly string[]): string {
  return names.find(isModel) ?? names[0] ?? '';
}

/** Accepted extensions for the system's file picker. */
export const ACCEPTED = [
  ...[...MODELS, ...CACHES, ...COMPANIONS].map((extension) => `.${extension}`),
  'model/gltf-binary',
  'model/gltf+json',
  '.zip',
].join();

/** Limit that stops the search of a whole disk dropped by mistake. */
const MAX_ENTRIES = 20_000;

/**
 * Call during the drop event, because its data exists only then. Single files are always taken, so their errors are
 * reported.
 */
export function droppedFiles({ items, files }: DataTransfer): Promise<PickedFile[]> {
  const entries = [...items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = [...files].map((file) => ({ name: file.name, file }));
  // Without entries, as from another program or an older browser, a folder appears as an unreadable file, which is
  // reported.
  if (entries.every((entry) => !entry?.isDirectory)) return Promise.resolve(plain);
  return filesOf(entries.filter((entry) => entry !== null));
}

/** Files at the top level, and files in folders that belong to models. Names are paths from the top level. */
export async function filesOf(entries: readonly FileSystemEntry[]): Promise<PickedFile[]> {
  const found: PickedFile[] = [];
  let left = MAX_ENTRIES;
  const walk = async (entry: FileSystemEntry, path: string, inFolder: boolean): Promise<void> => {
    left -= 1;
    if (left < 0)
      throw new Error(`More than ${MAX_ENTRIES.toLocaleString('en')} files were dropped. Drop only the poses.`);
    const name = path + entry.name;
    if (entry.isDirectory) {
      for (const child of await childrenOf(entry as FileSystemDirectoryEntry, name))
        await walk(child, `${name}/`, true);
    } else if (!inFolder || isImportable(name)) {
      found.push({ name, file: await fileOf(entry as FileSystemFileEntry, name) });
    }
  };
  for (const entry of entries) await walk(entry, '', false);
  if (found.length === 0)
    throw new Error(
      `There is no model in ${entries[0]?.name ?? 'what was dropped'}. Drop a folder with glTF, OBJ, PLY or OFF files.`,
    );
  return found;
}

async function childrenOf(folder: FileSystemDirectoryEntry, name: string): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const children: FileSystemEntry[] = [];
  // A reader returns at most a hundred entries per call.
  for (;;) {
    const batch = await read<FileSystemEntry[]>(name, (resolve, reject) => reader.readEntries(resolve, reject));
    if (batch.length === 0) return children;
    if (children.push(...batch) > MAX_ENTRIES) return children;
  }
}

const fileOf = (entry: FileSystemFileEntry, name: string): Promise<File> =>
  read(name, (resolve, reject) => entry.file(resolve, reject));

async function read<T>(
  name: string,
  start: (resolve: (value: T) => void, reject: (reason: unknown) => void) => void,
): Promise<T> {
  try {
    return await new Promise<T>(start);
  } catch {
    throw new Error(
      `${name} could not be read. It may have been moved, or you may not have permission to read it. Drop it again.`,
    );
  }
}
