/** Bytes a second that one thread of wasm reads from memory, in one pass over 256 MB: some ten milliseconds. */
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
  readAll(); // leaves the baseline compiler
  return () => {
    const start = performance.now();
    readAll();
    return size() / ((performance.now() - start) / 1000);
  };
}
