/**
 * Replaces the libraries with which glTF-Transform edits textures, in every bundle. They are not used here, and they
 * evaluate text as code on import, which strict page policies refuse.
 */
export function refuse(): never {
  throw new Error('Textures are not changed here.');
}

export { refuse as default, refuse as getPixels, refuse as savePixels, refuse as lanczos2, refuse as lanczos3 };
