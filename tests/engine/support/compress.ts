/** Poses as GLB files with compressed meshes, made by the compressors that people use. */
import { type Document, WebIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import createEncoder from 'draco3dgltf/draco_encoder_gltf_nodejs.js';
import { MeshoptEncoder } from 'meshoptimizer';
import type { InputFile } from '../../../web/engine/types.ts';

type Prepare = (document: Document, io: WebIO) => Promise<void>;

function compressed(files: InputFile[], prepare: Prepare): Promise<InputFile[]> {
  const io = new WebIO();
  return Promise.all(files.map(async ({ name, bytes }) => {
    const document = await io.readBinary(bytes as Uint8Array<ArrayBuffer>);
    await prepare(document, io);
    return { name, bytes: await io.writeBinary(document) };
  }));
}

export const meshopt = (files: InputFile[]): Promise<InputFile[]> => compressed(files, async (document, io) => {
  await MeshoptEncoder.ready;
  io.registerExtensions([EXTMeshoptCompression]).registerDependencies({ 'meshopt.encoder': MeshoptEncoder });
  const { QUANTIZE } = EXTMeshoptCompression.EncoderMethod;
  document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method: QUANTIZE });
});

export const draco = (files: InputFile[]): Promise<InputFile[]> => compressed(files, async (document, io) => {
  io.registerExtensions([KHRDracoMeshCompression]).registerDependencies({ 'draco3d.encoder': await createEncoder() });
  document.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({ quantizationBits: { POSITION: 16 } });
});
