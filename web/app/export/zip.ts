/** A zip of files as they are, without compression: enough to hand over a folder in one download. */
import { downloadZip } from 'client-zip';
import type { ExportedFile } from '../../engine/api/types.ts';

/** The first day of the format: the same files give the same bytes. */
const FIRST_DAY = new Date(1980, 0, 1);

/** Files are taken one by one and let go; the browser may put what it has of the zip on its disk. */
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
    // Of a stream that fails browsers only tell that it did.
    throw failure ?? error;
  }
}
