/** Encoded images of the file -> textures. An image that the browser cannot decode is left out. */
import { RepeatWrapping, SRGBColorSpace, Texture } from 'three';
import type { TextureImage } from '../engine/types.ts';

export async function decodeTextures(images: readonly TextureImage[]): Promise<(Texture | null)[]> {
  return Promise.all(images.map(async (image) => {
    try {
      return await decode(image);
    } catch {
      return null;
    }
  }));
}

async function decode({ bytes, mimeType }: TextureImage): Promise<Texture> {
  const blob = new Blob([bytes.slice().buffer], { type: mimeType });
  // glTF's texture origin is the top left corner, so the rows stay as they are.
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const texture = new Texture(bitmap);
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
