/** Limits the total bytes of an import, because files, the worker's copy and the results are in memory together. */
import { EngineError } from './errors.ts';

export const MAX_BYTES = 2 ** 30;

const gigabytes = (bytes: number): string => `${(bytes / 1e9).toFixed(2)} GB`;

/** Refuses files whose total size exceeds the limit. */
export function checkImportSize(bytes: number): void {
  if (bytes <= MAX_BYTES) return;
  throw new EngineError(
    'too-large',
    `The files are ${gigabytes(bytes)} in total, but at most ${gigabytes(MAX_BYTES)} can be read at once. ` +
      'Simplify the mesh or use fewer keys.',
  );
}
