/** Decodes images of the file into textures of its materials. Leaves out images that the browser cannot decode. */
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

/** glTF's numbers, which are those of OpenGL. */
const MAG_FILTERS: Record<number, MagnificationTextureFilter> = { 9728: NearestFilter, 9729: LinearFilter };
const MIN_FILTERS: Record<number, MinificationTextureFilter> = {
  9728: NearestFilter,
  9729: LinearFilter,
  9984: NearestMipmapNearestFilter,
  9985: LinearMipmapNearestFilter,
  9986: NearestMipmapLinearFilter,
  9987: LinearMipmapLinearFilter,
};

/** The colour texture of each material, or null. Materials with the same image and sampling share a texture. */
export async function decodeTextures(
  images: readonly TextureImage[],
  materials: readonly Material[],
): Promise<(Texture | null)[]> {
  const decoded: (Texture | null)[] = [];
  // Images are decoded one after the other, because decoding needs more memory than the result.
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

/** Shares the image with the given texture. */
function sampled(image: Texture, { wrapS, wrapT, magFilter, minFilter }: Material): Texture {
  const texture = image.clone();
  texture.wrapS = WRAPPINGS[wrapS];
  texture.wrapT = WRAPPINGS[wrapT];
  texture.magFilter = MAG_FILTERS[magFilter] ?? LinearFilter;
  texture.minFilter = MIN_FILTERS[minFilter] ?? LinearMipmapLinearFilter;
  texture.needsUpdate = true;
  return texture;
}
