/**
 * Reads and writes the wasm heap. Views exist only inside these functions, because any call into the module may grow
 * the memory.
 */
import { outOfMemory } from '../api/errors.ts';
import type { Address, WasmModule } from './wasm-module.ts';

/** A range of the heap as written by the bindings; `length` counts elements. */
export interface Range {
  address: Address;
  length: number;
}

type NumberArray = Uint8Array | Int32Array | Uint32Array | Float32Array;

/** Element types of the ranges in the bindings' JSON, by name. */
const ARRAYS = {
  bytes: Uint8Array,
  faces: Uint32Array,
  indices: Uint32Array,
  copyOf: Int32Array,
  vertexOf: Int32Array,
  ghostVertexOf: Int32Array,
  ghostFaceOf: Int32Array,
  patchOf: Int32Array,
  componentOf: Int32Array,
  order: Int32Array,
  positions: Float32Array,
  shapes: Float32Array,
  normals: Float32Array,
  uvs: Float32Array,
  offsets: Float32Array,
  weights: Float32Array,
  polygons: Int32Array,
  colors: Float32Array,
};

const encoder = new TextEncoder();
const decoder = new TextDecoder();

function bytesOf(array: NumberArray): Uint8Array {
  return new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
}

const isRange = (value: unknown): value is Range => typeof value === 'object' && value !== null && 'address' in value;

/** Parses the bindings' JSON and replaces ranges by copies of their data. */
export function readJson(module: WasmModule, text: string): unknown {
  return JSON.parse(text, (name, value: unknown) => {
    if (!isRange(value)) return value;
    const ArrayType = ARRAYS[name as keyof typeof ARRAYS];
    const start = value.address >>> 0;
    return new ArrayType(module.HEAPU8.slice(start, start + value.length * ArrayType.BYTES_PER_ELEMENT).buffer);
  });
}

/** Copies a range, into `target` if its length matches. */
export function readFloats(module: WasmModule, { address, length }: Range, target?: Float32Array | null): Float32Array {
  const copy = target?.length === length ? target : new Float32Array(length);
  copy.set(new Float32Array(module.HEAPU8.buffer, address >>> 0, length));
  return copy;
}

/** Text up to its NUL. */
export function readText(module: WasmModule, address: Address): string {
  const start = address >>> 0;
  return decoder.decode(module.HEAPU8.slice(start, module.HEAPU8.indexOf(0, start)));
}

export function writeFloats(module: WasmModule, address: Address, numbers: Float32Array): void {
  module.HEAPU8.set(bytesOf(numbers), address >>> 0);
}

/** Heap memory for one call. `free` frees all of it. */
export class HeapScope {
  private readonly addresses: Address[] = [];
  private readonly module: WasmModule;

  constructor(module: WasmModule) {
    this.module = module;
  }

  /** Writes JSON; arrays are copied into the heap and replaced by their ranges. */
  putJson(value: object): Address {
    return this.putText(
      JSON.stringify(value, (_, part: unknown) => (ArrayBuffer.isView(part) ? this.put(part as NumberArray) : part)),
    );
  }

  putText(text: string): Address {
    return this.write(encoder.encode(`${text}\0`));
  }

  free(): void {
    for (const address of this.addresses) this.module._free(address);
    this.addresses.length = 0;
  }

  private put(array: NumberArray): Range {
    return { address: this.write(bytesOf(array)), length: array.length };
  }

  private write(bytes: Uint8Array): Address {
    const address = this.module._malloc(Math.max(1, bytes.length)) >>> 0;
    if (address === 0) throw outOfMemory();
    this.addresses.push(address);
    this.module.HEAPU8.set(bytes, address);
    return address;
  }
}
