/**
 * Checks the declared sizes of a glTF file with compressed meshes before decoding: sizes must be in proportion to the
 * bytes, and nodes must form a forest. The decoders do not check this.
 */
import { EngineError } from '../api/errors.ts';

/**
 * Largest ratio of decoded to stored bytes; the limit for small files and for all files, in bytes. Whole morph targets
 * of zeros need few bytes.
 */
const LARGEST_RATIO = 1024;
const SMALL = 64 * 2 ** 20;
const LARGEST = 2 ** 30;

/** Decoded bytes allowed for this number of stored bytes. */
export const roomFor = (bytes: number): number => Math.min(Math.max(SMALL, LARGEST_RATIO * bytes), LARGEST);

/**
 * Largest decoded size per stored byte, for each meshopt codec. One byte encodes a block of vertices, a triangle, or an
 * index.
 */
const MESHOPT_RATIO: Record<string, number> = { ATTRIBUTES: 1024, TRIANGLES: 12, INDICES: 4 };

type Json = Record<string, unknown>;

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null;
const listOf = (json: Json, name: string): Json[] =>
  Array.isArray(json[name]) ? json[name].map((one: unknown) => (isObject(one) ? one : {})) : [];
const isSize = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;

/** Throws if a file of this total size must not be decoded. */
export function checkDecodedSize(json: unknown, bytes: number, name: string): void {
  const document = isObject(json) ? json : {};
  const sizes = [
    ...listOf(document, 'bufferViews').map(meshoptSize),
    ...listOf(document, 'accessors').map(accessorSize),
    ...listOf(document, 'images').map((image) => viewSize(document, image)),
  ];
  const room = roomFor(bytes);
  if (sizes.reduce((sum, size) => sum + size, 0) <= room) return;
  const megabytes = Math.round(room / 1e6).toLocaleString('en');
  throw new EngineError(
    'too-large',
    `${name} expands to more than the ${megabytes} MB allowed for a file of its size. Export the file again, or without compression.`,
    { file: name },
  );
}

/** Decoded size of a meshopt view; otherwise 0, because other views are bytes of the file itself. */
function meshoptSize(view: Json, index: number): number {
  const extension = isObject(view['extensions']) ? view['extensions']['EXT_meshopt_compression'] : undefined;
  if (!isObject(extension)) return 0;
  const { count, byteStride, byteLength, mode = 'ATTRIBUTES' } = extension;
  const ratio = MESHOPT_RATIO[String(mode)];
  if (!isSize(count) || !isSize(byteStride) || !isSize(byteLength) || byteStride > 256 || ratio === undefined)
    throw new Error(`bufferView ${index} has a size that is invalid for meshopt`);
  if (count * byteStride > ratio * byteLength)
    throw new Error(`bufferView ${index} declares more than its ${byteLength} bytes can hold`);
  return count * byteStride;
}

/** Size of an embedded image, which is copied out of its view. */
function viewSize(document: Json, { bufferView }: Json): number {
  const views = document['bufferViews'];
  const view: unknown = Array.isArray(views) && isSize(bufferView) ? views[bufferView] : undefined;
  return isObject(view) && isSize(view['byteLength']) ? view['byteLength'] : 0;
}

const COMPONENTS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };

/** Size when copied out of its view. Views can be shared, so a small file could declare any amount. */
function accessorSize({ count = 0, type, componentType }: Json, index: number): number {
  const components = COMPONENTS[String(type)];
  if (!isSize(count) || components === undefined) throw new Error(`accessor ${index} has no count or type`);
  const width =
    componentType === 5126 || componentType === 5125 ? 4 : componentType === 5122 || componentType === 5123 ? 2 : 1;
  return count * components * width;
}

/** Throws the start of a sentence if a compressed primitive has no buffer view in the file. */
export function checkCompressedViews(json: unknown): void {
  const document = isObject(json) ? json : {};
  const views = listOf(document, 'bufferViews').length;
  for (const [m, mesh] of listOf(document, 'meshes').entries())
    for (const [p, { extensions }] of listOf(mesh, 'primitives').entries()) {
      const draco = isObject(extensions) ? extensions['KHR_draco_mesh_compression'] : undefined;
      if (draco === undefined) continue;
      const view = isObject(draco) ? draco['bufferView'] : undefined;
      if (!isSize(view) || view >= views)
        throw new Error(`mesh ${m}, primitive ${p} refers to buffer view ${Number(view)}, which does not exist`);
    }
}

/** Throws the start of a sentence if the nodes are not a forest. Later code would not notice, or not terminate. */
export function checkForest(json: unknown): void {
  const nodes = listOf(isObject(json) ? json : {}, 'nodes');
  const parent = new Int32Array(nodes.length).fill(-1);
  for (const [index, { children }] of nodes.entries()) {
    for (const child of (Array.isArray(children) ? children : []) as unknown[]) {
      if (!isSize(child) || child >= nodes.length)
        throw new Error(`node ${index} has child ${JSON.stringify(child)}, which does not exist`);
      if (child === index) throw new Error(`node ${index} is its own child, so the nodes are not a tree`);
      if (parent[child] !== -1) throw new Error(`node ${child} has two parents, so the nodes are not a tree`);
      parent[child] = index;
    }
  }
  // Each node has at most one parent, so a node that no root reaches lies on a cycle.
  const waiting = nodes.flatMap((_, index) => (parent[index] === -1 ? [index] : []));
  let reached = 0;
  for (let node = waiting.pop(); node !== undefined; node = waiting.pop()) {
    reached += 1;
    const { children } = nodes[node]!;
    if (Array.isArray(children)) for (const child of children as number[]) waiting.push(child);
  }
  if (reached < nodes.length) throw new Error('its nodes form a cycle');
}
