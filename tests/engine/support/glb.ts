/** Minimal GLB files with a pose or morph targets, made without any of the tested code. */
import type { InputFile } from '../../../web/engine/api/types.ts';
import type { Mesh } from './shapes.ts';

const FLOAT = 5126;
const UNSIGNED_INT = 5125;

interface Builder {
  views: { buffer: 0; byteOffset: number; byteLength: number }[];
  accessors: object[];
  parts: Uint8Array[];
  length: number;
}

function addAccessor(
  builder: Builder,
  array: Float32Array | Uint32Array,
  type: 'SCALAR' | 'VEC3',
  bounds: boolean,
): number {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  builder.views.push({ buffer: 0, byteOffset: builder.length, byteLength: bytes.length });
  builder.parts.push(bytes);
  builder.length += bytes.length;
  const width = type === 'VEC3' ? 3 : 1;
  const column = (c: number): number[] => Array.from(array).filter((_, i) => i % width === c);
  const columns = Array.from({ length: width }, (_, c) => column(c));
  const extent = {
    min: columns.map((v) => v.reduce((a, b) => Math.min(a, b))),
    max: columns.map((v) => v.reduce((a, b) => Math.max(a, b))),
  };
  return (
    builder.accessors.push({
      bufferView: builder.views.length - 1,
      componentType: array instanceof Float32Array ? FLOAT : UNSIGNED_INT,
      count: array.length / width,
      type,
      ...(bounds ? extent : {}),
    }) - 1
  );
}

/** Joins JSON and binary chunk into a GLB. */
export function glb(json: object, binary: Uint8Array = new Uint8Array(0)): Uint8Array {
  const pad = (bytes: Uint8Array, filler: number): Uint8Array => {
    const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4).fill(filler);
    padded.set(bytes);
    return padded;
  };
  const text = pad(new TextEncoder().encode(JSON.stringify(json)), 0x20);
  const data = pad(binary, 0);
  const length = 12 + 8 + text.length + (data.length > 0 ? 8 + data.length : 0);
  const words = (...values: number[]): Uint8Array => new Uint8Array(Uint32Array.from(values).buffer);
  const chunks: Uint8Array[] = [words(0x46546c67, 2, length, text.length, 0x4e4f534a), text];
  if (data.length > 0) chunks.push(words(data.length, 0x004e4942), data);
  return concatenated(chunks);
}

function concatenated(parts: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** One mesh at `positions`, with `targets` as morph targets, if any. */
export function meshGlb(mesh: Mesh, positions = mesh.positions, targets: Float32Array[] = []): Uint8Array {
  const builder: Builder = { views: [], accessors: [], parts: [], length: 0 };
  const attributes = { POSITION: addAccessor(builder, positions, 'VEC3', true) };
  const indices = addAccessor(builder, mesh.indices, 'SCALAR', false);
  const morphs = targets.map((target) => {
    const deltas = target.map((value, i) => value - positions[i]!);
    return { POSITION: addAccessor(builder, deltas, 'VEC3', true) };
  });
  const json = {
    asset: { version: '2.0' },
    buffers: [{ byteLength: builder.length }],
    bufferViews: builder.views,
    accessors: builder.accessors,
    meshes: [{ primitives: [{ attributes, indices, ...(morphs.length > 0 ? { targets: morphs } : {}) }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  return glb(json, concatenated(builder.parts));
}

/** One file per pose: pose-1.glb, pose-2.glb, ... */
export function poseFiles(mesh: Mesh, poses: Float32Array[]): InputFile[] {
  return poses.map((positions, i) => ({ name: `pose-${i + 1}.glb`, bytes: meshGlb(mesh, positions) }));
}

export function glbParts(bytes: Uint8Array): { json: Record<string, never>; bin: Uint8Array } {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Record<string, never>;
  return { json, bin: bytes.slice(28 + length) };
}

/** A .gltf with an embedded buffer. */
export function gltfInside(json: object, bin: Uint8Array): string {
  const uri = `data:application/octet-stream;base64,${Buffer.from(bin).toString('base64')}`;
  const { buffers } = json as { buffers: object[] };
  return JSON.stringify({ ...json, buffers: [{ uri, byteLength: bin.length }, ...buffers.slice(1)] });
}
