// An esbuild plugin for bundles in a folder of build/.
import path from 'node:path';

/** Leaves the wasm module out of a bundle in a folder of build/, and provides its relative path. */
export const wasmStaysOutside = {
  name: 'wasm-stays-outside',
  setup: ({ onResolve }) =>
    onResolve({ filter: /\/build\/wasm\// }, ({ path: file }) => ({
      path: `../../build/wasm/${path.basename(file)}`,
      external: true,
    })),
};
