/** Reads the bytes of picked files. */
import type { InputFile } from '../../engine/api/types.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';

/** Reads one file after the other; `report` receives the fetched share of all bytes. */
export async function readFiles(
  files: readonly PickedFile[],
  report?: (fraction: number) => void,
  signal?: AbortSignal,
): Promise<InputFile[]> {
  const all = files.reduce((sum, { file }) => sum + file.size, 0);
  const read: InputFile[] = [];
  let before = 0;
  for (const { name, file } of files) {
    const bytes = await bytesOf(file, (done) => report?.((before + done) / all), signal).catch((error: unknown) => {
      if (signal?.aborted) throw error;
      throw new Error(`${name} could not be read. It may have been moved, or it is a folder. Drop it again.`);
    });
    before += file.size;
    read.push({ name, bytes });
  }
  return read;
}

async function bytesOf(file: File, report: (done: number) => void, signal?: AbortSignal): Promise<Uint8Array> {
  const bytes = new Uint8Array(file.size);
  const reader = file.stream().getReader();
  let done = 0;
  for (;;) {
    const { value } = await reader.read();
    if (!value) break;
    if (signal?.aborted) {
      await reader.cancel();
      signal.throwIfAborted();
    }
    bytes.set(value, done);
    done += value.length;
    report(done);
  }
  return bytes.subarray(0, done);
}
