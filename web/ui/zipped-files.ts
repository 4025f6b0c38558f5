/** Replaces zips among picked files by their models and companion files, as from a folder. Zips are untrusted input. */
import type { Entry } from '@zip.js/zip.js';
import { bytesText } from '../engine/api/bytes-text.ts';
import { extensionOf, fileName, isImportable, nameKey } from '../engine/api/paths.ts';
import type { PickedFile } from './dropped-files.ts';

const MAX_FILES = 20_000;
/**
 * Limits for the unpacked files of one zip: relative to its size, for small zips, and for all. Models shrink to a half
 * or a tenth. A zip of zeros can be a thousand times smaller, so a small one could fill the memory.
 */
const LARGEST_RATIO = 100;
const SMALL = 64e6;
const LARGEST = 1e9;
/** Unpacking pauses after this time, so the page can respond. */
const SLICE_MS = 12;

/** The files, with each zip replaced by its contents. The library is loaded with the first zip. */
export async function unzipped(picked: PickedFile[]): Promise<PickedFile[]> {
  const lists = picked.map((one) => (extensionOf(one.name) === 'zip' ? filesIn(one) : [one]));
  return (await Promise.all(lists)).flat();
}

async function filesIn({ name, file }: PickedFile): Promise<PickedFile[]> {
  const { BlobReader, ZipReader } = await import('@zip.js/zip.js/index-native.js');
  const reader = new ZipReader(new BlobReader(file), { useWebWorkers: false });
  const entries = await reader.getEntries().catch(() => {
    throw new Error(`${name} is not a readable zip. Unpack it and drop the files.`);
  });
  const importable = entries.filter((entry) => !entry.directory && isImportable(entry.filename));
  if (importable.length === 0)
    throw new Error(`There is no model in ${name}. A zip can contain glTF, OBJ, PLY or OFF files.`);
  if (importable.length > MAX_FILES)
    throw new Error(`${name} has more than ${MAX_FILES.toLocaleString('en')} files. Unpack it and drop the poses.`);
  checkNames(name, importable);
  const most = Math.min(Math.max(SMALL, LARGEST_RATIO * file.size), LARGEST);
  const tooLarge = new Error(
    `${name} has more than ${bytesText(most)} when unpacked, the limit for a zip of its size. Unpack it and drop the poses.`,
  );
  if (importable.reduce((sum, { uncompressedSize }) => sum + uncompressedSize, 0) > most) throw tooLarge;
  let left = most;
  const files: PickedFile[] = [];
  for (const entry of importable) {
    const unpacked = await unpack(name, entry, left, tooLarge);
    left -= unpacked.size;
    files.push({ name: `${name}/${entry.filename}`, file: unpacked });
  }
  return files;
}

/** Programs that unpack such a zip ask which file to keep. */
function checkNames(zip: string, entries: readonly Entry[]): void {
  const names = new Set<string>();
  for (const { filename } of entries) {
    if (names.has(nameKey(filename)))
      throw new Error(
        `${zip} contains two files named ${fileName(filename)}. Unpack it, rename one of them, and drop the files.`,
      );
    names.add(nameKey(filename));
  }
}

/** A zip's stated sizes may be false, so the unpacked bytes are counted. */
async function unpack(zip: string, entry: Entry, most: number, tooLarge: Error): Promise<File> {
  const parts: BlobPart[] = [];
  let bytes = 0;
  let until = performance.now() + SLICE_MS;
  const target = new WritableStream<Uint8Array<ArrayBuffer>>({
    async write(part) {
      bytes += part.length;
      if (bytes > most) throw tooLarge;
      parts.push(part);
      if (performance.now() < until) return;
      await new Promise((resolve) => setTimeout(resolve, 0));
      until = performance.now() + SLICE_MS;
    },
  });
  if (entry.directory) return new File([], entry.filename);
  await entry.getData(target, { checkSignature: true }).catch((error: unknown) => {
    if (bytes > most) throw tooLarge;
    const why = entry.encrypted ? 'is encrypted' : 'cannot be unpacked';
    throw new Error(`${entry.filename} in ${zip} ${why}. Unpack the zip and drop the files.`, { cause: error });
  });
  return new File(parts, entry.filename);
}
