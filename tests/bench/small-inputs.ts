/**
 * Files of at most 100 kB in total that require much work: many equal elements, coincident points, single huge
 * elements, thousands of small ones. Generated deterministically.
 */
import type { InputFile } from '../../web/engine/api/types.ts';

export const MOST_BYTES = 100_000;

export interface SmallInput {
  name: string;
  files: InputFile[];
}

/** Collects as many lines as fit. */
class Text {
  private readonly parts: string[] = [];
  private size = 0;

  constructor(private readonly most: number) {}

  add(text: string): boolean {
    if (this.size + text.length > this.most) return false;
    this.parts.push(text);
    this.size += text.length;
    return true;
  }

  fill(line: (index: number) => string): this {
    for (let index = 0; this.add(line(index)); index += 1);
    return this;
  }

  get bytes(): Uint8Array {
    return new TextEncoder().encode(this.parts.join(''));
  }
}

const HALF = MOST_BYTES / 2;

/** Two poses; `line` receives the index of its pose. */
function obj(name: string, start: (pose: number) => string, line: (index: number, pose: number) => string): SmallInput {
  const files = [0, 1].map((pose) => {
    const text = new Text(HALF);
    text.add(start(pose));
    return { name: `pose${pose}.obj`, bytes: text.fill((index) => line(index, pose)).bytes };
  });
  return { name: `OBJ: ${name}`, files };
}

/** Points on a circle; the second pose raises some of them. */
const circle = (count: number, pose: number): string =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return `v ${Math.round(99 * Math.cos(angle))} ${Math.round(99 * Math.sin(angle))} ${pose * (i % 3)}\n`;
  }).join('');

const TRIANGLE = (pose: number): string => `v 0 0 0\nv 1 0 0\nv 0 1 ${pose}\n`;
const SQUARE = (pose: number): string => `${TRIANGLE(pose)}v 1 1 0\n`;
const one = (pose: number): string => `${TRIANGLE(pose)}f 1 2 3\n`;

/** A grid of squares. */
function grid(size: number, pose: number): string {
  const rows = Array.from(
    { length: size * size },
    (_, i) => `v ${i % size} ${Math.floor(i / size)} ${pose * (i % 5)}\n`,
  );
  for (let y = 0; y + 1 < size; y += 1)
    for (let x = 1; x < size; x += 1)
      rows.push(`f ${y * size + x} ${y * size + x + 1} ${(y + 1) * size + x + 1} ${(y + 1) * size + x}\n`);
  return rows.join('');
}

