/**
 * The engine's files in this repository, for its own programs. In the npm package, `packaged/node-files` replaces this
 * file. The relative paths are the same from this file and from its bundles (build/node).
 */
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import type { WorkerFiles } from './wire/protocol.ts';

export interface NodeFiles {
  worker: URL;
  wasm: URL;
  filesWasm: URL;
  shellsWasm: URL;
  threads: URL;
  forWorker(draco?: string): WorkerFiles;
}

const require = createRequire(import.meta.url);

export const files: NodeFiles = {
  worker: new URL('../../build/node/node-worker.mjs', import.meta.url),
  wasm: new URL('../../build/wasm/shapespline.wasm', import.meta.url),
  filesWasm: new URL('../../build/wasm/shapespline_files.wasm', import.meta.url),
  shellsWasm: new URL('../../build/wasm/shapespline_shells.wasm', import.meta.url),
  threads: new URL('../../build/wasm/shapespline_threads.wasm', import.meta.url),
  forWorker: (draco = pathToFileURL(require.resolve('draco3dgltf/draco_decoder_gltf.wasm')).href) => ({ draco }),
};
