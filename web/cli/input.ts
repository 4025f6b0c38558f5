/** Named files on the disk, and what a .gltf or .obj among them names: from its own folder only, and never over the network. */
import { constants } from 'node:fs';
import { open, realpath } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { beside, decodedUri, extensionOf, isExternal, resourceUris } from '../engine/api/paths.ts';
import type { InputFile } from '../engine/api/types.ts';

export async function readInputs(names: string[]): Promise<InputFile[]> {
  const files: InputFile[] = [];
  for (const name of names) {
    const file = { name: toSlashes(name), bytes: await read(name) };
    files.push(file);
    const named = extensionOf(name) === 'obj' ? await librariesOf(file) : urisOf(file.bytes);
    for (const uri of named) {
      const resource = nameBeside(name, uri);
      if (files.some((other) => other.name === resource)) continue;
      const bytes = await readBeside(name, uri);
      if (bytes) files.push({ name: resource, bytes });
    }
  }
  return files;
}

/** The material libraries of an OBJ, which it names before its first face, and the images that they name, as seen from there. */
async function librariesOf({ name, bytes }: InputFile): Promise<string[]> {
  const libraries = namedIn(bytes.subarray(0, OBJ_HEAD), /^mtllib[ \t]+(.+?)[ \t]*$/gm);
  const images = await Promise.all(
    libraries.map(async (library) => {
      const text = (await readBeside(name, library)) ?? new Uint8Array(0);
      return namedIn(text, IMAGE).map((image) => beside(library, image));
    }),
  );
  return [...libraries, ...images.flat()];
}

const OBJ_HEAD = 1 << 16;
/** Behind options such as -s 1 1 1 and -clamp on. */
const IMAGE = /^[ \t]*map_Kd[ \t]+(?:-\w+(?:[ \t]+(?:[-+]?[.\d][^ \t]*|on|off))*[ \t]+)*(.+?)[ \t]*$/gm;

function namedIn(bytes: Uint8Array, pattern: RegExp): string[] {
  return [
    ...new Set(Array.from(new TextDecoder().decode(bytes).replaceAll('\r', '').matchAll(pattern), ([, name]) => name!)),
  ];
}

async function read(name: string): Promise<Uint8Array> {
  try {
    return await readRegular(name);
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    const reason =
      code === 'ENOENT' ? 'there is no such file' : code === 'EISDIR' ? 'it is a folder' : messageOf(error);
    throw new EngineError('missing-file', `${name}: ${reason}.`, { file: name });
  }
}

/** A device never ends, and a pipe may never begin: both are refused before a byte is read. */
async function readRegular(name: string): Promise<Uint8Array> {
  const file = await open(name, constants.O_RDONLY | constants.O_NONBLOCK);
  try {
    const stats = await file.stat();
    if (!stats.isFile() && !stats.isDirectory()) throw new Error('it is a device, a pipe or a socket, not a file');
    return await file.readFile();
  } finally {
    await file.close();
  }
}

/** URIs of the buffers and images of a .gltf; what is not JSON is for the engine to judge. */
function urisOf(bytes: Uint8Array): string[] {
  if (!/^[\uFEFF\s]*\{/.test(new TextDecoder().decode(bytes.subarray(0, 64)))) return [];
  try {
    const { buffers, images } = resourceUris(JSON.parse(new TextDecoder().decode(bytes).replace(/^\uFEFF/, '')));
    return [...buffers, ...images];
  } catch {
    return [];
  }
}

/** How the engine is told the file that a URI names. */
const nameBeside = (gltf: string, uri: string): string => beside(toSlashes(gltf), decodedUri(uri));

/** The file that a URI names, or null where it is missing or leaves the folder: the engine says so in its own words. */
async function readBeside(gltf: string, uri: string): Promise<Uint8Array | null> {
  if (isExternal(uri)) return null;
  try {
    const folder = await realpath(path.dirname(gltf));
    const found = await realpath(path.resolve(folder, decodedUri(uri).replaceAll('\\', '/')));
    return found.startsWith(folder + path.sep) ? await readRegular(found) : null;
  } catch {
    return null;
  }
}

const toSlashes = (name: string): string => name.replaceAll(path.sep, '/');
