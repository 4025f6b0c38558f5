/** Bytes a second that one thread of wasm reads from memory: the best of a few passes, whenever it is asked. */
export type ReadBandwidth = () => number;

const PASSES = 3;

interface Exports {
  size(): number;
  fill(): void;
  readAll(): number;
}

export async function bandwidthReader(bytes: BufferSource): Promise<ReadBandwidth> {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const { size, fill, readAll } = instance.exports as unknown as Exports;
  fill();
  readAll();  // leaves the baseline compiler
  return () => {
    let best = Infinity;
    for (let pass = 0; pass < PASSES; ++pass) {
      const start = performance.now();
      readAll();
      best = Math.min(best, performance.now() - start);
    }
    return size() / (best / 1000);
  };
}
