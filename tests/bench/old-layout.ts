/**
 * The old layout of exported animations: all primitives share one vertex buffer, including targets. Made from one of
 * our GLBs with one primitive, whose faces are sorted by part.
 */

interface Primitive {
  indices: number;
  material?: number;
}

interface Document {
  accessors: { count: number; byteOffset?: number; componentType: number }[];
  materials: object[];
  meshes: { primitives: Primitive[] }[];
}

const INDEX_BYTES: Record<number, number> = { 5123: 2, 5125: 4 };

/** The mesh in this many primitives of equal size, each with a separate material. */
export function sharingVertices(glb: Uint8Array, parts: number): Uint8Array {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length))) as Document;
  const [primitive, ...others] = json.meshes[0]!.primitives;
  if (others.length > 0) throw new Error('The GLB has several primitives.');
  const indices = json.accessors[primitive!.indices]!;
  const faces = indices.count / 3;
  const starts = Array.from({ length: parts + 1 }, (_, part) => Math.round((part * faces) / parts));
  json.materials = starts.slice(1).map((_, part) => ({ name: `material ${part + 1}` }));
  json.meshes[0]!.primitives = starts.slice(1).map((end, part) => {
    const start = starts[part]!;
    const byteOffset = (indices.byteOffset ?? 0) + 3 * start * INDEX_BYTES[indices.componentType]!;
    json.accessors.push({ ...indices, count: 3 * (end - start), byteOffset });
    return { ...primitive!, indices: json.accessors.length - 1, material: part };
  });
  return withJson(json, glb.subarray(20 + length));
}

/** `rest`: the binary chunk with its header. */
function withJson(json: object, rest: Uint8Array): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = Math.ceil(text.length / 4) * 4;
  const out = new Uint8Array(20 + padded + rest.length).fill(0x20, 20, 20 + padded);
  const head = new DataView(out.buffer);
  [0x46546c67, 2, out.length, padded, 0x4e4f534a].forEach((value, i) => head.setUint32(4 * i, value, true));
  out.set(text, 20);
  out.set(rest, 20 + padded);
  return out;
}
