/** The npm package's files in Node, located from its folder `node`. */
import type { NodeFiles } from '../node-files.ts';

const beside = (name: string): URL => new URL(name, import.meta.url);

export const files: NodeFiles = {
  worker: beside('./node-worker.mjs'),
  wasm: beside('../shapespline.wasm'),
  filesWasm: beside('../shapespline_files.wasm'),
  shellsWasm: beside('../shapespline_shells.wasm'),
  threads: beside('../shapespline_threads.wasm'),
  forWorker: (draco = beside('../draco_decoder_gltf.wasm').href) => ({ draco, codecs: beside('../codecs.js').href }),
};
