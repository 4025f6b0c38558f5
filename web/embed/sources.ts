/** Reads the sources of an element's keys. */
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { parseGltf } from '../engine/api/gltf-json.ts';
import { beside, decodedUri, extensionOf, fileName, isModel, resourceUris, urlBeside } from '../engine/api/paths.ts';
import type { InputFile } from '../engine/api/types.ts';
import type { Making } from './shared.ts';

/** A URL, or an object with the bytes. */
export type KeySource = string | URL | Blob | ArrayBuffer | Uint8Array;

export interface Sources {
  list: readonly KeySource[];
  /** Key times of the children; null unless all children have one. */
  times: number[] | null;
}

/** Keys from a page: a list, the files of an input, or a single source. */
export function listOf(given: unknown): readonly KeySource[] | null {
  if (given === null || given === undefined) return null;
  if (Array.isArray(given)) return given as KeySource[];
  return globalThis.FileList && given instanceof FileList ? [...given] : [given as KeySource];
}

/** The property `keys` takes precedence over `src`, and `src` over children. */
export function sourcesOf(keys: readonly KeySource[] | null, src: string, element: Element): Sources {
  if (keys && keys.length > 0) return { list: keys, times: null };
  if (src !== '') return { list: src.split(/\s+/), times: null };
  const children = [...element.querySelectorAll(':scope > source[src]')];
  const times = children.map((child) => Number.parseFloat(child.getAttribute('time') ?? ''));
  return {
    list: children.map((child) => child.getAttribute('src')!),
    times: children.length > 0 && times.every(Number.isFinite) ? times : null,
  };
}

let numbered = 0;
const numbers = new WeakMap<object, number>();

/** Throws if the text is not a valid URL. */
function addressOf(source: string | URL, key: number, base: string): URL {
  if (URL.canParse(source, base)) return new URL(source, base);
  throw new EngineError('not-found', `“${source}” is not a valid URL. Check the URL of key ${key + 1}.`, { key });
}

/** Identifies a source by its URL or by the object itself. Throws for invalid URLs and unsupported types. */
export function keyOf(source: KeySource, key: number, base: string): string {
  if (typeof source === 'string' || source instanceof URL) return addressOf(source, key, base).href;
  if (![Blob, ArrayBuffer, Uint8Array].some((kind) => source instanceof kind))
    throw new EngineError(
      'not-a-model',
      `Key ${key + 1} has an unsupported type. Use a URL, a File or Blob, an ArrayBuffer or a Uint8Array.`,
      { key },
    );
  if (!numbers.has(source)) numbers.set(source, ++numbered);
  return `object ${numbers.get(source)}`;
}

/** Reads all sources, and the companion files of a .gltf. */
export async function readSources(list: readonly KeySource[], base: string, making: Making): Promise<InputFile[]> {
  let done = 0;
  const files = await Promise.all(
    list.map(async (source, index) => {
      const read = await readOne(source, index, base, making.signal);
      done += 1;
      making.report({ stage: 'fetching', fraction: done / list.length });
      return read;
    }),
  );
  return withOwnNames(files.flat());
}

async function readOne(source: KeySource, key: number, base: string, signal: AbortSignal): Promise<InputFile[]> {
  if (typeof source === 'string' || source instanceof URL) return fetchModel(addressOf(source, key, base), key, signal);
  const name = nameOf(source instanceof File ? source.name : '', key);
  const bytes = source instanceof Blob ? await source.arrayBuffer() : source;
  return [{ name, bytes: bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes) }];
}

async function fetchModel(url: URL, key: number, signal: AbortSignal): Promise<InputFile[]> {
  const bytes = await fetchBytes(url, key, signal);
  const model = { name: nameOf(fileName(decodedUri(url.pathname)), key), bytes };
  if (extensionOf(model.name) !== 'gltf') return [model];
  const { buffers, images } = resourceUris(parseGltf(new TextDecoder().decode(bytes)));
  // Fetches only companions in the model's own folder; the engine reports missing ones.
  const resources = [...new Set([...buffers, ...images])].flatMap((uri) => {
    const resource = urlBeside(uri, url);
    return resource === null ? [] : [{ name: beside(model.name, decodedUri(uri)), resource }];
  });
  const read = resources.map(async ({ name, resource }) => ({ name, bytes: await fetchBytes(resource, key, signal) }));
  return [model, ...(await Promise.all(read))];
}

async function fetchBytes(url: URL, key: number, signal: AbortSignal): Promise<Uint8Array> {
  const response = await fetch(url, { signal }).catch((error: unknown) => {
    if (signal.aborted) throw error;
    const reason =
      url.origin === globalThis.location?.origin
        ? messageOf(error)
        : 'the connection failed, or that site sends no CORS headers';
    throw refused('not-found', `Could not fetch ${url.href} (${reason}).`, url, key);
  });
  const { status, statusText } = response;
  if (!response.ok)
    throw refused(
      'not-found',
      `Could not fetch ${url.href} (${`${status} ${statusText}`.trim()}). Check the URL.`,
      url,
      key,
    );
  const bytes = new Uint8Array(await response.arrayBuffer());
  // A host may return an HTML page with status 200 for a missing file.
  if (/^\s*<(!doctype|html|head|body)\b/i.test(new TextDecoder().decode(bytes.subarray(0, 64))))
    throw refused(
      'not-a-model',
      `${url.href} returned a web page instead of a model. Check the URL, and that the file exists.`,
      url,
      key,
    );
  return bytes;
}

const refused = (code: string, message: string, url: URL, key: number): EngineError =>
  new EngineError(code, message, { file: fileName(url.pathname), key });

/** Names without a model's extension are read as GLB. */
const nameOf = (name: string, key: number): string => (isModel(name) ? name : `${name || `key-${key + 1}`}.glb`);

/** Makes names unique, because files of different folders can have equal names. */
function withOwnNames(files: InputFile[]): InputFile[] {
  const taken = new Set<string>();
  return files.map((file, index) => {
    const name = taken.has(file.name) ? `${index}-${file.name}` : file.name;
    taken.add(name);
    return { ...file, name };
  });
}
