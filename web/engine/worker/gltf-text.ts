/** Extracts the JSON text of glTF files before parsing. */

export const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;

/** The JSON text of a .glb or .gltf file; null for anything else, which the core reports. */
export function jsonOf(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const decode = (start: number, end: number): string => new TextDecoder().decode(bytes.subarray(start, end));
  if (bytes.length >= 20 && view.getUint32(0, true) === GLB_MAGIC) {
    if (view.getUint32(8, true) > bytes.length) return null; // the file is truncated
    const length = view.getUint32(12, true);
    return view.getUint32(16, true) === JSON_CHUNK && 20 + length <= bytes.length ? decode(20, 20 + length) : null;
  }
  return /^[\uFEFF\s]*\{/.test(decode(0, 64)) ? decode(0, bytes.length) : null;
}
