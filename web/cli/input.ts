/**
 * Reads named files from disk, and the companions of a .gltf or .obj: only from its own folder, never over the network.
 */
import { constants } from 'node:fs';
import { open, readdir, realpath, stat } from 'node:fs/promises';
import path from 'node:path';
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { parseGltf } from '../engine/api/gltf-json.ts';
import { checkImportSize } from '../engine/api/import-size.ts';
import { inNaturalOrder, sequenceText, sequencesIn } from '../engine/api/numbered-names.ts';
import {
  CACHES,
  COMPANIONS,
  beside,
  decodedUri,
  extensionOf,
  fileName,
  isExternal,
  isImportable,
  resourceUris,
} from '../engine/api/paths.ts';
import type { InputFile } from '../engine/api/types.ts';
import type { KnownFiles } from './known-files.ts';

/** Total bytes read so far. */
interface Total {
  bytes: number;
}

/** Replaces folders by the models in them, in natural order of names; does not search subfolders. */
async function withoutFolders(names: string[]): Promise<string[]> {
  const lists = await Promise.all(
    names.map(async (name) => {
      const isFolder = await stat(name).then(
        (stats) => stats.isDirectory(),
        () => false,
      );
      if (!isFolder) return [name];
      const inside = (await readdir(name)).filter((one) => isImportable(one) && !COMPANIONS.includes(extensionOf(one)));
      if (inside.length === 0)
        throw new EngineError('missing-file', `${name}: there is no model in this folder.`, { file: name });
      checkOneSequence(name, inside);
      return inNaturalOrder(inside.map((one) => ({ name: one }))).map((one) => path.join(name, one.name));
    }),
  );
  return lists.flat();
}

/** Several numbered sequences in one folder are unlikely to be one motion. */
function checkOneSequence(folder: string, inside: string[]): void {
  const sequences = sequencesIn(inNaturalOrder(inside.map((name) => ({ name }))).map(({ name }) => name));
  const [first] = sequences;
  if (!first || sequences.length === 1) return;
  const shown = sequences.slice(0, MAX_SHOWN).map(sequenceText);
  const more = sequences.length > shown.length ? [`${sequences.length - shown.length} more`] : [];
  throw new EngineError(
    'several-sequences',
    `${folder} has ${sequences.length} numbered sequences: ${[...shown, ...more].join(', ')}. ` +
      `Give the files of one sequence, such as ${path.join(folder, first.names[0]!)} to ${first.names.at(-1)!}.`,
    { file: folder },
  );
}

const MAX_SHOWN = 5;

/** Adds these inputs and all files that they refer to, also those that are not read. Reads no large file but an OBJ. */
export async function addInputs(known: KnownFiles, given: string[]): Promise<void> {
  for (const name of await withoutFolders(given)) {
    await known.add(name);
    for (const file of await referredBy(name)) await known.add(file, name);
  }
}

/** Paths of the files that a model may refer to. Missing files are ignored. */
async function referredBy(name: string): Promise<string[]> {
  const uris = await urisAtStart(name);
  if (uris) return uris.flatMap((uri) => pathsOf(name, uri));
  const textures = texturesOfPly(await startOf(name, PLY_HEADER));
  if (textures.length > 0 || NO_LIBRARIES.includes(extensionOf(name)))
    return textures.flatMap((texture) => pathsOf(name, texture));
  const isFile = async (file: string): Promise<boolean> => (await startOf(file, 1)).length > 0;
  const files: string[] = [];
  for (const text of namedIn(await startOf(name, Infinity), 'mtllib')) {
    const libraries = await libraryNames(text, (library) => isFile(path.resolve(path.dirname(name), library)));
    files.push(...libraries.flatMap((library) => pathsOf(name, library)));
  }
  const images = await Promise.all(
    files.map(async (file) =>
      imagesIn(await startOf(file, LARGEST_LIBRARY)).flatMap((image) => [
        ...pathsOf(file, image),
        ...pathsOf(name, image),
      ]),
    ),
  );
  return [...files, ...images.flat()];
}

const LARGEST_LIBRARY = 1 << 24;
/** Largest header of a PLY file that is searched. */
const PLY_HEADER = 1 << 16;
const LARGEST_START = 1 << 30;