const OBJ_INPUTS: SmallInput[] = [
  obj('equal triangles', TRIANGLE, () => 'f 1 2 3\n'),
  obj('equal triangles from other corners', TRIANGLE, (i) => ['f 1 2 3\n', 'f 2 3 1\n', 'f 3 1 2\n'][i % 3]!),
  obj('triangles with alternating winding', TRIANGLE, (i) => (i % 2 ? 'f 1 2 3\n' : 'f 3 2 1\n')),
  obj('equal quads', SQUARE, () => 'f 1 2 4 3\n'),
  obj('equal quads, triangulated differently', SQUARE, (_, pose) =>
    pose ? 'f 1 2 4\nf 1 4 3\n' : 'f 1 2 3\nf 2 4 3\n',
  ),
  obj('equal triangles in another order', SQUARE, (i, pose) => ((i + pose) % 2 ? 'f 1 2 3\n' : 'f 2 4 3\n')),
  obj(
    'triangles of the same three places',
    () => '',
    (i, pose) => `${TRIANGLE(pose)}f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3}\n`,
  ),
  obj(
    'identical separate triangles',
    () => '',
    (i, pose) => `v ${i} 0 0\nv ${i} 1 0\nv ${i} 0 ${1 + pose}\nf -3 -2 -1\n`,
  ),
  obj(
    'triangles of the same three places in one pose',
    () => '',
    (i, pose) => `v ${9000 - i * pose} 0 0\nv ${9001 - i * pose} 0 0\nv ${9000 - i * pose} 1 0\nf -3 -2 -1\n`,
  ),
  obj(
    'identical separate tetrahedra',
    () => '',
    (i, pose) =>
      `v ${3 * i} 0 0\nv ${3 * i + 1} 0 0\nv ${3 * i} 1 0\nv ${3 * i} 0 ${1 + pose}\nf -4 -3 -2\nf -4 -2 -1\nf -4 -1 -3\nf -3 -1 -2\n`,
  ),
  obj(
    'faces around one edge',
    () => 'v 0 0 0\nv 0 0 1\n',
    (i, pose) => `v ${i % 97} ${i % 89} ${pose}\nf 1 2 ${i + 3}\n`,
  ),
  obj(
    'faces around one edge of eight points',
    (pose) => circle(10, pose),
    (i) => `f 1 2 ${3 + (i % 8)}\n`,
  ),
  obj(
    'all triangles of thirty points',
    (pose) => circle(30, pose),
    (i) => `f ${1 + (i % 30)} ${1 + ((7 * i + 1) % 29)} ${1 + ((11 * i + 3) % 28)}\n`,
  ),
  obj(
    'a fan around one vertex',
    () => 'v 0 0 1\nv 99 0 0\n',
    (i, pose) => `v ${Math.round(99 * Math.cos(i))} ${Math.round(99 * Math.sin(i))} ${pose}\nf 1 ${i + 2} ${i + 3}\n`,
  ),
  obj(
    'one polygon of a few vertices again and again',
    (pose) => `${SQUARE(pose)}f`,
    (i) => ` ${1 + (i % 4)}`,
  ),
  obj(
    'one polygon',
    (pose) =>
      `${circle(4000, pose)
        .slice(0, 40_000)
        .replace(/v[^\n]*$/, '')}f`,
    (i) => ` ${(i % 2000) + 1}`,
  ),
  obj(
    'polygons of 32 corners',
    (pose) => circle(32, pose),
    () => `f ${Array.from({ length: 32 }, (_, i) => i + 1).join(' ')}\n`,
  ),
  obj(
    'stars of 31 corners',
    (pose) => circle(31, pose),
    () => `f ${Array.from({ length: 31 }, (_, i) => ((13 * i) % 31) + 1).join(' ')}\n`,
  ),
  obj(
    'combs of 32 corners',
    (pose) => Array.from({ length: 32 }, (_, i) => `v ${i} ${i % 2 ? 9 : 0} ${pose * i}\n`).join(''),
    () => `f ${Array.from({ length: 32 }, (_, i) => i + 1).join(' ')}\n`,
  ),
  obj(
    'stars of 33 corners',
    (pose) => circle(33, pose),
    () => `f ${Array.from({ length: 33 }, (_, i) => ((16 * i) % 33) + 1).join(' ')}\n`,
  ),
  obj('vertices at one place', one, () => 'v 0 0 0\n'),
  obj('vertices at two places in one pose, one in the other', one, (i, pose) => `v ${pose * (i % 2)} 0 0\n`),
  obj('loose vertices', one, (i) => `v ${i} ${i % 7} 0\n`),
  obj(
    'vertices almost at one place',
    (pose) => `v 0 0 0\nv 9 0 0\nv 0 9 ${pose}\nf 1 2 3\n`,
    (i) => `v ${(i % 50) / 1e5} ${(i % 7) / 1e5} 0\n`,
  ),
  obj(
    'normals of all kinds at one vertex',
    TRIANGLE,
    (i) => `vn ${i % 97} ${i % 89} ${i % 83}\nf 1//${i + 1} 2//${i + 1} 3//${i + 1}\n`,
  ),
  obj('corners with a coordinate each', TRIANGLE, (i) => `vt ${i / 1e4} 0\nf 1/${i + 1} 2/${i + 1} 3/${i + 1}\n`),
  obj(
    'a chain of triangles',
    () => 'v 0 0 0\nv 0 1 0\n',
    (i, pose) => `v ${i + 1} ${i % 2} ${pose * (i % 3)}\nf -3 -2 -1\n`,
  ),
  obj(
    'a chain of triangles that share vertices',
    () => 'v 0 0 0\n',
    (i, pose) => `v ${i} 1 0\nv ${i + 1} ${pose} 0\nf -3 -2 -1\n`,
  ),
  obj(
    'a grid',
    (pose) => grid(35, pose),
    () => '#\n',
  ),
  obj('materials', one, (i) => `usemtl a${i}\n`),
  obj('materials with a face each', TRIANGLE, (i) => `usemtl a${i}\nf 1 2 3\n`),
  obj('objects with a face each', TRIANGLE, (i) => `o a${i}\nf 1 2 3\n`),
  obj('groups with a face each', TRIANGLE, (i) => `g a${i}\nf 1 2 3\n`),
  obj('material libraries', one, (i) => `mtllib a${i}\n`),
  obj(
    'a line of material libraries',
    (pose) => `${one(pose)}mtllib`,
    (i) => ` a${i}`,
  ),
  obj(
    'a long comment',
    (pose) => `${one(pose)}#`,
    () => '#',
  ),
  obj(
    'a line of spaces',
    (pose) => `${one(pose)}f`,
    () => ' ',
  ),
  obj('empty lines', one, () => '\n'),
  obj(
    'lines that go on',
    (pose) => `${one(pose)}f 1 2 3`,
    () => '\\\n',
  ),
  obj('long numbers', one, () => `v 0.${'1'.repeat(120)} 0 0\n`),
  obj('lines and points', one, () => 'l 1 2\n'),
];

