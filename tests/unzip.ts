/** Unpacks a zip with another library than the one that writes it, and checks all checksums. */
import { BlobReader, Uint8ArrayWriter, ZipReader } from '@zip.js/zip.js';
import type { ExportedFile } from '../web/engine/api/types.ts';

export async function unzip(blob: Blob): Promise<ExportedFile[]> {
  const reader = new ZipReader(new BlobReader(blob), { checkSignature: true, useWebWorkers: false });
  const files: ExportedFile[] = [];
  for (const entry of await reader.getEntries()) {
    if (entry.directory) continue;
    files.push({ name: entry.filename, bytes: await entry.getData(new Uint8ArrayWriter()) });
  }
  return files;
}