/** A reference as a path, without escapes, in all forms of accents, and as a name in the same folder. */
function pathsOf(from: string, reference: string): string[] {
  const folder = path.dirname(from);
  const paths = [reference, decodedUri(reference)].flatMap((text) => {
    const plain = text.replace(/^file:\/\//i, '').replaceAll('\\', '/');
    const spellings = [plain, plain.normalize('NFC'), plain.normalize('NFD')];
    return spellings.flatMap((one) => [path.resolve(folder, one), path.join(folder, path.basename(one))]);
  });
  return [...new Set(paths)];
}

/** All images that a material library refers to, also those that the engine does not use. */
function imagesIn(bytes: Uint8Array): string[] {
  const lines = new TextDecoder().decode(bytes).split(/[\r\n]+/);
  return lines.flatMap((line) => {
    const text = /^(?:map_\w+|bump|disp|decal|norm|refl)[ \t](.*)$/i.exec(line.trim())?.[1]?.trim();
    return text ? [withoutOptions(text)] : [];
  });
}

/** Images that the header of a PLY file names, as MeshLab writes them. The engine does not read them. */
function texturesOfPly(bytes: Uint8Array): string[] {
  const [header = ''] = new TextDecoder().decode(bytes).split(/^end_header/m, 1);
  if (!/^\uFEFF?ply\s/.test(header)) return [];
  return [...header.matchAll(/^comment[ \t]+TextureFile[ \t]+(.*)$/gim)].map(([, name = '']) => name.trim());
}

/** The URIs of a .gltf, or of the JSON at the start of a .glb; null for other files. */
async function urisAtStart(name: string): Promise<string[] | null> {
  const head = Buffer.from(await startOf(name, GLB_HEAD));
  const isGlb = head.length === GLB_HEAD && head.toString('latin1', 0, 4) === 'glTF';
  if (!isGlb && !isJson(head)) return null;
  const json = isGlb
    ? (await startOf(name, GLB_HEAD + head.readUInt32LE(12))).subarray(GLB_HEAD)
    : await startOf(name, Infinity);
  try {
    return urisOf(json);
  } catch {
    return []; // reported when the file is read
  }
}

/** Bytes of a GLB before its JSON. */
const GLB_HEAD = 20;

/** The first bytes of a regular file; none of other files. */
async function startOf(name: string, most: number): Promise<Uint8Array> {
  const file = await open(name, constants.O_RDONLY | constants.O_NONBLOCK).catch(() => null);
  try {
    const stats = await file?.stat();
    if (!file || !stats?.isFile()) return new Uint8Array(0);
    const bytes = new Uint8Array(Math.min(most, stats.size, LARGEST_START));
    const { bytesRead } = await file.read(bytes, 0, bytes.length, 0);
    return bytes.subarray(0, bytesRead);
  } finally {
    await file?.close();
  }
}

export async function readInputs(given: string[]): Promise<InputFile[]> {
  const files: InputFile[] = [];
  const total: Total = { bytes: 0 };
  for (const name of await withoutFolders(given)) {
    const file = { name: toSlashes(name), bytes: await read(name, total) };
    files.push(file);
    const named =
      urisOf(file.bytes) ?? (NO_LIBRARIES.includes(extensionOf(name)) ? [] : await librariesOf(file, total));
    for (const uri of named) {
      const resource = nameBeside(name, uri);
      if (files.some((other) => other.name === resource)) continue;
      const bytes = await readBeside(name, uri, total);
      if (bytes) files.push({ name: resource, bytes });
    }
  }
  return files;
}

/** Extensions of files that name no material libraries. An OBJ may have any other extension. */
const NO_LIBRARIES = ['glb', 'ply', 'off', ...CACHES, ...COMPANIONS];

/** The material libraries that an OBJ names, and their images, relative to the OBJ. */
async function librariesOf({ name, bytes }: InputFile, total: Total): Promise<string[]> {
  const libraries: string[] = [];
  for (const text of namedIn(bytes, 'mtllib'))
    libraries.push(...(await libraryNames(text, async (one) => (await readBeside(name, one, total)) !== null)));
  const near = libraries.map((library) => besideOrNear('', library));
  const images = await Promise.all(
    near.map(async (library) => {
      const text = (await readBeside(name, library, total)) ?? new Uint8Array(0);
      return namedIn(text, 'map_kd').flatMap((image) => {
        const path = besideOrNear(library, withoutOptions(image));
        return [path, fileName(path)];
      });
    }),
  );
  return [...near, ...images.flat()];
}

/** A path relative to the file `from`. Paths of another computer, such as C:\\a.png, are reduced to the file's name. */
function besideOrNear(from: string, name: string): string {
  const path = beside(from, name);
  return isExternal(name) || path.startsWith('../') ? beside(from, fileName(name)) : path;
}

/** Longest name, in words. */
const MAX_WORDS = 8;

/** One name with spaces, or several names: a name ends if it is a file, or in .mtl (as in `wasm/io/polygon`). */
export async function libraryNames(text: string, isFile: (name: string) => Promise<boolean>): Promise<string[]> {
  if (!/[ \t]/.test(text) || (await isFile(text))) return [text];
  const names: string[] = [];
  let [start, words] = [0, 0];
  for (const { 0: word, index } of text.matchAll(/[^ \t]+/g)) {
    if (words === 0) start = index;
    words += 1;
    const end = index + word.length;
    const name = text.slice(start, end);
    if (end < text.length && extensionOf(word) !== 'mtl' && !(words <= MAX_WORDS && (await isFile(name)))) continue;
    names.push(name);
    words = 0;
  }
  return names;
}

const [LF, CR] = [10, 13];
/** Limit for a line that continues on others. */
const MAX_PARTS = 256;

/**
 * The names after a keyword in any case, without duplicates. Decodes only lines with its first letter, because a file
 * may be large, and uses no pattern that would backtrack over the spaces of a long line.
 */
export function namedIn(bytes: Uint8Array, keyword: string): string[] {
  const named = new Set<string>();
  const letter = keyword.charCodeAt(0);
  const endOf = (start: number): number => {
    let end = start;
    while (end < bytes.length && bytes[end] !== LF && bytes[end] !== CR) end += 1;
    return end;
  };
  const decoder = new TextDecoder();
  const text = (start: number, end: number): string => decoder.decode(bytes.subarray(start, end)).trim();
  for (let at = bytes[0] === 0xef ? 3 : 0; at < bytes.length; at += 1) {
    if (bytes[at]! <= 32) continue;
    let end = endOf(at);
    if ((bytes[at]! | 32) === letter) {
      const parts = [text(at, end)];
      // The line continues on the next one that is not empty.
      while (parts.at(-1)!.endsWith('\\') && end < bytes.length && parts.length < MAX_PARTS) {
        const start = end + 1;
        end = endOf(start);
        if (end > start) parts.push(text(start, end));
      }
      const line = parts.map((part) => part.replace(/\\$/, '')).join(' ');
      const rest = line.slice(keyword.length);
      if (line.slice(0, keyword.length).toLowerCase() === keyword && /^[ \t]/.test(rest)) named.add(rest.trim());
    }
    at = end;
  }
  return [...named];
}

const OPTION = /-\w+[ \t]+/y;
const OPTION_VALUE = /(?:[-+]?[.\d][^ \t]*|on|off)[ \t]+/iy;

/** An image's name without preceding options such as -s 1 1 1 and -clamp on. */
export function withoutOptions(text: string): string {
  let at = 0;
  const takes = (pattern: RegExp): boolean => {
    pattern.lastIndex = at;
    if (!pattern.test(text)) return false;
    at = pattern.lastIndex;
    return true;
  };
  while (takes(OPTION)) while (takes(OPTION_VALUE));
  return text.slice(at);
}

async function read(name: string, total: Total): Promise<Uint8Array> {
  try {
    return await readRegular(name, total);
  } catch (error) {
    if (error instanceof EngineError) throw error;
    const { code } = error as NodeJS.ErrnoException;
    const reason =
      code === 'ENOENT' ? 'there is no such file' : code === 'EISDIR' ? 'it is a folder' : messageOf(error);
    throw new EngineError('missing-file', `${name}: ${reason}.`, { file: name });
  }
}

/** Refuses devices and pipes before reading, because a device may never end and a pipe may never begin. */
async function readRegular(name: string, total: Total): Promise<Uint8Array> {
  const file = await open(name, constants.O_RDONLY | constants.O_NONBLOCK);
  try {
    const stats = await file.stat();
    if (!stats.isFile() && !stats.isDirectory()) throw new Error('it is a device, a pipe or a socket, not a file');
    total.bytes += stats.size;
    checkImportSize(total.bytes);
    return await file.readFile();
  } finally {
    await file.close();
  }
}

/** URIs of the buffers and images of a .gltf; null for other files. The engine reports invalid JSON. */
function urisOf(bytes: Uint8Array): string[] | null {
  if (!isJson(bytes)) return null;
  const { buffers, images } = resourceUris(parseGltf(new TextDecoder().decode(bytes)));
  return [...new Set([...buffers, ...images])];
}

const isJson = (bytes: Uint8Array): boolean => /^[\uFEFF\s]*\{/.test(new TextDecoder().decode(bytes.subarray(0, 64)));

/** The name by which the engine finds a URI's file. */
const nameBeside = (gltf: string, uri: string): string => beside(toSlashes(gltf), decodedUri(uri));

/** The file of a URI; null if it is missing or outside the folder, which the engine reports. */
async function readBeside(gltf: string, uri: string, total: Total): Promise<Uint8Array | null> {
  if (isExternal(uri)) return null;
  try {
    const folder = await realpath(path.dirname(gltf));
    const wanted = decodedUri(uri).replaceAll('\\', '/');
    // macOS decomposes accents in file names, and other systems do not.
    const spellings = [wanted, wanted.normalize('NFC'), wanted.normalize('NFD')];
    const found = await Promise.any(spellings.map((one) => realpath(path.resolve(folder, one))));
    return isBelow(folder, found) ? await readRegular(found, total) : null;
  } catch (error) {
    if (error instanceof EngineError) throw error;
    return null;
  }
}

/** The root already ends with a slash. */
export const isBelow = (folder: string, file: string): boolean =>
  file.startsWith(folder.endsWith(path.sep) ? folder : folder + path.sep);

const toSlashes = (name: string): string => name.replaceAll(path.sep, '/');