function ply(name: string, header: string, body: (pose: number) => Uint8Array): SmallInput {
  const files = [0, 1].map((pose) => {
    const text = new TextEncoder().encode(`ply\n${header}end_header\n`);
    const bytes = new Uint8Array([...text, ...body(pose)]);
    return { name: `pose${pose}.ply`, bytes };
  });
  return { name: `PLY: ${name}`, files };
}

const XYZ = 'property uchar x\nproperty uchar y\nproperty uchar z\n';
const LITTLE = 'format binary_little_endian 1.0\n';
const points = (count: number, pose: number): number[] =>
  Array.from({ length: count }, (_, i) => [(i * 7) % 250, (i * i) % 240, pose * (i % 5)]).flat();
const bytesOf = (...lists: readonly (readonly number[])[]): Uint8Array => Uint8Array.from(lists.flat());
const repeated = (count: number, of: (index: number) => readonly number[]): number[] =>
  Array.from({ length: count }, (_, i) => of(i)).flat();
/** The length of a list, little endian. */
const counted = (count: number): number[] => [0, 8, 16, 24].map((shift) => (count >> shift) & 255);
const vertexElement = (count: number): string => `element vertex ${count}\n${XYZ}`;
const faceElement = (count: number): string => `element face ${count}\nproperty list uchar uchar vertex_indices\n`;
const faces = (of: (index: number) => readonly number[], count = 12_000) => {
  return (pose: number): Uint8Array =>
    bytesOf(
      points(200, pose),
      repeated(count, (i) => [3, ...of(i)]),
    );
};

const PLY_INPUTS: SmallInput[] = [
  ply(
    'equal triangles',
    LITTLE + vertexElement(200) + faceElement(12_000),
    faces(() => [0, 1, 2]),
  ),
  ply(
    'faces around one edge',
    LITTLE + vertexElement(200) + faceElement(12_000),
    faces((i) => [0, 1, 2 + (i % 198)]),
  ),
  ply(
    'faces around one vertex',
    LITTLE + vertexElement(200) + faceElement(12_000),
    faces((i) => [0, 1 + (i % 198), 2 + (i % 198)]),
  ),
  ply(
    'faces of all points',
    LITTLE + vertexElement(200) + faceElement(12_000),
    faces((i) => [i % 199, (i * 31 + 1) % 200, (i * 57 + 2) % 198]),
  ),
  ply(
    'a strip of three vertices',
    `${LITTLE}${vertexElement(3)}element tristrips 1\nproperty list int uchar vertex_indices\n`,
    (pose) =>
      bytesOf(
        [0, 0, 0, 9, 0, 0, 0, 9, pose],
        counted(49_000),
        repeated(49_000, (i) => [i % 3]),
      ),
  ),
  ply(
    'a strip of all points',
    `${LITTLE}${vertexElement(200)}element tristrips 1\nproperty list int uchar vertex_indices\n`,
    (pose) =>
      bytesOf(
        points(200, pose),
        counted(48_000),
        repeated(48_000, (i) => [(i * 37) % 200]),
      ),
  ),
  ply(
    'properties',
    `format ascii 1.0\nelement vertex 3\n${repeatedText(1900, (i) => `property char p${i}\n`)}${XYZ}${faceElement(1)}`,
    (pose) =>
      new TextEncoder().encode(
        `${'0 '.repeat(1900)}0 0 0\n${'0 '.repeat(1900)}1 0 0\n${'0 '.repeat(1900)}0 1 ${pose}\n3 0 1 2\n`.slice(
          0,
          HALF,
        ),
      ),
  ),
  ply(
    'elements',
    `format ascii 1.0\nelement vertex 3\n${XYZ}${faceElement(1)}${repeatedText(2600, (i) => `element e${i} 0\n`)}`,
    (pose) => new TextEncoder().encode(`0 0 0\n1 0 0\n0 1 ${pose}\n3 0 1 2\n`),
  ),
  ply('comments', `format ascii 1.0\n${'comment\n'.repeat(6000)}element vertex 3\n${XYZ}${faceElement(1)}`, (pose) =>
    new TextEncoder().encode(`0 0 0\n1 0 0\n0 1 ${pose}\n3 0 1 2\n`),
  ),
  ply('one polygon', `${LITTLE}${vertexElement(200)}element face 1\nproperty list int uchar vertex_indices\n`, (pose) =>
    bytesOf(
      points(200, pose),
      counted(48_000),
      repeated(48_000, (i) => [i % 200]),
    ),
  ),
  ply('vertices at one place', `${LITTLE}${vertexElement(16_000)}${faceElement(1)}`, (pose) =>
    bytesOf(
      [0, 0, 0, 9, 0, 0, 0, 9, pose],
      repeated(15_997, () => [0, 0, 0]),
      [3, 0, 1, 2],
    ),
  ),
];

