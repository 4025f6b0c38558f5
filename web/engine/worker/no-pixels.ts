/**
 * Replaces glTF-Transform's image libraries in every bundle. They are unused here, and their import evaluates text as
 * code, which strict page policies refuse.
 */
export function refuse(): never {
  throw new Error('Textures are not changed here.');
}

export { refuse as default, refuse as getPixels, refuse as savePixels, refuse as lanczos2, refuse as lanczos3 };
