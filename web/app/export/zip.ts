/** An uncompressed zip of files, to download a folder at once. */
import { downloadZip } from 'client-zip';
import type { ExportedFile } from '../../engine/api/types.ts';

/** The first date of the format, constant so equal files give equal bytes. */
const FIRST_DAY = new Date(1980, 0, 1);

/** Reads files one by one and releases each. The browser may store the growing zip on disk. */
export async function zip(files: Iterable<ExportedFile> | AsyncIterable<ExportedFile>): Promise<Blob> {
  let failure: unknown = null;
  async function* entries() {
    try {
      for await (const { name, bytes } of files) yield { name, input: bytes, lastModified: FIRST_DAY };
    } catch (error) {
      failure = error;
      throw error;
    }
  }
  try {
    return await downloadZip(entries()).blob();
  } catch (error) {
    // Browsers report only that a stream failed, without the reason.
    throw failure ?? error;
  }
}
