/** Sets a compiled wasm module's memory limit in its bytes. */

const PAGE = 2 ** 16;
const MEMORY_SECTION = 5;
const HAS_MAX = 1;

/** An unsigned LEB128 number, and the position of the next byte. */
function readNumber(bytes: Uint8Array, at: number): { value: number; next: number } {
  let [value, scale, next] = [0, 1, at];
  for (;;) {
    const byte = bytes[next++] ?? 0;
    value += (byte & 0x7f) * scale;
    if (byte < 0x80) return { value, next };
    scale *= 128;
  }
}

/** Fills exactly the bytes from `start` to `end`, padding the number with leading zeros. */
function writeNumber(bytes: Uint8Array, value: number, start: number, end: number): void {
  for (let at = start; at < end; ++at) {
    bytes[at] = (value % 128) | (at + 1 < end ? 0x80 : 0);
    value = Math.floor(value / 128);
  }
}

/** A copy of the module whose memory cannot exceed this number of bytes, unless it starts with more. */
export function withMemoryLimit(module: Uint8Array, bytes: number): Uint8Array {
  const limited = module.slice();
  for (let at = 8; at < limited.length; ) {
    const id = limited[at];
    const size = readNumber(limited, at + 1);
    if (id === MEMORY_SECTION) {
      const flags = readNumber(limited, readNumber(limited, size.next).next);
      const least = readNumber(limited, flags.next);
      if ((flags.value & HAS_MAX) === 0) return limited;
      const most = readNumber(limited, least.next);
      const wanted = Math.max(Math.ceil(bytes / PAGE), least.value);
      writeNumber(limited, Math.min(wanted, most.value), least.next, most.next);
      return limited;
    }
    at = size.next + size.value;
  }
  return limited;
}
