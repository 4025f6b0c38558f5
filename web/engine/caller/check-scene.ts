/** Checks the scene of `createKeys` before drawing and exports rely on it. Loaded on demand. */
import { invalidOption } from '../api/errors.ts';
import { isObject, isRecord } from '../api/options.ts';
import type { Material, Scene } from '../api/types.ts';

/** Counts that bound the indices of a scene. */
interface Counts {
  vertices: number;
  /** Vertices and their copies at seams. */
  drawn: number;
  faces: number;
  materials: number;
  images: number;
}

/** The faces and the number of vertices of the mesh. */
interface Mesh {
  faces: Uint32Array;
  vertices: number;
}

/** What a value must be, and whether it is. */
type Rule = readonly [must: string, isMet: (value: unknown) => boolean];

const isNumber: (value: unknown) => boolean = Number.isFinite;
const isIndex = (value: unknown, count: number): boolean =>
  Number.isInteger(value) && (value as number) >= 0 && (value as number) < count;
const number: Rule = ['a number', isNumber];
const text: Rule = ['a string', (v) => typeof v === 'string'];
const flag: Rule = ['true or false', (v) => typeof v === 'boolean'];
const choice = (...words: string[]): Rule => [`one of ${words.join(', ')}`, (v) => words.includes(v as string)];
const numbers = (count: number): Rule => [
  `${count} numbers`,
  (v) => Array.isArray(v) && v.length === count && v.every(isNumber),
];
const indexOrNone = (count: number): Rule => [`an index below ${count}, or -1`, (v) => v === -1 || isIndex(v, count)];
const floats = (each: number, count: number): Rule => [
  `null or a Float32Array of ${each * count} finite numbers`,
  (v) => v === null || (v instanceof Float32Array && v.length === each * count && v.every(isNumber)),
];
const wrap = choice('repeat', 'clamp', 'mirror');
const filter: Rule = ['a whole number of at least 0', (v) => isIndex(v, Infinity)];

const materialRules = (images: number): Record<keyof Material, Rule> => ({
  name: text,
  baseColor: numbers(4),
  metallic: number,
  roughness: number,
  doubleSided: flag,
  alphaMode: choice('OPAQUE', 'MASK', 'BLEND'),
  alphaCutoff: number,
  unlit: flag,
  emissive: numbers(3),
  normalScale: number,
  occlusionStrength: number,
  baseColorImage: indexOrNone(images),
  metallicRoughnessImage: indexOrNone(images),
  normalImage: indexOrNone(images),
  occlusionImage: indexOrNone(images),
  emissiveImage: indexOrNone(images),
  wrapS: wrap,
  wrapT: wrap,
  magFilter: filter,
  minFilter: filter,
});

const imageRules = {
  mimeType: ["a type such as 'image/png'", (v) => typeof v === 'string' && v.startsWith('image/')],
  bytes: ['a Uint8Array', (v) => v instanceof Uint8Array],
  scale: number,
} satisfies Record<string, Rule>;

/** Whether the range lies within the faces. */
const isRange = (v: { start: number; count: number }, faces: number): boolean =>
  isIndex(v.start, faces + 1) && isIndex(v.count, faces - v.start + 1);

function isGroup(v: unknown, { faces, materials }: Counts): boolean {
  if (!isRecord(v) || !isRange(v as never, faces)) return false;
  return indexOrNone(materials)[1](v['material']) && (v['name'] === undefined || typeof v['name'] === 'string');
}

function areSeams(v: unknown, { faces, vertices }: Mesh): boolean {
  if (v === null) return true;
  const { copyOf, indices } = (v ?? {}) as Partial<NonNullable<Scene['seams']>>;
  if (!(copyOf instanceof Int32Array) || !(indices instanceof Uint32Array)) return false;
  const vertexOf = (drawn: number): number | undefined => (drawn < vertices ? drawn : copyOf[drawn - vertices]);
  return (
    copyOf.every((vertex) => isIndex(vertex, vertices)) &&
    indices.length === faces.length &&
    indices.every((drawn, corner) => vertexOf(drawn) === faces[corner])
  );
}

const sceneRules = (counts: Counts, mesh: Mesh): Record<keyof Scene, Rule> => ({
  seams: [
    'null or { copyOf: Int32Array of vertices, indices: Uint32Array of the same faces with copies of their vertices }',
    (v) => areSeams(v, mesh),
  ],
  uvs: floats(2, counts.drawn),
  colors: floats(4, counts.vertices),
  polygons: [
    `null or an Int32Array of positive numbers with the sum ${counts.faces}`,
    (v) =>
      v === null ||
      (v instanceof Int32Array && v.every((n) => n > 0) && v.reduce((sum, n) => sum + n, 0) === counts.faces),
  ],
  groups: [
    `an array of { start, count, material } within ${counts.faces} faces and ${counts.materials} materials`,
    (v) => Array.isArray(v) && v.every((group) => isGroup(group, counts)),
  ],
  materials: ['an array', Array.isArray],
  images: ['an array', Array.isArray],
  objects: [
    `absent or objects as in an import, within ${counts.faces} faces`,
    (v) => v === undefined || (Array.isArray(v) && v.every((one) => isObject(one) && isRange(one, counts.faces))),
  ],
});

function check(what: string, value: unknown, rules: Readonly<Record<string, Rule>>): void {
  if (!isRecord(value)) throw invalidOption(`${what} must be an object with ${Object.keys(rules).join(', ')}.`);
  for (const [name, [must, isMet]] of Object.entries(rules))
    if (!isMet(value[name])) throw invalidOption(`${what}.${name} must be ${must}.`);
}

export function checkScene(scene: Scene, mesh: Mesh): void {
  const { seams, materials, images } = (scene ?? {}) as Partial<Scene>;
  const counts: Counts = {
    vertices: mesh.vertices,
    drawn: mesh.vertices + (seams?.copyOf?.length ?? 0),
    faces: mesh.faces.length / 3,
    materials: materials?.length ?? 0,
    images: images?.length ?? 0,
  };
  check('scene', scene, sceneRules(counts, mesh));
  for (const [i, one] of scene.materials.entries()) check(`scene.materials[${i}]`, one, materialRules(counts.images));
  for (const [i, one] of scene.images.entries()) check(`scene.images[${i}]`, one, imageRules);
}