function repeatedText(count: number, of: (index: number) => string): string {
  return Array.from({ length: count }, (_, i) => of(i)).join('');
}

function off(
  name: string,
  counts: (lines: number) => [number, number],
  start: (pose: number) => string,
  line: (index: number, pose: number) => string,
  lines: number,
): SmallInput {
  const [vertices, faceCount] = counts(lines);
  const files = [0, 1].map((pose) => ({
    name: `pose${pose}.off`,
    bytes: new TextEncoder().encode(
      `OFF\n${vertices} ${faceCount} 0\n${start(pose)}${repeatedText(lines, (i) => line(i, pose))}`,
    ),
  }));
  return { name: `OFF: ${name}`, files };
}

const OFF_TRIANGLE = (pose: number): string => `0 0 0\n1 0 0\n0 1 ${pose}\n`;
const OFF_INPUTS: SmallInput[] = [
  off(
    'equal triangles',
    (n) => [3, n],
    OFF_TRIANGLE,
    () => '3 0 1 2\n',
    6200,
  ),
  off(
    'vertices at one place',
    (n) => [n + 2, 1],
    OFF_TRIANGLE,
    (i) => (i === 7999 ? '3 0 1 2\n' : '0 0 0\n'),
    8000,
  ),
  off(
    'faces around one edge',
    (n) => [40, n],
    (pose) => repeatedText(40, (i) => `${i} ${i % 7} ${pose * i}\n`),
    (i) => `3 0 1 ${2 + (i % 38)}\n`,
    5000,
  ),
  off(
    'one polygon',
    () => [4, 1],
    (pose) => `${OFF_TRIANGLE(pose)}1 1 0\n19000`,
    (i) => ` ${i % 4}`,
    24_000,
  ),
];

function gltf(name: string, json: object, bin: Uint8Array): SmallInput {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const [first, second] = [Math.ceil(text.length / 4) * 4, Math.ceil(bin.length / 4) * 4];
  const bytes = new Uint8Array(28 + first + second).fill(0x20);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, first, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  bytes.set(text, 20);
  view.setUint32(20 + first, second, true);
  view.setUint32(24 + first, 0x004e4942, true);
  bytes.fill(0, 28 + first);
  bytes.set(bin, 28 + first);
  return { name: `GLB: ${name}`, files: [{ name: 'shape.glb', bytes }] };
}

/** Points as floats, one morph target, and faces as bytes. */
function mesh(
  pointCount: number,
  indices: readonly number[],
  targets = 1,
): { json: Record<string, unknown>; bin: Uint8Array } {
  const floats = new Float32Array(6 * pointCount);
  points(pointCount, 0).forEach((value, i) => (floats[i] = value));
  points(pointCount, 1).forEach((value, i) => (floats[3 * pointCount + i] = value / 9));
  const bin = new Uint8Array(floats.byteLength + indices.length);
  bin.set(new Uint8Array(floats.buffer));
  bin.set(indices, floats.byteLength);
  const size = 12 * pointCount;
  const position = { componentType: 5126, count: pointCount, type: 'VEC3' };
  const json = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    scene: 0,
    nodes: [{ mesh: 0 }],
    meshes: [
      {
        primitives: [
          {
            attributes: { POSITION: 0 },
            indices: 2,
            targets: Array.from({ length: targets }, () => ({ POSITION: 1 })),
          },
        ],
      },
    ],
    accessors: [
      { ...position, bufferView: 0, min: [0, 0, 0], max: [250, 240, 0] },
      { ...position, bufferView: 1 },
      { bufferView: 2, componentType: 5121, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: size },
      { buffer: 0, byteOffset: size, byteLength: size },
      { buffer: 0, byteOffset: 2 * size, byteLength: indices.length },
    ],
    buffers: [{ byteLength: bin.length }],
  };
  return { json, bin };
}

function glb(
  name: string,
  made: ReturnType<typeof mesh>,
  change: (json: Record<string, unknown>) => object = (json) => json,
): SmallInput {
  return gltf(name, change(made.json), made.bin);
}

