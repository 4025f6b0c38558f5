/** In vertices. Smaller shapes are made quickly: neither a second thread nor an early first key pays off. */
export const LARGE = 40_000;
/** Fewest bytes of a vertex in a file without compression. */
const VERTEX_BYTES = 12;

/** Before files are read. */
export function mayBeLarge(files: readonly { bytes: Uint8Array }[]): boolean {
  return files.reduce((sum, { bytes }) => sum + bytes.length, 0) >= LARGE * VERTEX_BYTES;
}
