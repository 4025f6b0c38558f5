/**
 * Bytes per second that one wasm thread reads from memory, in one pass over 256 MB that takes about ten milliseconds.
 */
export type ReadBandwidth = () => number;

interface Exports {
  size(): number;
  fill(): void;
  readAll(): number;
}

export async function bandwidthReader(bytes: BufferSource): Promise<ReadBandwidth> {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const { size, fill, readAll } = instance.exports as unknown as Exports;
  fill();
  readAll(); // the first pass gets the code out of the baseline compiler
  return () => {
    const start = performance.now();
    readAll();
    return size() / ((performance.now() - start) / 1000);
  };
}
