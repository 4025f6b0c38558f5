/** Random changes of GLB files, in their bytes or in the numbers of their JSON, that keep most of the file. */

/** Numbers in [0, 1), the same for the same seed (mulberry32). */
export function randomNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const NUMBERS = [
  0,
  1,
  2,
  3,
  4,
  7,
  16,
  255,
  256,
  65_535,
  65_536,
  1e6,
  2 ** 31 - 1,
  2 ** 31,
  2 ** 32,
  2 ** 53,
  1e300,
  -1,
  0.5,
];
const JSON_START = 20;

export function mutated(glb: Uint8Array, random: () => number): Uint8Array {
  const below = (count: number): number => Math.floor(random() * count);
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  let json = new TextDecoder().decode(glb.subarray(JSON_START, JSON_START + length));
  let binary = Array.from(glb.subarray(JSON_START + length + 8));
  for (let changes = 1 + below(4); changes > 0; --changes) {
    const kind = below(8);
    const at = below(binary.length);
    if (kind < 2) json = withNumber(json, below, kind === 0 ? NUMBERS[below(NUMBERS.length)]! : below(300));
    else if (kind < 5) binary[at] = below(256);
    else if (kind === 5) binary[at]! ^= 1 << below(8);
    else if (kind === 6) binary.splice(at, 1 + below(8), ...Array.from({ length: below(8) }, () => below(256)));
    // For Draco and meshopt, the most important bytes come first.
    else binary[below(Math.min(binary.length, 40))] = below(256);
  }
  if (below(20) === 0) binary = binary.slice(0, below(binary.length));
  return glbOf(json, Uint8Array.from(binary));
}

/** Changes one of the JSON's numbers. */
function withNumber(json: string, below: (count: number) => number, value: number): string {
  const numbers = [...json.matchAll(/(?<=[:,[])-?\d+(?:\.\d+)?(?=[,\]}])/g)];
  const { index, 0: text } = numbers[below(numbers.length)]!;
  return `${json.slice(0, index)}${value}${json.slice(index + text.length)}`;
}

function glbOf(json: string, binary: Uint8Array): Uint8Array {
  const padded = json.trimEnd().padEnd(Math.ceil(json.trimEnd().length / 4) * 4);
  const text = new TextEncoder().encode(padded);
  const bytes = new Uint8Array(JSON_START + text.length + 8 + binary.length);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, text.length, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  bytes.set(text, JSON_START);
  view.setUint32(JSON_START + text.length, binary.length, true);
  view.setUint32(JSON_START + text.length + 4, 0x004e4942, true);
  bytes.set(binary, JSON_START + text.length + 8);
  return bytes;
}
