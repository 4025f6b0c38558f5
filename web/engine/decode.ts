/**
 * glTF files with compressed meshes -> the same files without. KHR_draco_mesh_compression and EXT_meshopt_compression are
 * undone by their own well-kept decoders, which are loaded when the first file needs them; the core reads what remains.
 */
import type { Document, JSONDocument } from '@gltf-transform/core';
import { EngineError, messageOf } from './errors.ts';
import type { Decode } from './import-files.ts';
import type { InputFile } from './types.ts';

const COMPRESSIONS = ['KHR_draco_mesh_compression', 'EXT_meshopt_compression'];
const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;

/** `dracoWasm` brings the Draco decoder's wasm file; browsers and Node find it in different places. */
export function decoder(dracoWasm: () => Promise<Uint8Array>): Decode {
  return (files) => Promise.all(files.map(async (file) => {
    const text = jsonOf(file.bytes);
    if (!text || !COMPRESSIONS.some((name) => text.includes(`"${name}"`))) return file;
    try {
      return { name: file.name, bytes: await uncompress(file, text, files, dracoWasm) };
    } catch (error) {
      const reason = messageOf(error).replace(/\.$/, '');
      throw new EngineError('malformed-file', `${file.name}: its compressed mesh cannot be decoded (${reason}).`, { file: file.name });
    }
  }));
}

/** The JSON text of a .glb or .gltf file; null for anything else, which is for the core to judge. */
function jsonOf(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const decode = (start: number, end: number): string => new TextDecoder().decode(bytes.subarray(start, end));
  if (bytes.length >= 20 && view.getUint32(0, true) === GLB_MAGIC) {
    const length = view.getUint32(12, true);
    return view.getUint32(16, true) === JSON_CHUNK && 20 + length <= bytes.length ? decode(20, 20 + length) : null;
  }
  return /^[\uFEFF\s]*\{/.test(decode(0, 64)) ? decode(0, bytes.length) : null;
}

async function uncompress(file: InputFile, text: string, files: InputFile[], dracoWasm: () => Promise<Uint8Array>): Promise<Uint8Array> {
  const io = await reader(text, dracoWasm);
  const isBinary = new DataView(file.bytes.buffer, file.bytes.byteOffset).getUint32(0, true) === GLB_MAGIC;
  const source: JSONDocument = isBinary
    ? await io.binaryToJSON(file.bytes as Uint8Array<ArrayBuffer>)
    : { json: JSON.parse(text.replace(/^\uFEFF/, '')) as JSONDocument['json'], resources: {} };
  addResources(source, file.name, files);
  const document = await io.readJSON(source);
  for (const extension of document.getRoot().listExtensionsUsed()) {
    if (COMPRESSIONS.includes(extension.extensionName)) extension.dispose();
  }
  joinBuffers(document);
  return io.writeBinary(document);
}

async function reader(text: string, dracoWasm: () => Promise<Uint8Array>) {
  const [{ Logger, WebIO }, { ALL_EXTENSIONS }] = await Promise.all([import('@gltf-transform/core'), import('@gltf-transform/extensions')]);
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  if (text.includes('"KHR_draco_mesh_compression"')) {
    const { default: createDecoder } = await import('draco3dgltf/draco_decoder_gltf_nodejs.js');
    io.registerDependencies({ 'draco3d.decoder': await createDecoder({ wasmBinary: await dracoWasm() }) });
  }
  if (text.includes('"EXT_meshopt_compression"')) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder');
    await MeshoptDecoder.ready;
    io.registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  }
  return io;
}

/** Files beside this one that it names; nothing else is looked for anywhere. */
function addResources({ json, resources }: JSONDocument, name: string, files: InputFile[]): void {
  const folder = name.slice(0, name.lastIndexOf('/') + 1);
  for (const { uri } of [...(json.buffers ?? []), ...(json.images ?? [])]) {
    if (!uri || uri.startsWith('data:')) continue;
    const found = files.find((file) => file.name === folder + decodeURIComponent(uri));
    if (!found) throw new Error(`the file ${uri} was not given with it`);
    resources[uri] = found.bytes as Uint8Array<ArrayBuffer>;
  }
}

// A GLB has one buffer.
function joinBuffers(document: Document): void {
  const [first, ...others] = document.getRoot().listBuffers();
  for (const accessor of document.getRoot().listAccessors()) accessor.setBuffer(first ?? null);
  for (const buffer of others) buffer.dispose();
}
