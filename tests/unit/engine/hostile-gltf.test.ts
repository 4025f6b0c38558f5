import { describe, expect, it } from 'vitest';
import { parseGltf } from '../../../web/engine/api/gltf-json.ts';
import { checkImportSize } from '../../../web/engine/api/import-size.ts';
import {
  checkCompressedViews,
  checkDecodedSize,
  checkForest,
  roomFor,
} from '../../../web/engine/worker/decoded-size.ts';
import { withMemoryLimit } from '../../../web/engine/worker/wasm-memory.ts';

const meshopt = (count: number, byteStride: number, byteLength: number, mode: string | undefined = undefined) => ({
  bufferViews: [
    { extensions: { EXT_meshopt_compression: { count, byteStride, byteLength, ...(mode ? { mode } : {}) } } },
  ],
});
const accessors = (count: number, copies = 1) => ({
  accessors: Array.from({ length: copies }, () => ({ count, type: 'VEC3', componentType: 5126, bufferView: 0 })),
});
const size = (json: object, bytes: number) => () => checkDecodedSize(json, bytes, 'a.glb');

describe('the JSON of a glTF', () => {
  it('is parsed, or undefined if it is broken', () => {
    expect(parseGltf('\uFEFF{"a":["}]\\"[{",1]}')).toEqual({ a: ['}]"[{', 1] });
    for (const broken of ['{', '', '{"a":}', '["\\']) expect(parseGltf(broken)).toBeUndefined();
  });

  it('is measured before it is parsed', () => {
    expect(parseGltf(`${'['.repeat(100)}${']'.repeat(100)}`)).toBeDefined();
    expect(parseGltf(`${'['.repeat(101)}${']'.repeat(101)}`)).toBeUndefined();
    expect(parseGltf('['.repeat(40e6))).toBeUndefined();
    expect(parseGltf(`[${'{},'.repeat(249_999)}{}]`)).toBeDefined();
    expect(parseGltf(`[${'{},'.repeat(250_000)}{}]`)).toBeUndefined();
    expect(parseGltf(`[${'1,'.repeat(4e6)}1]`)).toBeUndefined();
  });
});

describe('the decoded size of a compressed file', () => {
  it('is limited in proportion to its bytes', () => {
    expect([roomFor(100), roomFor(1e6), roomFor(1e9)]).toEqual([64 * 2 ** 20, 1024e6, 2 ** 30]);
    expect(size(accessors(5e6), 1000)).not.toThrow();
    expect(size(accessors(6e6), 1000)).toThrow('a.glb expands to more than the 67 MB allowed for a file of its size');
    expect(size(accessors(5e4, 1000), 1000)).toThrow('expands to more');
    expect(size({ bufferViews: [{ byteLength: 1e6 }], images: new Array(100).fill({ bufferView: 0 }) }, 1000)).toThrow(
      'expands to more',
    );
    expect(size(meshopt(16e6, 12, 1e6), 1e6)).not.toThrow();
  });

  it.each([
    ['what its codec cannot hold', meshopt(2e8, 12, 500)],
    ['triangles without bytes', meshopt(3e4, 4, 100, 'TRIANGLES')],
    ['indices without bytes', meshopt(1e4, 4, 100, 'INDICES')],
    ['a negative count', meshopt(-1, 4, 100)],
    ['a count that is none', meshopt(1.5, 4, 100)],
    ['a stride that is none', meshopt(1, 1e9, 1e9)],
    ['an unknown codec', meshopt(1, 4, 100, 'OTHER')],
    ['an accessor without a count', { accessors: [{ count: -1, type: 'VEC3' }] }],
    ['an accessor without a type', { accessors: [{ count: 1, type: 'VEC5' }] }],
  ])('is refused where it declares %s', (_what, json) => {
    expect(size(json, 1e9)).toThrow(/^(bufferView|accessor) 0 /);
  });

  it('must be a forest', () => {
    const nodes = (...children: unknown[]) => ({ nodes: children.map((list) => ({ children: list })) });
    for (const good of [{}, nodes([1, 2], [], [3], undefined), nodes(undefined, [0])])
      expect(() => checkForest(good)).not.toThrow();
    expect(() => checkForest(nodes([0]))).toThrow('node 0 is its own child');
    expect(() => checkForest(nodes([2], [2], []))).toThrow('node 2 has two parents');
    expect(() => checkForest(nodes([1, 1], []))).toThrow('node 1 has two parents');
    expect(() => checkForest(nodes([], [2], [1]))).toThrow('form a cycle');
    for (const child of [-1, 5, 0.5, 'x', null])
      expect(() => checkForest(nodes([child]))).toThrow('which does not exist');
  });
});

it('files are refused by their size', () => {
  expect(() => checkImportSize(2 ** 30)).not.toThrow();
  expect(() => checkImportSize(1.9e9)).toThrow('The files are 1.90 GB in total, but at most 1.07 GB');
});

describe('the memory of a wasm module', () => {
  // Header, an empty type section, and a memory of 2 to 32768 pages.
  const module = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 1, 0, 5, 6, 1, 1, 2, 0x80, 0x80, 2);

  it.each([
    [100 * 2 ** 16, 100],
    [2 ** 16, 2],
  ])('is at most %i bytes, and at least what it starts with', (bytes, pages) => {
    const limited = withMemoryLimit(module, bytes);
    expect(limited).not.toBe(module);
    expect(WebAssembly.validate(limited as Uint8Array<ArrayBuffer>)).toBe(true);
    const most = limited.slice(-3);
    expect((most[0]! & 0x7f) + 128 * (most[1]! & 0x7f) + 128 ** 2 * most[2]!).toBe(pages);
  });

  it('is never increased', () => {
    expect(withMemoryLimit(module, 2 ** 33)).toEqual(module);
  });

  it('of a module without one is unchanged', () => {
    expect(withMemoryLimit(module.slice(0, 11), 1)).toEqual(module.slice(0, 11));
  });

  it('refuses primitives that are compressed into no buffer view', () => {
    const mesh = (bufferView: unknown): object => ({
      bufferViews: [{}, {}],
      meshes: [{ primitives: [{}, { extensions: { KHR_draco_mesh_compression: { bufferView } } }] }],
    });
    expect(() => checkCompressedViews(mesh(1))).not.toThrow();
    for (const view of [2, 255, -1, 2 ** 40])
      expect(() => checkCompressedViews(mesh(view))).toThrow(
        `mesh 0, primitive 1 refers to buffer view ${view}, which does not exist`,
      );
  });
});