const GLTF_INPUTS: SmallInput[] = [
  glb(
    'equal triangles',
    mesh(
      200,
      repeated(31_000, () => [0, 1, 2]),
    ),
  ),
  glb(
    'faces around one edge',
    mesh(
      200,
      repeated(31_000, (i) => [0, 1, 2 + (i % 198)]),
    ),
  ),
  glb(
    'faces of all points',
    mesh(
      200,
      repeated(31_000, (i) => [i % 199, (i * 31 + 1) % 200, (i * 57 + 2) % 198]),
    ),
  ),
  glb(
    'targets',
    mesh(
      200,
      repeated(190, (i) => [i, i + 1, i + 2]),
      5000,
    ),
  ),
  glb(
    'targets of many vertices',
    mesh(
      2000,
      repeated(80, (i) => [i, i + 1, i + 2]),
      2500,
    ),
  ),
  glb(
    'materials',
    mesh(
      200,
      repeated(190, (i) => [i, i + 1, i + 2]),
    ),
    (json) => ({ ...json, materials: Array.from({ length: 16_000 }, () => ({})) }),
  ),
  glb(
    'a deep chain of nodes',
    mesh(
      200,
      repeated(190, (i) => [i, i + 1, i + 2]),
    ),
    (json) => ({
      ...json,
      nodes: Array.from({ length: 3000 }, (_, i) => (i === 2999 ? { mesh: 0 } : { children: [i + 1] })),
    }),
  ),
];

function cache(name: string, frames: number, pointCount: number, kind: 'pc2' | 'mdd'): SmallInput {
  const header = kind === 'pc2' ? 32 : 8 + 4 * frames;
  const bytes = new Uint8Array(header + 12 * frames * pointCount);
  const view = new DataView(bytes.buffer);
  if (kind === 'pc2') {
    bytes.set(new TextEncoder().encode('POINTCACHE2\0'));
    [1, pointCount].forEach((word, i) => view.setUint32(12 + 4 * i, word, true));
    view.setFloat32(24, 1, true);
    view.setUint32(28, frames, true);
  } else {
    view.setUint32(0, frames);
    view.setUint32(4, pointCount);
    for (let f = 0; f < frames; f += 1) view.setFloat32(8 + 4 * f, f / 24);
  }
  for (let i = 0; i < 3 * frames * pointCount; i += 1) view.setFloat32(header + 4 * i, (i * 7) % 100, kind === 'pc2');
  const vertices = repeatedText(pointCount, (i) => `v ${i % 9} ${(i * i) % 7} 0\n`);
  const shape = `${vertices}${repeatedText(Math.min(pointCount - 2, 100), () => 'f 1 2 3\n')}`;
  return {
    name: `${kind.toUpperCase()}: ${name}`,
    files: [
      { name: 'shape.obj', bytes: new TextEncoder().encode(shape) },
      { name: `shape.${kind}`, bytes },
    ],
  };
}

const CACHE_INPUTS: SmallInput[] = (['pc2', 'mdd'] as const).flatMap((kind) => [
  cache('frames', 2000, 3, kind),
  cache('points', 2, 2500, kind),
]);

const TINY = 'v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n';
const FILES_INPUTS: SmallInput[] = [
  {
    name: 'files: poses',
    files: tinyFiles(
      2600,
      (i) => `${i % 2 ? TINY : TINY.replace('1 1\n', '1 0\n')}`,
      (i) => `a${i}b.obj`,
    ),
  },
  {
    name: 'files: frames',
    files: tinyFiles(
      2600,
      () => TINY,
      (i) => `a${i}.obj`,
    ),
  },
  {
    name: 'files: with libraries',
    files: tinyFiles(
      1900,
      (i) => `mtllib ${i}.mtl\n${TINY}`,
      (i) => `a${i}b.obj`,
    ),
  },
  {
    name: 'files: of other kinds',
    files: [
      ...tinyFiles(
        2,
        () => TINY,
        (i) => `a${i}.obj`,
      ),
      ...tinyFiles(
        9000,
        () => 'x',
        (i) => `a${i}.dat`,
      ),
    ],
  },
];

function tinyFiles(count: number, text: (index: number) => string, name: (index: number) => string): InputFile[] {
  return Array.from({ length: count }, (_, i) => ({ name: name(i), bytes: new TextEncoder().encode(text(i)) }));
}

export const SMALL_INPUTS: SmallInput[] = [
  ...OBJ_INPUTS,
  ...PLY_INPUTS,
  ...OFF_INPUTS,
  ...GLTF_INPUTS,
  ...CACHE_INPUTS,
  ...FILES_INPUTS,
];
