/**
 * Writes the corpus: small valid and broken files of every format of the importers; broken ones are named after their
 * defect. Run it by hand after a change (`node tests/fuzz/corpus/make.mjs`), and commit the files.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = path.dirname(fileURLToPath(import.meta.url));

function write(folder, name, content) {
  mkdirSync(path.join(root, folder), { recursive: true });
  writeFileSync(path.join(root, folder, name), content);
}

// --- glTF ---------------------------------------------------------------------------------------

const floats = (...values) => Buffer.from(new Float32Array(values.flat()).buffer);
const shorts = (...values) => Buffer.from(new Uint16Array(values.flat()).buffer);
const bytes = (...values) => Buffer.from(values.flat());
const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/** A document under construction: one buffer, and accessors with a view each. */
class Maker {
  doc = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [], meshes: [], accessors: [], bufferViews: [] };
  bin = Buffer.alloc(0);

  view(content) {
    const padding = (4 - (this.bin.length % 4)) % 4;
    this.bin = Buffer.concat([this.bin, Buffer.alloc(padding), content]);
    return this.doc.bufferViews.push({ buffer: 0, byteOffset: this.bin.length - content.length, byteLength: content.length }) - 1;
  }

  accessor(content, count, type, componentType, more = {}) {
    return this.doc.accessors.push({ bufferView: this.view(content), componentType, count, type, ...more }) - 1;
  }

  animate(channels) {
    const animation = { samplers: [], channels: [] };
    for (const { node, path: target, input, output, interpolation = 'LINEAR' } of channels) {
      const sampler = animation.samplers.push({ input, output, interpolation }) - 1;
      animation.channels.push({ sampler, target: { node, path: target } });
    }
    (this.doc.animations ??= []).push(animation);
  }

  text() {
    const buffers = this.doc.buffers ?? [{ byteLength: this.bin.length, uri: `data:application/octet-stream;base64,${this.bin.toString('base64')}` }];
    return JSON.stringify({ ...this.doc, buffers });
  }

  glb() {
    const pad = (buffer, filler) => Buffer.concat([buffer, Buffer.alloc((4 - (buffer.length % 4)) % 4, filler)]);
    const json = pad(Buffer.from(JSON.stringify({ ...this.doc, buffers: [{ byteLength: this.bin.length }] })), ' ');
    const bin = pad(this.bin, 0);
    const words = (...values) => Buffer.from(new Uint32Array(values).buffer);
    return Buffer.concat([Buffer.from('glTF'), words(2, 28 + json.length + bin.length, json.length), Buffer.from('JSON'), json,
      words(bin.length), Buffer.from('BIN\x00'), bin]);
  }
}

function tetrahedron() {
  const maker = new Maker();
  const POSITION = maker.accessor(floats(points), 4, 'VEC3', 5126);
  const indices = maker.accessor(shorts(faces), 12, 'SCALAR', 5123);
  maker.doc.meshes.push({ primitives: [{ attributes: { POSITION }, indices }] });
  maker.doc.nodes.push({ mesh: 0 });
  return maker;
}

function morphing() {
  const maker = tetrahedron();
  const target = maker.accessor(floats(points.map(([x, y, z]) => [x + z, y, z - x])), 4, 'VEC3', 5126);
  maker.doc.meshes[0].primitives[0].targets = [{ POSITION: target }];
  maker.doc.meshes[0].extras = { targetNames: ['lean'] };
  return maker;
}

