/** Key poses of a painted skin as a GLB. The first pose is the mesh; the others are morph targets. */
import type { Skin } from './skin.ts';

export interface Sculpture {
  skin: Skin;
  /** Positions of each key, 3 x vertices. */
  keys: readonly Float32Array[];
  /** The texture, as PNG. */
  picture: Uint8Array;
  roughness: number;
}

const [FLOAT, UNSIGNED_INT] = [5126, 5125];

export function glb({ skin, keys, picture, roughness }: Sculpture): Uint8Array {
  const [base, ...others] = keys as [Float32Array, ...Float32Array[]];
  const differences = others.map((key) => key.map((value, i) => value - base[i]!));
  const parts = [base, ...differences, skin.uvs, skin.faces, picture];
  const offsets = parts.map((_, i) => parts.slice(0, i).reduce((sum, part) => sum + padded(part.byteLength), 0));
  const places = [base, ...differences].map((values, view) => ({
    bufferView: view,
    componentType: FLOAT,
    count: base.length / 3,
    type: 'VEC3',
    ...extremes(values),
  }));
  const [uvs, faces, image] = [keys.length, keys.length + 1, keys.length + 2];
  const document = {
    asset: { version: '2.0', generator: 'shapespline' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [
      {
        primitives: [
          {
            attributes: { POSITION: 0, TEXCOORD_0: uvs },
            indices: faces,
            material: 0,
            targets: differences.map((_, i) => ({ POSITION: i + 1 })),
          },
        ],
      },
    ],
    materials: [
      {
        name: 'painted',
        pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: roughness },
      },
    ],
    textures: [{ source: 0, sampler: 0 }],
    samplers: [{ wrapS: 10497, wrapT: 33071 }],
    images: [{ bufferView: image, mimeType: 'image/png' }],
    accessors: [
      ...places,
      { bufferView: uvs, componentType: FLOAT, count: base.length / 3, type: 'VEC2' },
      { bufferView: faces, componentType: UNSIGNED_INT, count: skin.faces.length, type: 'SCALAR' },
    ],
    bufferViews: parts.map((part, i) => ({ buffer: 0, byteOffset: offsets[i], byteLength: part.byteLength })),
    buffers: [{ byteLength: offsets.at(-1)! + padded(picture.byteLength) }],
  };
  return container(new TextEncoder().encode(JSON.stringify(document)), parts, offsets);
}

function container(json: Uint8Array, parts: readonly ArrayBufferView[], offsets: readonly number[]): Uint8Array {
  const binary = offsets.at(-1)! + padded(parts.at(-1)!.byteLength);
  const start = 20 + padded(json.length);
  const result = new Uint8Array(start + 8 + binary);
  const view = new DataView(result.buffer);
  const words = [0x46546c67, 2, result.length, padded(json.length), 0x4e4f534a];
  words.forEach((word, i) => {
    view.setUint32(4 * i, word, true);
  });
  result.fill(0x20, 20, start);
  result.set(json, 20);
  view.setUint32(start, binary, true);
  view.setUint32(start + 4, 0x004e4942, true);
  parts.forEach((part, i) => {
    result.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), start + 8 + offsets[i]!);
  });
  return result;
}

function padded(bytes: number): number {
  return Math.ceil(bytes / 4) * 4;
}

function extremes(values: Float32Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  values.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3]!, value);
    max[i % 3] = Math.max(max[i % 3]!, value);
  });
  return { min, max };
}
