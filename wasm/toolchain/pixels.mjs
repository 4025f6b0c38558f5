// Libraries for pixels that glTF-Transform imports and nobody here calls, with what bundles have in their place.
import { inRoot } from './paths.mjs';

export const withoutPixels = Object.fromEntries(
  ['ndarray', 'ndarray-lanczos', 'ndarray-pixels'].map((name) => [name, inRoot('web/engine/worker/no-pixels.ts')]),
);
