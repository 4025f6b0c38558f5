/** Vertices. Smaller shapes are made at once: neither a second thread nor an early look is worth it. */
export const LARGE = 40_000;
/** Bytes of a file's vertex, at least; only what is compressed takes less. */
const VERTEX_BYTES = 12;

/** Before files are read. */
export function mayBeLarge(files: readonly { bytes: Uint8Array }[]): boolean {
  return files.reduce((sum, { bytes }) => sum + bytes.length, 0) >= LARGE * VERTEX_BYTES;
}
