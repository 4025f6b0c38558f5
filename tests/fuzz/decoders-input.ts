/** Runs an input of the decoders and checks the promises. */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { EngineError } from '../../web/engine/api/errors.ts';
import { codecs } from '../../web/engine/worker/codecs.ts';
import { decoder } from '../../web/engine/worker/decompress.ts';

const require = createRequire(import.meta.url);
const draco = readFile(require.resolve('draco3dgltf/draco_decoder_gltf.wasm'));
const decode = decoder(codecs, () => draco);

/** Memory of the process including garbage: far above the need of a small file. */
const MAX_MEMORY = 2e9;

/**
 * Decodes the input or refuses it with a message, in little memory; throws otherwise. Resolves to whether it was
 * decoded.
 */
export async function oneInput(bytes: Uint8Array): Promise<boolean> {
  let refused = false;
  try {
    const [file] = await decode([{ name: 'input.glb', bytes }], () => undefined);
    if (!file || file.bytes.length === 0) throw new Error('nothing came out');
  } catch (error) {
    if (!(error instanceof EngineError) || !/^input\.glb.*\.$/s.test(error.message)) throw error;
    refused = true;
  }
  const { rss } = process.memoryUsage();
  if (rss > MAX_MEMORY) throw new Error(`the process has ${(rss / 1e9).toFixed(1)} GB`);
  return !refused;
}
