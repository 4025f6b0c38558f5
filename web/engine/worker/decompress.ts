/**
 * Converts glTF files with compressed meshes to uncompressed ones. Their maintained decoders handle
 * KHR_draco_mesh_compression, EXT_meshopt_compression and KHR_meshopt_compression, and are loaded on first use. The
 * core reads the result.
 */
import type { Document, JSONDocument } from '@gltf-transform/core';
import { EngineError, messageOf } from '../api/errors.ts';
import { parseGltf } from '../api/gltf-json.ts';
import { fileName, resolveUri, resourceUris, uriError } from '../api/paths.ts';
import { animationPointer } from './animation-pointer.ts';
import { GLB_MAGIC, jsonOf } from './gltf-text.ts';
import type { Codecs } from './codecs.ts';
import { checkCompressedViews, checkDecodedSize, checkForest, roomFor } from './decoded-size.ts';
import type { Decode } from './import-files.ts';
import { withMemoryLimit } from './wasm-memory.ts';
import type { InputFile } from '../api/types.ts';

const COMPRESSIONS = ['KHR_draco_mesh_compression', 'EXT_meshopt_compression'];
const BIN_CHUNK = 0x004e4942;
/** The name of the binary chunk in glTF-Transform. */
const GLB_BUFFER = '@glb.bin';

/** Working memory of Draco, in addition to its output. */
const DRACO_ROOM = 64 * 2 ** 20;

/** `dracoWasm` fetches the Draco decoder's wasm file, whose location differs between browsers and Node. */
export function decoder(codecs: Codecs, dracoWasm: () => Promise<Uint8Array>): Decode {
  return async (files, report) => {
    // Both extensions have the same members, and the decoder reads the codecs of both.
    const texts = files.map(({ bytes }) => jsonOf(bytes)?.replaceAll('"KHR_meshopt_', '"EXT_meshopt_') ?? null);
    const compressed = texts.map((text) => COMPRESSIONS.some((name) => text?.includes(`"${name}"`)));
    const [all, decoded] = [compressed.filter(Boolean).length, [...files]];
    let done = 0;
    for (const [index, file] of files.entries()) {
      if (!compressed[index]) continue;
      report(done / all);
      decoded[index] = await decodeFile({ file, text: texts[index]!, files, codecs, dracoWasm });
      done += 1;
      report(done / all);
    }
    return decoded;
  };
}

interface Job {
  file: InputFile;
  text: string;
  files: InputFile[];
  codecs: Codecs;
  dracoWasm: () => Promise<Uint8Array>;
}

async function decodeFile(job: Job): Promise<InputFile> {
  const name = fileName(job.file.name);
  const json = parseGltf(job.text) as JSONDocument['json'] | undefined;
  if (!json) return job.file; // the core reports the error's location
  try {
    checkForest(json);
    checkCompressedViews(json);
    return { name: job.file.name, bytes: await uncompress(job, json) };
  } catch (error) {
    if (error instanceof EngineError) throw error;
    const reason = reasonOf(error);
    const why = reason === '' ? '' : ` (${reason})`;
    const sentence = `${name}: its compressed mesh cannot be decoded${why}. Export the file again, or without compression.`;
    throw new EngineError('malformed-file', sentence, { file: name });
  }
}

/** The message of our own error or a library's; empty for a TypeError, which describes the library's code. */
function reasonOf(error: unknown): string {
  const isSentence = error instanceof Error && error.constructor === Error && /^[\w\s.,:()'"/-]+$/.test(error.message);
  return isSentence ? messageOf(error).replace(/\.$/, '') : '';
}

async function uncompress(
  { file, text, files, codecs, dracoWasm }: Job,
  json: JSONDocument['json'],
): Promise<Uint8Array> {
  const source: JSONDocument = { json, resources: {} };
  const binary = binaryOf(file.bytes);
  if (binary) source.resources[GLB_BUFFER] = binary as Uint8Array<ArrayBuffer>;
  addResources(source, file.name, files);
  const bytes = Object.values(source.resources).reduce((sum, { length }) => sum + length, file.bytes.length);
  checkDecodedSize(json, bytes, fileName(file.name));
  const io = await reader(codecs, text, async () => withMemoryLimit(await dracoWasm(), DRACO_ROOM + roomFor(bytes)));
  const document = await io.readJSON(source);
  for (const extension of document.getRoot().listExtensionsUsed()) {
    if (COMPRESSIONS.includes(extension.extensionName)) extension.dispose();
  }
  joinBuffers(document);
  return io.writeBinary(document);
}

/** The binary chunk of a GLB. */
function binaryOf(bytes: Uint8Array): Uint8Array | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== GLB_MAGIC) return null;
  const start = 20 + view.getUint32(12, true);
  if (start + 8 > bytes.length || view.getUint32(start + 4, true) !== BIN_CHUNK) return null;
  const length = view.getUint32(start, true);
  if (start + 8 + length > bytes.length) throw new Error('its binary chunk is cut off');
  return bytes.subarray(start + 8, start + 8 + length);
}

async function reader(codecs: Codecs, text: string, dracoWasm: () => Promise<Uint8Array>) {
  const [core, { ALL_EXTENSIONS }] = await Promise.all([codecs.core(), codecs.extensions()]);
  const io = new core.WebIO().setLogger(new core.Logger(core.Logger.Verbosity.SILENT));
  io.registerExtensions([...ALL_EXTENSIONS, animationPointer(core)]);
  if (text.includes('"KHR_draco_mesh_compression"')) {
    const { default: createDecoder } = await codecs.draco();
    io.registerDependencies({ 'draco3d.decoder': await createDecoder({ wasmBinary: await dracoWasm() }) });
  }
  if (text.includes('"EXT_meshopt_compression"')) {
    const { MeshoptDecoder } = await codecs.meshoptDecoder();
    await MeshoptDecoder.ready;
    io.registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  }
  return io;
}

/** Adds given files that this file refers to; reads no other files. A missing image only loses the texture. */
function addResources({ json, resources }: JSONDocument, name: string, files: InputFile[]): void {
  const { buffers, images } = resourceUris(json);
  for (const uri of images) {
    const found = resolveUri(uri, name, files);
    resources[uri] = (found.kind === 'file' ? found.file.bytes : new Uint8Array(0)) as Uint8Array<ArrayBuffer>;
  }
  for (const uri of buffers) {
    const found = resolveUri(uri, name, files);
    if (found.kind !== 'file') throw uriError(found.kind, uri, name);
    resources[uri] = found.file.bytes as Uint8Array<ArrayBuffer>;
  }
}

// A GLB has a single buffer.
function joinBuffers(document: Document): void {
  const [first, ...others] = document.getRoot().listBuffers();
  for (const accessor of document.getRoot().listAccessors()) accessor.setBuffer(first ?? null);
  for (const buffer of others) buffer.dispose();
}
