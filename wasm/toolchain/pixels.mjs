// Pixel libraries that glTF-Transform imports but nothing here calls, and their replacements in bundles.
import { inRoot } from './paths.mjs';

export const withoutPixels = Object.fromEntries(
  ['ndarray', 'ndarray-lanczos', 'ndarray-pixels'].map((name) => [name, inRoot('web/engine/worker/no-pixels.ts')]),
);
