/**
 * In the place of the libraries by which glTF-Transform changes textures, in every bundle: nothing here does that, and
 * they run text as code as soon as they are imported, which strict policies of pages refuse.
 */
export function refuse(): never {
  throw new Error('Textures are not changed here.');
}

export { refuse as default, refuse as getPixels, refuse as savePixels, refuse as lanczos2, refuse as lanczos3 };
