/** The npm package files that a page needs to show a motion, in the folder `shapespline/` beside it. */
import cdn from '../../../build/package/cdn.js?url';
import codecs from '../../../build/package/codecs.js?url';
import draco from '../../../build/package/draco_decoder_gltf.wasm?url';
import notices from '../../../build/package/notices.txt?url';
import license from '../../../LICENSE?raw';
import { files } from '../../engine/browser-files.ts';
import type { ExportedFile } from '../../engine/api/types.ts';

const FOLDER = 'shapespline';

/** A page, its GLB and the package. Each file is fetched when the zip reaches it. */
export async function* withPackage(
  page: string,
  shown: AsyncIterable<ExportedFile>,
  signal: AbortSignal,
): AsyncGenerator<ExportedFile, void, undefined> {
  const text = new TextEncoder();
  yield { name: 'index.html', bytes: text.encode(page) };
  yield { name: `${FOLDER}/LICENSE`, bytes: text.encode(license) };
  yield* shown;
  for (const [name, address] of Object.entries(packageFiles()))
    yield { name: `${FOLDER}/${name}`, bytes: await fetched(address, signal) };
}

function packageFiles(): Record<string, string> {
  return {
    'cdn.js': cdn,
    'codecs.js': codecs,
    'draco_decoder_gltf.wasm': draco,
    'shapespline.wasm': files.wasm().href,
    'shapespline_files.wasm': files.filesWasm().href,
    'shapespline_shells.wasm': files.shellsWasm().href,
    'shapespline_threads.wasm': files.threads().href,
    'notices.txt': notices,
  };
}

async function fetched(address: string, signal: AbortSignal): Promise<Uint8Array> {
  const response = await fetch(address, { signal }).catch(() => null);
  signal.throwIfAborted();
  if (!response?.ok)
    throw new Error('Part of the package for your page could not be fetched. Check the connection and try again.');
  return new Uint8Array(await response.arrayBuffer());
}