function skinned() {
  const maker = tetrahedron();
  const attributes = maker.doc.meshes[0].primitives[0].attributes;
  attributes.JOINTS_0 = maker.accessor(bytes([0, 1, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [1, 0, 0, 0]), 4, 'VEC4', 5121);
  attributes.WEIGHTS_0 = maker.accessor(bytes([255, 0, 0, 0], [128, 127, 0, 0], [200, 55, 0, 0], [255, 0, 0, 0]), 4, 'VEC4', 5121, { normalized: true });
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const inverseBindMatrices = maker.accessor(floats(identity, identity), 2, 'MAT4', 5126);
  maker.doc.nodes[0].skin = 0;
  maker.doc.nodes.push({ children: [2] }, { translation: [0, 0, 1] });
  maker.doc.scenes[0].nodes.push(1);
  maker.doc.skins = [{ joints: [1, 2], inverseBindMatrices }];
  const input = maker.accessor(floats(0, 1, 2), 3, 'SCALAR', 5126);
  const turn = maker.accessor(floats([0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]), 3, 'VEC4', 5126);
  const cubic = maker.accessor(floats(Array.from({ length: 27 }, (_, i) => i / 9)), 9, 'VEC3', 5126);
  maker.animate([{ node: 1, path: 'rotation', input, output: turn }, { node: 2, path: 'translation', input, output: cubic, interpolation: 'CUBICSPLINE' },
    { node: 2, path: 'scale', input, output: cubic, interpolation: 'STEP' }]);
  return maker;
}

function weights(maker = morphing()) {
  const input = maker.accessor(floats(0, 0.5, 2), 3, 'SCALAR', 5126);
  const output = maker.accessor(floats(0, 1, 0.25), 3, 'SCALAR', 5126);
  maker.animate([{ node: 0, path: 'weights', input, output }]);
  return maker;
}

function sparse() {
  const maker = morphing();
  const places = maker.view(bytes([1, 3])), values = maker.view(floats([5, 5, 5], [6, 6, 6]));
  const target = maker.doc.accessors[2];
  delete target.bufferView;
  target.sparse = { count: 2, indices: { bufferView: places, componentType: 5121 }, values: { bufferView: values } };
  return maker;
}

function painted() {
  const maker = tetrahedron();
  const primitive = maker.doc.meshes[0].primitives[0];
  primitive.material = 0;
  primitive.attributes.TEXCOORD_0 = maker.accessor(shorts([0, 65535, 0, 0, 65535, 0, 65535, 65535]), 4, 'VEC2', 5123, { normalized: true });
  primitive.attributes.COLOR_0 = maker.accessor(bytes(Array(16).fill(127)), 4, 'VEC4', 5121, { normalized: true });
  primitive.attributes.NORMAL = maker.accessor(floats([0, 0, 1], [0, 0, 1], [0, 0, 1], [0, 0, 1]), 4, 'VEC3', 5126);
  maker.doc.images = [{ bufferView: maker.view(Buffer.from('\x89PNG\r\n\x1a\n....', 'latin1')), mimeType: 'image/png' }];
  maker.doc.textures = [{ source: 0, sampler: 0 }];
  maker.doc.samplers = [{ wrapS: 33071 }];
  maker.doc.materials = [{ name: 'paint', pbrMetallicRoughness: { baseColorTexture: { index: 0, extensions: { KHR_texture_transform: { offset: [1, 2], rotation: 0.5, scale: [2, 2] } } } },
    normalTexture: { index: 0 }, alphaMode: 'BLEND' }];
  return maker;
}

function project() {
  const maker = weights();
  maker.doc.extras = { shapespline: { version: 1, keys: { times: [0, 3], names: ['a', 'b'], frames: [1, 0] }, options: {} } };
  return maker;
}

function scene() {
  const maker = tetrahedron();
  maker.doc.meshes[0].primitives.push({ attributes: { POSITION: 0 }, mode: 5 }, { attributes: { POSITION: 0 }, mode: 6 }, { attributes: { POSITION: 0 }, mode: 1 });
  maker.doc.nodes = [{ mesh: 0, children: [1, 2], rotation: [0, 0, 0.6, 0.8] }, { mesh: 0, matrix: [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 0, 0, 1] }, { mesh: 0, scale: [2, 2, 2] }];
  return maker;
}

const whole = { pose: tetrahedron(), morph: morphing(), 'morph-animated': weights(), skin: skinned(), sparse: sparse(), painted: painted(), project: project(), scene: scene() };
for (const [name, maker] of Object.entries(whole)) write('gltf', `whole-${name}.gltf`, maker.text());
write('gltf', 'whole-pose.glb', tetrahedron().glb());
write('gltf', 'whole-skin.glb', weights(skinnedMorph()).glb());

function skinnedMorph() {
  const maker = skinned();
  maker.doc.meshes[0].primitives[0].targets = [{ POSITION: 0 }];
  return maker;
}

/** Broken files: valid ones with one change each. */
const broken = {
  'accessor-past-buffer': [tetrahedron, (d) => (d.accessors[0].count = 5)],
  'accessor-offset-past-buffer': [tetrahedron, (d) => (d.accessors[1].byteOffset = 2)],
  'accessor-of-gigabytes': [tetrahedron, (d) => { delete d.accessors[0].bufferView; d.accessors[0].count = 2000000000; }],
  'accessor-count-wraps': [tetrahedron, (d) => (d.accessors[0].count = 4294967300)],
  'accessor-stride-small': [tetrahedron, (d) => (d.bufferViews[0].byteStride = 4)],
  'accessor-type-wrong': [tetrahedron, (d) => (d.accessors[0].type = 'MAT4')],
  'accessor-component-unknown': [tetrahedron, (d) => (d.accessors[0].componentType = 5124)],
  'view-past-buffer': [tetrahedron, (d) => (d.bufferViews[0].byteLength = 9999)],
  'view-offset-wraps': [tetrahedron, (d) => (d.bufferViews[0].byteOffset = 4294967295)],
  'buffer-missing': [tetrahedron, (d) => (d.buffers = [])],
  'buffer-of-gigabytes': [tetrahedron, (d) => (d.buffers = [{ byteLength: 2147483647, uri: 'data:application/octet-stream;base64,AAAA' }])],
  'buffer-not-given': [tetrahedron, (d) => (d.buffers = [{ byteLength: 72, uri: 'elsewhere.bin' }])],
  'buffer-on-the-network': [tetrahedron, (d) => (d.buffers = [{ byteLength: 72, uri: 'https://example.org/a.bin' }])],
  'buffer-outside-the-folder': [tetrahedron, (d) => (d.buffers = [{ byteLength: 72, uri: '../../../etc/passwd' }])],
  'buffer-not-base64': [tetrahedron, (d) => (d.buffers = [{ byteLength: 72, uri: 'data:application/octet-stream;base64,%%%%' }])],
  'index-past-vertices': [tetrahedron, (d) => (d.accessors[0].count = 3)],
  'nodes-in-a-cycle': [tetrahedron, (d) => d.nodes.push({ children: [2] }, { children: [1] })],
  'node-its-own-child': [tetrahedron, (d) => (d.nodes[0].children = [0])],
  'node-child-missing': [tetrahedron, (d) => (d.nodes[0].children = [7])],
  'node-mesh-missing': [tetrahedron, (d) => (d.nodes[0].mesh = 7)],
  'node-matrix-short': [tetrahedron, (d) => (d.nodes[0].matrix = [1, 2])],
  'mesh-missing': [tetrahedron, (d) => (d.meshes = [])],
  'mesh-of-lines': [tetrahedron, (d) => (d.meshes[0].primitives[0].mode = 1)],
  'mesh-without-positions': [tetrahedron, (d) => (d.meshes[0].primitives[0].attributes = {})],
  'meshes-without-nodes': [tetrahedron, (d) => { d.nodes = []; d.scenes = []; delete d.scene; }],
  'extension-unknown': [tetrahedron, (d) => (d.extensionsRequired = ['KHR_draco_mesh_compression'])],
  'version-1': [tetrahedron, (d) => (d.asset.version = '1.0')],
  'types-wrong': [tetrahedron, (d) => { d.nodes = 7; d.materials = ['x']; }],
  'nested-deep': [tetrahedron, (d) => { let deep = 1; for (let i = 0; i < 300; ++i) deep = [deep]; d.extras = deep; }],
  'target-short': [morphing, (d) => (d.accessors[2].count = 3)],
  'target-missing': [morphing, (d) => (d.meshes[0].primitives[0].targets = [{ POSITION: 99 }])],
  'target-names-wrong': [morphing, (d) => (d.meshes[0].extras = { targetNames: [1, null] })],
  'sparse-index-past-end': [sparse, (d) => (d.accessors[2].count = 2)],
  'sparse-count-past-end': [sparse, (d) => (d.accessors[2].sparse.count = 100)],
  'sparse-view-missing': [sparse, (d) => (d.accessors[2].sparse.values.bufferView = 50)],
  'animation-sampler-missing': [weights, (d) => (d.animations[0].channels[0].sampler = 5)],
  'animation-node-missing': [weights, (d) => (d.animations[0].channels[0].target.node = 5)],
  'animation-of-nothing': [weights, (d) => (d.animations[0].channels = [])],
  'animation-values-short': [weights, (d) => (d.accessors[4].count = 2)],
  'animation-times-equal': [weights, (d) => (d.animations[0].samplers[0].input = 4)],
  'animation-rotation-of-weights': [weights, (d) => (d.animations[0].channels[0].target.path = 'rotation')],
  'skin-joint-past-end': [skinned, (d) => (d.skins[0].joints = [1])],
  'skin-joint-missing': [skinned, (d) => (d.skins[0].joints = [1, 44])],
  'skin-matrices-short': [skinned, (d) => (d.accessors[4].count = 1)],
  'skin-missing': [skinned, (d) => (d.skins = [])],
  'skin-without-weights': [skinned, (d) => delete d.meshes[0].primitives[0].attributes.WEIGHTS_0],
  'texture-source-missing': [painted, (d) => (d.textures[0].source = 3)],
  'texture-missing': [painted, (d) => (d.textures = [])],
  'image-past-buffer': [painted, (d) => (d.images[0].bufferView = 77)],
  'coordinates-short': [painted, (d) => (d.accessors[2].count = 3)],
  'project-frame-missing': [project, (d) => (d.extras.shapespline.keys.frames = [0, 9])],
  'project-of-nothing': [project, (d) => (d.extras.shapespline = null)],
  'not-an-object': [tetrahedron, (d) => (d.asset = 'glTF')],
};
for (const [name, [make, change]] of Object.entries(broken)) {
  const maker = make();
  change(maker.doc);
  write('gltf', `${name}.gltf`, maker.text());
}
const glb = tetrahedron().glb();
write('gltf', 'cut-in-bin.glb', glb.subarray(0, glb.length - 10));
write('gltf', 'cut-in-json.glb', glb.subarray(0, 100));
write('gltf', 'cut-in-header.glb', glb.subarray(0, 10));
write('gltf', 'empty.glb', '');
write('gltf', 'web-page.glb', '<!DOCTYPE html><html><body>Not Found</body></html>');
const chunk = Buffer.from(glb);
chunk.writeUInt32LE(0xfffffff0, 12);
write('gltf', 'chunk-of-gigabytes.glb', chunk);
const nan = tetrahedron();
nan.bin.writeFloatLE(NaN, 16);
write('gltf', 'position-not-finite.gltf', nan.text());
write('gltf', 'cut.gltf', tetrahedron().text().slice(0, 300));

// --- OBJ, PLY, OFF ------------------------------------------------------------------------------

const v = points.map((p) => `v ${p.join(' ')}\n`).join('');
const f = faces.map((face) => `f ${face.map((i) => i + 1).join(' ')}\n`).join('');
const obj = {
  'whole': v + f,
  'whole-polygons': 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 0 0 1\nf 1 2 3 4 5\nf 1 2 6\nf 2 3 4 6\n',
  'whole-everything': `# c\nmtllib a.mtl\no x\ng y\ns 1\n${v}vt 0 0\nvt 1 0\nvn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/1/1\nf -1//1 -2//1 \\\n-3//1\nl 1 2\np 1\nusemtl blue\nf 1/1 2/2 4/1\n`,
  'whole-colours': 'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1e0\nf 1 2 3\n',
  'whole-paint': v + '#MRGB ff0040ffff0040ff\n' + f,
  'whole-hole': 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n',
  'index-past-end': v + 'f 1 2 9\n',
  'index-zero': v + 'f 0 1 2\n',
  'index-before-start': v + 'f -9 1 2\n',
  'index-huge': v + 'f 1 2 99999999999999999999999\n',
  'index-no-number': v + 'f one two three\n',
  'corner-with-too-much': v + 'f 1/2/3/4 2 3\n',
  'vertex-short': 'v 1 2\nf 1 1 1\n',
  'vertex-not-finite': 'v nan 0 0\nv inf 0 0\nv 1e999 0 0\nf 1 2 3\n',
  'no-faces': v,
  'face-of-two': v + 'f 1 2\n',
  'all-in-a-point': 'v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n',
  'polygon-repeats': v + 'f 1 1 1 1 2 2 3\n',
  'polygon-large': v + `f ${Array.from({ length: 60 }, (_, i) => 1 + (i % 4)).join(' ')}\n`,
  'line-without-end': (v + f).trimEnd() + '\\',
  'empty': '',
};
for (const [name, text] of Object.entries(obj)) write('obj', `${name}.obj`, text);

const plyHead = (format, more = '') => `ply\nformat ${format} 1.0\n${more}element vertex 4\nproperty float x\nproperty float y\nproperty float z\n` +
  'element face 4\nproperty list uchar int vertex_indices\nend_header\n';
const plyBody = points.map((p) => p.join(' ') + '\n').join('') + faces.map((face) => `3 ${face.join(' ')}\n`).join('');
function plyBinary(little) {
  const parts = points.flat().map((value) => { const b = Buffer.alloc(4); little ? b.writeFloatLE(value) : b.writeFloatBE(value); return b; });
  for (const face of faces) {
    parts.push(Buffer.from([3]));
    for (const index of face) { const b = Buffer.alloc(4); little ? b.writeInt32LE(index) : b.writeInt32BE(index); parts.push(b); }
  }
  return Buffer.concat([Buffer.from(plyHead(little ? 'binary_little_endian' : 'binary_big_endian')), ...parts]);
}
const plyText = plyHead('ascii') + plyBody;
const ply = {
  'whole-ascii': plyText,
  'whole-little': plyBinary(true),
  'whole-big': plyBinary(false),
  'whole-more': 'ply\nformat ascii 1.0\ncomment c\nobj_info o\nelement extra 1\nproperty list uchar double q\nelement vertex 3\nproperty double x\nproperty double y\n' +
    'property double z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float t\n' +
    'element face 1\nproperty uchar k\nproperty list uchar uint vertex_index\nend_header\n2 1 2\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 0 255 0 1 0\n0 1 0 0 0 1 0 0 255 0 1\n7 3 0 1 2\n',
  'whole-colours': 'ply \nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float diffuse_red\n' +
    'property float g\nproperty float b\nproperty ushort a\nelement face 1\nproperty list uchar uint vertex_index\nproperty uchar red\nend_header\n0 0 0 255 0 9 1\n1 0 0 0 64 0 1\n0 1 0 0 0 64 1\n3 0 1 2 9\n',
  'cut-in-header': 'ply\nformat ascii 1.0\nelement ver',
  'cut-in-vertices': plyBinary(true).subarray(0, plyHead('binary_little_endian').length + 20),
  'cut-in-faces': plyBinary(false).subarray(0, -3),
  'vertices-of-gigabytes': plyText.replace('vertex 4', 'vertex 4294967295'),
  'vertices-too-many': plyText.replace('vertex 4', 'vertex 400000'),
  'elements-of-nothing': plyText.replace('element face', 'element nothing 60000000\nelement face'),
  'vertices-twice': plyText.replace('element face', 'element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n'
    + 'property float ny\nproperty float nz\nelement face').replace('3 0 2 1', '0 0 0 0 0 1\n3 0 2 1'),
  'count-negative': plyText.replace('vertex 4', 'vertex -4'),
  'list-of-gigabytes': plyText.replace('3 0 2 1', '4000000000 0 2 1'),
  'list-negative': plyText.replace('3 0 2 1', '-3 0 2 1').replace('list uchar', 'list int'),
  'list-length-float': plyText.replace('list uchar', 'list float'),
  'index-past-end': plyText.replace('3 0 2 1', '3 0 2 4'),
  'index-negative': plyText.replace('3 0 2 1', '3 0 2 -1'),
  'word-no-number': plyText.replace('1 0 0', '1 zero 0'),
  'vertex-not-finite': plyText.replace('1 0 0', '1 nan 0'),
  'no-format': plyText.replace('format ascii 1.0\n', ''),
  'no-coordinates': plyText.replace('float x', 'float a'),
  'no-faces': plyText.replace('face 4', 'face 0'),
  'type-unknown': plyText.replace('float x', 'quad x'),
  'property-of-nothing': 'ply\nformat ascii 1.0\nproperty float x\nend_header\n',
};
for (const [name, content] of Object.entries(ply)) write('ply', `${name}.ply`, content);

const offText = 'OFF\n4 4 0\n' + plyBody;
const off = {
  'whole': offText,
  'whole-one-line': offText.replace('OFF\n', 'OFF '),
  'whole-comments': '# c\nOFF # d\n# e\n\n' + offText.slice(4),
  'whole-normals': 'NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 0.5 0.5 0.5\n',
  'whole-colours': 'COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n',
  'cut': offText.slice(0, 30),
  'counts-missing': 'OFF\n',
  'counts-huge': offText.replace('4 4 0', '4e18 4 0'),
  'counts-too-large': offText.replace('4 4 0', '40 4 0'),
  'counts-negative': offText.replace('4 4 0', '-4 4 0'),
  'index-past-end': offText.replace('3 0 2 1', '3 0 2 4'),
  'index-negative': offText.replace('3 0 2 1', '3 0 2 -1'),
  'face-short': offText.replace('3 0 2 1', '9 0 2 1'),
  'face-of-gigabytes': offText.replace('3 0 2 1', '4000000000 0 2 1'),
  'face-not-a-number': offText.replace('3 0 2 1', 'nan 0 2 1'),
  'vertex-short': offText.replace('1 0 0', '1 0'),
  'vertex-not-finite': offText.replace('1 0 0', '1 inf 0'),
  'binary': 'OFF BINARY\n\x00\x00\x00\x04',
  'four-dimensions': '4OFF\n1 1 0\n',
};
for (const [name, content] of Object.entries(off)) write('off', `${name}.off`, content);

// --- PC2 and MDD, beside a mesh of four vertices --------------------------------------------------

const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
const lifted = square.map((x, i) => (i === 8 ? 1 : x));

function pc2({ points: count = 4, frames = 2, start = 0, step = 1, numbers = [...square, ...lifted] } = {}) {
  const head = Buffer.alloc(32);
  head.write('POINTCACHE2\0', 'latin1');
  head.writeUInt32LE(1, 12);
  head.writeUInt32LE(count, 16);
  head.writeFloatLE(start, 20);
  head.writeFloatLE(step, 24);
  head.writeUInt32LE(frames, 28);
  return Buffer.concat([head, floats(numbers)]);
}

function mdd({ points: count = 4, frames = 2, times = [0, 1], numbers = [...square, ...lifted] } = {}) {
  const head = Buffer.alloc(8);
  head.writeUInt32BE(frames, 0);
  head.writeUInt32BE(count, 4);
  return Buffer.concat([head, floats([...times, ...numbers]).swap32()]);
}

write('pc2', 'two-frames.pc2', pc2());
write('pc2', 'points-of-gigabytes.pc2', pc2({ points: 0xffffffff, frames: 0xffffffff }));
write('pc2', 'no-points.pc2', pc2({ points: 0, frames: 0xffffffff }));
write('pc2', 'one-frame.pc2', pc2({ frames: 1 }));
write('pc2', 'step-none.pc2', pc2({ step: 0 }));
write('pc2', 'step-nan.pc2', pc2({ start: NaN, step: Infinity }));
write('pc2', 'cut-in-header.pc2', pc2().subarray(0, 20));
write('pc2', 'cut-in-points.pc2', pc2().subarray(0, 60));
write('pc2', 'point-nan.pc2', pc2({ numbers: [...square, ...lifted.with(4, NaN)] }));
write('mdd', 'two-frames.mdd', mdd());
write('mdd', 'points-of-gigabytes.mdd', mdd({ points: 0xffffffff, frames: 0xffffffff }));
write('mdd', 'frames-wrap.mdd', mdd({ points: 1, frames: 0x40000000 }));
write('mdd', 'no-points.mdd', mdd({ points: 0 }));
write('mdd', 'times-back.mdd', mdd({ times: [1, 0] }));
write('mdd', 'times-nan.mdd', mdd({ times: [NaN, 1] }));
write('mdd', 'cut-in-points.mdd', mdd().subarray(0, 40));
write('mdd', 'far-points.mdd', mdd({ numbers: [...square, ...lifted.map((x) => 3e38 * x)] }));
