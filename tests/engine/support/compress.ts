/** Poses as GLB files with compressed meshes, made by common compressors. */
import { type Accessor, type Document, WebIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression, KHRMeshQuantization } from '@gltf-transform/extensions';
import createEncoder from 'draco3dgltf/draco_encoder_gltf_nodejs.js';
import { MeshoptEncoder } from 'meshoptimizer';
import type { InputFile } from '../../../web/engine/api/types.ts';

type Prepare = (document: Document, io: WebIO) => Promise<void>;

function compressed(files: InputFile[], prepare: Prepare): Promise<InputFile[]> {
  const io = new WebIO();
  return Promise.all(
    files.map(async ({ name, bytes }) => {
      const document = await io.readBinary(bytes as Uint8Array<ArrayBuffer>);
      await prepare(document, io);
      return { name, bytes: await io.writeBinary(document) };
    }),
  );
}

export const meshopt = (files: InputFile[]): Promise<InputFile[]> =>
  compressed(files, async (document, io) => {
    await MeshoptEncoder.ready;
    io.registerExtensions([EXTMeshoptCompression]).registerDependencies({ 'meshopt.encoder': MeshoptEncoder });
    const { QUANTIZE } = EXTMeshoptCompression.EncoderMethod;
    document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method: QUANTIZE });
  });

/** Positions as normalised 16-bit integers below a node that restores their scale (KHR_mesh_quantization). */
export async function quantised(file: InputFile): Promise<InputFile> {
  const io = new WebIO().registerExtensions([KHRMeshQuantization]);
  const document = await io.readBinary(file.bytes as Uint8Array<ArrayBuffer>);
  document.createExtension(KHRMeshQuantization).setRequired(true);
  for (const node of document.getRoot().listNodes()) node.setScale([16, 16, 16]);
  const done = new Set<Accessor>();
  for (const primitive of document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())) {
    for (const accessor of [primitive, ...primitive.listTargets()].map((part) => part.getAttribute('POSITION')!)) {
      if (done.has(accessor)) continue;
      done.add(accessor);
      accessor
        .setArray(
          Int16Array.from(accessor.getArray() as unknown as number[], (value) => Math.round((value / 16) * 32767)),
        )
        .setNormalized(true);
    }
  }
  return { name: file.name, bytes: await io.writeBinary(document) };
}

export const draco = (files: InputFile[]): Promise<InputFile[]> =>
  compressed(files, async (document, io) => {
    io.registerExtensions([KHRDracoMeshCompression]).registerDependencies({ 'draco3d.encoder': await createEncoder() });
    document
      .createExtension(KHRDracoMeshCompression)
      .setRequired(true)
      .setEncoderOptions({ quantizationBits: { POSITION: 16 } });
  });
