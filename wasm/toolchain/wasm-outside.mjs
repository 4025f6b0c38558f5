// A plugin of esbuild for what is bundled into a folder of build/.
import path from 'node:path';

/** Leaves the wasm module out of a bundle in a folder of build/, and gives its address from there. */
export const wasmStaysOutside = {
  name: 'wasm-stays-outside',
  setup: ({ onResolve }) =>
    onResolve({ filter: /\/build\/wasm\// }, ({ path: file }) => ({
      path: `../../build/wasm/${path.basename(file)}`,
      external: true,
    })),
};
