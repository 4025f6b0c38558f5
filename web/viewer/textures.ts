/** Encoded images of the file -> textures of its materials. An image that the browser cannot decode is left out. */
import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearMipmapNearestFilter,
  MirroredRepeatWrapping,
  NearestFilter,
  NearestMipmapLinearFilter,
  NearestMipmapNearestFilter,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from 'three';
import type { MagnificationTextureFilter, MinificationTextureFilter } from 'three';
import type { Material, TextureImage } from '../engine/api/types.ts';

const WRAPPINGS = { repeat: RepeatWrapping, clamp: ClampToEdgeWrapping, mirror: MirroredRepeatWrapping } as const;

/** glTF's numbers, which are OpenGL's. */
const MAG_FILTERS: Record<number, MagnificationTextureFilter> = { 9728: NearestFilter, 9729: LinearFilter };
const MIN_FILTERS: Record<number, MinificationTextureFilter> = {
  9728: NearestFilter,
  9729: LinearFilter,
  9984: NearestMipmapNearestFilter,
  9985: LinearMipmapNearestFilter,
  9986: NearestMipmapLinearFilter,
  9987: LinearMipmapLinearFilter,
};

/** The texture that colours each material, or null. Materials that sample an image in the same way share it. */
export async function decodeTextures(
  images: readonly TextureImage[],
  materials: readonly Material[],
): Promise<(Texture | null)[]> {
  const decoded: (Texture | null)[] = [];
  // One after the other, because an image takes more memory while it is decoded.
  for (const image of images) decoded.push(image.scale > 0 ? await decode(image).catch(() => null) : null);
  const shared = new Map<string, Texture>();
  return materials.map((material) => {
    const image = decoded[material.baseColorImage];
    if (!image) return null;
    const { baseColorImage, wrapS, wrapT, magFilter, minFilter } = material;
    const way = [baseColorImage, wrapS, wrapT, magFilter, minFilter].join();
    const texture = shared.get(way) ?? sampled(image, material);
    shared.set(way, texture);
    return texture;
  });
}

async function decode({ bytes, mimeType, scale }: TextureImage): Promise<Texture> {
  const blob = new Blob([bytes.slice().buffer], { type: mimeType });
  // glTF's texture origin is the top left corner, so rows are not flipped.
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const texture = new Texture(scale < 1 ? await smaller(bitmap, scale) : bitmap);
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}

async function smaller(bitmap: ImageBitmap, scale: number): Promise<ImageBitmap> {
  const size = {
    resizeWidth: Math.max(Math.round(bitmap.width * scale), 1),
    resizeHeight: Math.max(Math.round(bitmap.height * scale), 1),
  };
  const small = await createImageBitmap(bitmap, { ...size, resizeQuality: 'medium' });
  bitmap.close();
  return small;
}

/** Shares the image with the texture that it is made from. */
function sampled(image: Texture, { wrapS, wrapT, magFilter, minFilter }: Material): Texture {
  const texture = image.clone();
  texture.wrapS = WRAPPINGS[wrapS];
  texture.wrapT = WRAPPINGS[wrapT];
  texture.magFilter = MAG_FILTERS[magFilter] ?? LinearFilter;
  texture.minFilter = MIN_FILTERS[minFilter] ?? LinearMipmapLinearFilter;
  texture.needsUpdate = true;
  return texture;
}
