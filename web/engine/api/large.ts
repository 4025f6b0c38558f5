/**
 * Number of vertices from which a shape is large. For smaller shapes, neither a second thread nor showing the first key
 * early pays off.
 */
export const LARGE = 40_000;
/** Least bytes per vertex in an uncompressed file. */
const VERTEX_BYTES = 12;

/** Whether the shape in these files may be large. Estimated from the files' sizes. */
export function mayBeLarge(files: readonly { bytes: Uint8Array }[]): boolean {
  return files.reduce((sum, { bytes }) => sum + bytes.length, 0) >= LARGE * VERTEX_BYTES;
}
