/** Bytes a second that one thread of wasm reads from memory, best of a few passes; measured where nothing else runs. */
const PASSES = 5;

interface Exports {
  size(): number;
  fill(): void;
  readAll(): number;
}

export async function readBandwidth(bytes: BufferSource): Promise<number> {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const { size, fill, readAll } = instance.exports as unknown as Exports;
  fill();
  readAll();  // leaves the baseline compiler
  let best = Infinity;
  for (let pass = 0; pass < PASSES; ++pass) {
    const start = performance.now();
    readAll();
    best = Math.min(best, performance.now() - start);
  }
  return size() / (best / 1000);
}
