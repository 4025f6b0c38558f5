/**
 * Compresses our GLBs: KHR_mesh_quantization, then optionally EXT_meshopt_compression, with glTF-Transform's functions.
 * Loaded with the first compressed export.
 */
import type { Accessor, Document } from '@gltf-transform/core';
import type { Codecs } from './codecs.ts';
import { GridFit, STEPS } from '../wire/position-grid.ts';
import type { Compression } from '../wire/protocol.ts';

/** glTF's own attributes except positions, which have a separate grid. Vertex numbers stay exact. */
const QUANTIZED = /^(NORMAL|TANGENT|TEXCOORD_\d+|COLOR_\d+)$/;
const NORMAL_BITS = 12;

export async function compress(
  codecs: Codecs,
  bytes: Uint8Array,
  compression: Exclude<Compression, 'none'>,
): Promise<Uint8Array> {
  const [{ Logger, PropertyType, WebIO }, { ALL_EXTENSIONS, KHRMeshQuantization }, { prune, quantize }] =
    await Promise.all([codecs.core(), codecs.extensions(), codecs.functions()]);
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  const document = (await io.readBinary(bytes as Uint8Array<ArrayBuffer>)).setLogger(
    new Logger(Logger.Verbosity.SILENT),
  );
  if (compression === 'meshopt') await orderForMeshopt(codecs, document, io);
  document.createExtension(KHRMeshQuantization).setRequired(true);
  quantizePositions(document);
  const attach = detachLongNormals(document);
  await document.transform(
    quantize({
      pattern: QUANTIZED,
      patternTargets: /^NORMAL$/,
      quantizeNormal: NORMAL_BITS,
      quantizeTexcoord: 16,
      quantizeColor: 16,
      cleanup: false,
    }),
  );
  attach();
  await document.transform(prune({ propertyTypes: [PropertyType.ACCESSOR], keepAttributes: true, keepIndices: true }));
  return io.writeBinary(document);
}

/**
 * Puts positions on a grid around the shape, with the inverse in the node's translation and scale. With targets,
 * glTF-Transform's own grid would extend to the origin.
 */
function quantizePositions(document: Document): void {
  const node = document.getRoot().listNodes()[0]!;
  const primitives = node.getMesh()!.listPrimitives();
  const bases = new Set(primitives.map((primitive) => primitive.getAttribute('POSITION')!));
  const targets = new Set(
    primitives.flatMap((primitive) => primitive.listTargets()).map((target) => target.getAttribute('POSITION')!),
  );
  const fit = new GridFit();
  for (const base of bases) fit.addBase(base.getArray()!);
  for (const target of targets) fit.addDifference(target.getArray()!);
  const { centre, scale } = fit.grid;
  const round = (accessor: Accessor, around: readonly number[]): void => {
    const steps = Int16Array.from(accessor.getArray() as Float32Array, (value, i) =>
      Math.round(((value - around[i % 3]!) / scale) * STEPS),
    );
    accessor.setArray(steps).setNormalized(true);
  };
  for (const base of bases) round(base, centre);
  for (const target of targets) round(target, [0, 0, 0]);
  const [x, y, z] = node.getTranslation();
  node.setTranslation([x + centre[0], y + centre[1], z + centre[2]]).setScale([scale, scale, scale]);
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
 * Detaches normals of targets whose rotations exceed the range of normalised numbers. They stay floats with the same
 * number of bits. Returns a function that attaches them again.
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
