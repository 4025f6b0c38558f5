/**
 * A GLB with every part of a look: seams, normals, texture coordinates, and two textured materials, one with a normal
 * map.
 */
import { Document, WebIO, type Accessor } from '@gltf-transform/core';
import type { InputFile } from '../../../web/engine/api/types.ts';
import { bar, bent, type Mesh } from './shapes.ts';

const PNG = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==';

/** A separate vertex for every corner. */
const apart = (values: Float32Array, { indices }: Mesh): Float32Array =>
  Float32Array.from(Array.from(indices).flatMap((v) => [...values.subarray(3 * v, 3 * v + 3)]));

function faceNormals(corners: Float32Array): Float32Array {
  const normals = new Float32Array(corners.length);
  for (let f = 0; f < corners.length; f += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = corners.subarray(f, f + 9) as unknown as number[];
    const [ux, uy, uz, vx, vy, vz] = [bx! - ax!, by! - ay!, bz! - az!, cx! - ax!, cy! - ay!, cz! - az!];
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(...normal);
    for (let i = 0; i < 9; i += 1) normals[f + i] = normal[i % 3]! / length;
  }
  return normals;
}

/** The bar bent by 0, 40 and 80 degrees, as base and morph targets. */
export async function paintedDocument(): Promise<Document> {
  const document = new Document();
  const buffer = document.createBuffer();
  const mesh = bar(2, 8);
  const vectors = (array: Float32Array, type: 'VEC3' | 'VEC2' = 'VEC3'): Accessor =>
    document.createAccessor().setArray(array).setType(type).setBuffer(buffer);
  const base = apart(mesh.positions, mesh);
  const uvs = Float32Array.from(
    { length: (base.length / 3) * 2 },
    (_, i) => base[3 * (i >> 1) + (i % 2) * 2]! * (i % 2 ? 0.1 : 0.8),
  );
  const attributes = { POSITION: vectors(base), NORMAL: vectors(faceNormals(base)), TEXCOORD_0: vectors(uvs, 'VEC2') };
  const targets = [40, 80].map((degrees) => {
    const offsets = apart(bent(mesh, degrees), mesh).map((value, i) => value - base[i]!);
    return document.createPrimitiveTarget().setAttribute('POSITION', vectors(offsets));
  });
  const image = Uint8Array.from(atob(PNG), (character) => character.charCodeAt(0));
  const texture = (name: string) => document.createTexture(name).setImage(image).setMimeType('image/png');
  const materials = [
    document
      .createMaterial('skin')
      .setBaseColorTexture(texture('colour'))
      .setNormalTexture(texture('bumps'))
      .setRoughnessFactor(0.4),
    document
      .createMaterial('cloth')
      .setBaseColorFactor([0.2, 0.4, 0.6, 0.5])
      .setAlphaMode('BLEND')
      .setDoubleSided(true),
  ];
  const count = base.length / 3;
  const whole = document.createMesh();
  for (const [index, material] of materials.entries()) {
    const start = index === 0 ? 0 : Math.floor(count / 6) * 3;
    const length = index === 0 ? Math.floor(count / 6) * 3 : count - start;
    const indices = document
      .createAccessor()
      .setArray(Uint16Array.from({ length }, (_, i) => start + i))
      .setType('SCALAR')
      .setBuffer(buffer);
    const primitive = document.createPrimitive().setIndices(indices).setMaterial(material);
    for (const [name, accessor] of Object.entries(attributes)) primitive.setAttribute(name, accessor);
    for (const target of targets) primitive.addTarget(target);
    whole.addPrimitive(primitive);
  }
  document.getRoot().setDefaultScene(document.createScene().addChild(document.createNode('bar').setMesh(whole)));
  return document;
}

export async function paintedFile(): Promise<InputFile> {
  return { name: 'painted.glb', bytes: await new WebIO().writeBinary(await paintedDocument()) };
}
