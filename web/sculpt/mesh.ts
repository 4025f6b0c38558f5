/** Key poses of a painted skin as arrays for the engine, with the same look as in the GLB. */
import type { Sculpture } from './glb.ts';

export type Mesh = ReturnType<typeof meshOf>;

export function meshOf({ skin, keys, picture, roughness }: Sculpture) {
  return {
    faces: skin.faces,
    poses: keys.map((positions, key) => ({ name: `pose ${key + 1}`, time: key, positions })),
    scene: {
      uvs: skin.uvs,
      seams: null,
      colors: null,
      polygons: null,
      groups: [{ start: 0, count: skin.faces.length / 3, material: 0 }],
      materials: [{ ...PLAIN, name: 'painted', roughness, baseColorImage: 0, wrapT: 'clamp' as const }],
      images: [{ mimeType: 'image/png', bytes: picture, scale: 1 }],
    },
  };
}

const PLAIN = {
  baseColor: [1, 1, 1, 1] as [number, number, number, number],
  metallic: 0,
  doubleSided: false,
  alphaMode: 'OPAQUE' as const,
  alphaCutoff: 0.5,
  unlit: false,
  emissive: [0, 0, 0] as [number, number, number],
  normalScale: 1,
  occlusionStrength: 1,
  metallicRoughnessImage: -1,
  normalImage: -1,
  occlusionImage: -1,
  emissiveImage: -1,
  wrapS: 'repeat' as const,
  magFilter: 0,
  minFilter: 0,
};
