/** Loads WebAssembly from a URL that may return anything. */
import type { FileUrls } from '../api/configure.ts';
import { engineError, messageOf, notLoaded, type EngineError } from '../api/errors.ts';

const MAGIC = [0x00, 0x61, 0x73, 0x6d];
/** Number of response bytes to show in an error. */
const SHOWN = 24;

/**
 * Compiles while loading if the server sends the right type. Error: not-loaded, with a description of the response;
 * `option` is the name of the URL's option.
 */
export async function compileFrom(
  url: URL,
  option: keyof FileUrls,
  load: (url: URL) => Promise<Response> = fetch,
): Promise<WebAssembly.Module> {
  const response = await load(url).catch((error: unknown) => {
    throw notLoaded(url.href, messageOf(error));
  });
  if (!response.ok) throw otherwise(url, option, `${response.status} ${response.statusText}`.trim());
  const type = response.headers.get('Content-Type') ?? 'no content type';
  try {
    if (!type.startsWith('application/wasm'))
      return await WebAssembly.compile(checked(url, option, type, await response.arrayBuffer()));
    const copy = response.clone();
    return await WebAssembly.compileStreaming(response).catch(async (error: unknown) => {
      checked(url, option, type, await copy.arrayBuffer());
      throw error;
    });
  } catch (error) {
    if ((error as Partial<EngineError>).code === 'not-loaded') throw error;
    throw /content security policy/i.test(messageOf(error)) ? forbidden() : notLoaded(url.href, messageOf(error));
  }
}

/** A host may return an HTML page with status 200 for a missing file. */
function checked(url: URL, option: string, type: string, bytes: ArrayBuffer): ArrayBuffer {
  const begin = new Uint8Array(bytes, 0, Math.min(SHOWN, bytes.byteLength));
  if (MAGIC.every((byte, index) => begin[index] === byte)) return bytes;
  const text = new TextDecoder()
    .decode(begin)
    .replace(/[^\x20-\x7e]+/g, ' ')
    .trim();
  throw otherwise(url, option, begin.length === 0 ? 'nothing' : `“${text}…” (${type})`);
}

function otherwise(url: URL, option: string, what: string): EngineError {
  return engineError(
    'not-loaded',
    `The computation could not be loaded: ${url.href} returned ${what} instead of WebAssembly. ` +
      `Put the .wasm file there, or set its URL: configure({ ${option} }).`,
  );
}

function forbidden(): EngineError {
  return engineError(
    'not-loaded',
    "The page's policy forbids WebAssembly. Add 'wasm-unsafe-eval' to the script-src of its Content-Security-Policy.",
  );
}
