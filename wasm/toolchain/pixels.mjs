// Image libraries that glTF-Transform imports but this project never calls, and their replacements in bundles.
import { inRoot } from './paths.mjs';

export const withoutPixels = Object.fromEntries(
  ['ndarray', 'ndarray-lanczos', 'ndarray-pixels'].map((name) => [name, inRoot('web/engine/worker/no-pixels.ts')]),
);
