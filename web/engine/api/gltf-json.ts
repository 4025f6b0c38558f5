/**
 * Parses the JSON of a glTF file after checking its size, because a few bytes of text can need much memory.
 * wasm/io/base/limits has the same limits and reports the exceeded one.
 */
const DEEPEST = 100;
const MAX_OBJECTS = 250_000;
const MAX_VALUES = 4_000_000;

const [QUOTE, BACKSLASH, COMMA] = [0x22, 0x5c, 0x2c];
const [OPEN_LIST, CLOSE_LIST, OPEN_OBJECT, CLOSE_OBJECT] = [0x5b, 0x5d, 0x7b, 0x7d];

function fitsInMemory(text: string): boolean {
  let [depth, objects, values, inString] = [0, 0, 0, false];
  for (let i = 0; i < text.length; ++i) {
    const c = text.charCodeAt(i);
    if (inString) {
      if (c === BACKSLASH) ++i;
      else if (c === QUOTE) inString = false;
    } else if (c === QUOTE) inString = true;
    else if (c === COMMA) ++values;
    else if (c === CLOSE_LIST || c === CLOSE_OBJECT) --depth;
    else if (c === OPEN_LIST || c === OPEN_OBJECT) {
      if (++depth > DEEPEST) return false;
      ++values;
      if (c === OPEN_OBJECT) ++objects;
    }
    if (objects > MAX_OBJECTS || values > MAX_VALUES) return false;
  }
  return true;
}

/** The parsed JSON; undefined if broken or too large. The core reads the same text and reports the error. */
export function parseGltf(text: string): unknown {
  if (!fitsInMemory(text)) return undefined;
  try {
    return JSON.parse(text.replace(/^\uFEFF/, '')) as unknown;
  } catch {
    return undefined;
  }
}
