/**
 * A GLB of ours with smaller numbers: KHR_mesh_quantization, and EXT_meshopt_compression of what that leaves, by
 * glTF-Transform's own functions, which are loaded when the first export asks for them.
 */
import type { Document } from '@gltf-transform/core';
import type { Codecs } from './codecs.ts';
import type { Compression } from '../wire/protocol.ts';

/** glTF's own attributes; numbers of vertices stay exact. */
const QUANTIZED = /^(POSITION|NORMAL|TANGENT|TEXCOORD_\d+|COLOR_\d+)$/;
const POSITION_BITS = 16;
const NORMAL_BITS = 12;
/** Steps of a normalised 16-bit number on either side of 0. */
const STEPS = 32767;

export interface Compressed {
  compression: Exclude<Compression, 'none'>;
  /** Of the bounding box of all keys. */
  diagonal: number;
  /** The largest sum of the weights at any time. */
  weight: number;
}

export async function compress(
  codecs: Codecs,
  bytes: Uint8Array,
  { compression, diagonal, weight }: Compressed,
): Promise<Uint8Array> {
  const [{ Logger, PropertyType, WebIO }, { ALL_EXTENSIONS }, { prune, quantize }] = await Promise.all([
    codecs.core(),
    codecs.extensions(),
    codecs.functions(),
  ]);
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  const document = (await io.readBinary(bytes as Uint8Array<ArrayBuffer>)).setLogger(
    new Logger(Logger.Verbosity.SILENT),
  );
  if (compression === 'meshopt') await orderForMeshopt(codecs, document, io);
  const attach = detachLongNormals(document);
  await document.transform(
    quantize({
      pattern: QUANTIZED,
      patternTargets: /^(POSITION|NORMAL)$/,
      quantizePosition: POSITION_BITS,
      quantizeNormal: NORMAL_BITS,
      quantizeTexcoord: 16,
      quantizeColor: 16,
      cleanup: false,
    }),
  );
  attach();
  await document.transform(prune({ propertyTypes: [PropertyType.ACCESSOR], keepAttributes: true, keepIndices: true }));
  noteError(document, diagonal, weight);
  return io.writeBinary(document);
}

interface Registers {
  registerDependencies(what: object): unknown;
}

async function orderForMeshopt(codecs: Codecs, document: Document, io: Registers): Promise<void> {
  const [{ EXTMeshoptCompression }, { reorder }, { MeshoptEncoder }] = await Promise.all([
    codecs.extensions(),
    codecs.functions(),
    codecs.meshoptEncoder(),
  ]);
  await MeshoptEncoder.ready;
  io.registerDependencies({ 'meshopt.encoder': MeshoptEncoder });
  await document.transform(reorder({ encoder: MeshoptEncoder, target: 'size' }));
  const method = EXTMeshoptCompression.EncoderMethod.QUANTIZE;
  document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method });
}

/**
 * Takes away the normals of those targets where some turn so far that the difference is longer than normalised numbers
 * reach: they stay floats, of as many bits as the others. What is returned gives them back.
 */
function detachLongNormals(document: Document): () => void {
  const steps = 2 ** (NORMAL_BITS - 1) - 1;
  const long: (() => void)[] = [];
  for (const mesh of document.getRoot().listMeshes())
    for (const target of mesh.listPrimitives().flatMap((primitive) => primitive.listTargets())) {
      const normals = target.getAttribute('NORMAL');
      const values = (normals?.getArray() ?? []) as Float32Array;
      if (values.every((value) => Math.abs(value) <= 1)) continue;
      normals!.setArray(values.map((value) => Math.round(value * steps) / steps));
      target.setAttribute('NORMAL', null);
      long.push(() => target.setAttribute('NORMAL', normals));
    }
  return () => {
    for (const attach of long) attach();
  };
}

/** Half a step of the base and of every target that is added to it, along each axis. */
function noteError(document: Document, diagonal: number, weight: number): void {
  const root = document.getRoot();
  const extras = root.getExtras() as { shapespline?: { mesh?: { error?: number | null } } };
  const mesh = extras.shapespline?.mesh;
  const scale = root.listNodes()[0]?.getScale()[0] ?? 0;
  if (mesh) mesh.error = (mesh.error ?? 0) + roundingError(scale, weight) / diagonal;
  root.setExtras(extras);
}

/** The largest distance that rounding moves a vertex, of a shape that reaches `scale` from its middle. */
export function roundingError(scale: number, weight: number): number {
  return (Math.sqrt(3) * scale * (1 + weight)) / 2 / STEPS;
}
