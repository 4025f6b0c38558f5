/** Replaces zips among picked files by their models and companion files, as from a folder. Zips are untrusted input. */
import type { Entry } from '@zip.js/zip.js';
import { extensionOf, isMeantInFolder } from '../engine/api/paths.ts';
import type { PickedFile } from './dropped-files.ts';

const MOST_FILES = 20_000;
/** Limit for all files of one zip, compressed and unpacked. */
const MOST_BYTES = 1e9;

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
  const meant = entries.filter((entry) => !entry.directory && isMeantInFolder(entry.filename));
  if (meant.length === 0)
    throw new Error(`There is no model in ${name}. A zip can contain glTF, OBJ, PLY or OFF files.`);
  if (meant.length > MOST_FILES)
    throw new Error(`${name} has more than ${MOST_FILES.toLocaleString('en')} files. Unpack it and drop the poses.`);
  let left = MOST_BYTES;
  const files: PickedFile[] = [];
  for (const entry of meant) {
    const unpacked = await unpack(name, entry, left);
    left -= unpacked.size;
    files.push({ name: `${name}/${entry.filename}`, file: unpacked });
  }
  return files;
}

/** A zip's stated sizes may be false, so the unpacked bytes are counted. */
async function unpack(zip: string, entry: Entry, most: number): Promise<File> {
  const parts: BlobPart[] = [];
  let bytes = 0;
  const tooLarge = new Error(
    `${zip} has more than ${MOST_BYTES / 1e9} GB when unpacked. Unpack it and drop the poses.`,
  );
  const target = new WritableStream<Uint8Array<ArrayBuffer>>({
    write(part) {
      bytes += part.length;
      if (bytes > most) throw tooLarge;
      parts.push(part);
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
