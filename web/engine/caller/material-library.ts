/** Materials and textures as files beside an OBJ. */
import type { ExportedFile, Material, Scene, TextureImage } from '../api/types.ts';

const EXTENSIONS: Record<string, string> = {
  'image/png': 'png',
  'image/jpeg': 'jpg',
  'image/webp': 'webp',
  'image/ktx2': 'ktx2',
};

/** Material names in an OBJ, where a space ends a name. */
export function materialLibrary(stem: string, { materials }: Scene): { file: string; names: string[] } {
  if (materials.length === 0) return { file: '', names: [] };
  const plain = materials.map(({ name }, i) => name.replace(/[\s\p{C}]+/gu, '_') || `material_${i + 1}`);
  const [taken, used] = [new Set(plain), new Set<string>()];
  const names = plain.map((name, index) => {
    let own = name;
    for (let number = index + 1; own === name ? used.has(own) : taken.has(own); number += 1) own = `${name}_${number}`;
    taken.add(own);
    used.add(own);
    return own;
  });
  return { file: `${stem.replace(/\s+/g, '_')}.mtl`, names };
}

const imageName = (stem: string, image: TextureImage, index: number): string =>
  `${stem.replace(/\s+/g, '_')}-texture-${index + 1}.${EXTENSIONS[image.mimeType] ?? 'bin'}`;

/** OBJ colours are in the screen's encoding. */
const encoded = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
const number = (value: number): string => String(Number(value.toFixed(6)));
const colour = (rgb: readonly number[]): string =>
  rgb
    .slice(0, 3)
    .map((part) => number(encoded(part)))
    .join(' ');

function described(material: Material, name: string, imageNames: readonly string[]): string {
  const map = (word: string, index: number): string[] => (index >= 0 ? [`${word} ${imageNames[index]}`] : []);
  return [
    `newmtl ${name}`,
    `Kd ${colour(material.baseColor)}`,
    'Ks 0 0 0',
    `Ke ${colour(material.emissive)}`,
    `d ${number(material.alphaMode === 'OPAQUE' ? 1 : material.baseColor[3])}`,
    `Pm ${number(material.metallic)}`,
    `Pr ${number(material.roughness)}`,
    ...map('map_Kd', material.baseColorImage),
    ...map('norm', material.normalImage),
    ...map('map_Ke', material.emissiveImage),
    '',
  ].join('\n');
}

/** The files of materials and textures; empty if the scene has no materials. */
export function materialFiles(stem: string, scene: Scene): ExportedFile[] {
  const { file, names } = materialLibrary(stem, scene);
  if (file === '') return [];
  const imageNames = scene.images.map((image, index) => imageName(stem, image, index));
  const text = scene.materials.map((material, index) => described(material, names[index]!, imageNames)).join('\n');
  return [
    { name: file, bytes: new TextEncoder().encode(text) },
    ...scene.images.map((image, index) => ({ name: imageNames[index]!, bytes: image.bytes })),
  ];
}
