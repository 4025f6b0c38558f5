/** Reads the sources of an element's keys. */
import { EngineError, messageOf } from '../engine/api/errors.ts';
import { parseGltf } from '../engine/api/gltf-json.ts';
import {
  beside,
  decodedUri,
  extensionOf,
  fileName,
  isImportable,
  isModel,
  resourceUris,
  siblingUrl,
} from '../engine/api/paths.ts';
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
  const sentence = `“${shortened(String(source))}” is not a valid URL. Check the URL of key ${key + 1}.`;
  throw new EngineError('not-found', sentence, { key });
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

/** A file that was read. `folder` is the URL or path of its source's folder; the name is relative to it. */
interface ReadFile extends InputFile {
  folder: string;
}

interface Content {
  bytes: Uint8Array;
  /** The MIME type; '' if unknown. */
  type: string;
}
type Fetch = (url: URL, key: number) => Promise<Content>;

/** Reads all sources, and the companion files of a .gltf. */
export async function readSources(list: readonly KeySource[], base: string, making: Making): Promise<InputFile[]> {
  const fetched = new Map<string, Promise<Content>>();
  const fetchOnce: Fetch = (url, key) => {
    const content = fetched.get(url.href) ?? fetchBytes(url, key, making.signal);
    fetched.set(url.href, content);
    return content;
  };
  let done = 0;
  const files = await Promise.all(
    list.map(async (source, index) => {
      const read = await readOne(source, index, base, fetchOnce);
      done += 1;
      making.report({ stage: 'fetching', fraction: done / list.length });
      return read;
    }),
  );
  return withOwnNames(files.flat());
}

async function readOne(source: KeySource, key: number, base: string, fetchOnce: Fetch): Promise<ReadFile[]> {
  if (typeof source === 'string' || source instanceof URL)
    return fetchModel(addressOf(source, key, base), key, fetchOnce);
  const { type = '', name = '', webkitRelativePath: path = '' } = source as Partial<File>;
  const content = source instanceof Blob ? await source.arrayBuffer() : source;
  const bytes = content instanceof Uint8Array ? content : new Uint8Array(content);
  const folder = path.slice(0, path.length - fileName(path).length);
  return [{ folder, name: nameOf(fileName(name), key, bytes, type), bytes }];
}

async function fetchModel(url: URL, key: number, fetchOnce: Fetch): Promise<ReadFile[]> {
  const { bytes, type } = await fetchOnce(url, key);
  const name = nameOf(nameIn(url), key, bytes, type);
  const folder = hasPath(url) ? new URL('.', url).href : '';
  const model = { folder, name, bytes };
  if (extensionOf(name) !== 'gltf') return [model];
  const { buffers, images } = resourceUris(parseGltf(new TextDecoder().decode(bytes)));
  // Fetches only companions in the model's own folder; the engine reports missing ones.
  const resources = [...new Set([...buffers, ...images])].flatMap((uri) => {
    const resource = siblingUrl(uri, url);
    return resource === null ? [] : [{ name: beside(name, decodedUri(uri)), resource }];
  });
  const read = resources.map(async ({ name, resource }) => ({
    folder,
    name,
    bytes: (await fetchOnce(resource, key)).bytes,
  }));
  return [model, ...(await Promise.all(read))];
}

async function fetchBytes(url: URL, key: number, signal: AbortSignal): Promise<Content> {
  const shown = shortened(url.href);
  const refused = (code: string, message: string): EngineError =>
    new EngineError(code, message, { file: nameIn(url), key });
  const response = await fetch(url, { signal }).catch((error: unknown) => {
    if (signal.aborted) throw error;
    throw refused('not-found', `Could not fetch ${shown} (${whyNotFetched(url, error)}).`);
  });
  const { status, statusText, headers } = response;
  if (!response.ok)
    throw refused('not-found', `Could not fetch ${shown} (${`${status} ${statusText}`.trim()}). Check the URL.`);
  const bytes = new Uint8Array(await response.arrayBuffer());
  // A host may return an HTML page with status 200 for a missing file.
  if (/^\s*<(!doctype|html|head|body)\b/i.test(new TextDecoder().decode(bytes.subarray(0, 64))))
    throw refused(
      'not-a-model',
      `${shown} returned a web page instead of a model. Check the URL, and that the file exists.`,
    );
  return { bytes, type: headers.get('content-type') ?? '' };
}

function whyNotFetched(url: URL, error: unknown): string {
  if (!hasPath(url)) return `it is no longer valid, or the page's policy does not allow ${url.protocol} in connect-src`;
  const isOwn = url.origin === globalThis.location?.origin;
  return isOwn ? messageOf(error) : 'the connection failed, or that site sends no CORS headers';
}

/** Longest URL in a message, and its parts before and after the dots, in characters. */
const [LONGEST, START, END] = [120, 60, 40];

const shortened = (text: string): string =>
  text.length > LONGEST ? `${text.slice(0, START)}...${text.slice(-END)}` : text;

/** Whether the URL has folders and a file name: `data:` and `blob:` do not. */
const hasPath = ({ protocol }: URL): boolean => protocol !== 'data:' && protocol !== 'blob:';

const nameIn = (url: URL): string => (hasPath(url) ? fileName(decodedUri(url.pathname)).slice(-LONGEST) : '');

/** Bytes in which the kind of a file is looked for; an OBJ can begin with long comments. */
const HEAD = 1 << 16;
const KINDS: readonly (readonly [extension: string, start: RegExp])[] = [
  ['glb', /^glTF/],
  ['gltf', /^\s*\{\s*"/],
  ['ply', /^ply\s/],
  ['off', /^\s*(#[^\r\n]*[\r\n]\s*)*[A-Z]{0,4}4?n?OFF\s/],
  ['obj', /^\s*(#[^\r\n]*[\r\n]\s*)*(v[nt]?|[gos]|mtllib|usemtl)\s/],
];

/** The name, with the extension of its content if it has none of a model. The engine reports unknown kinds. */
function nameOf(name: string, key: number, bytes: Uint8Array, type: string): string {
  if (isModel(name)) return name;
  const text = new TextDecoder().decode(bytes.subarray(0, HEAD));
  const kind = KINDS.find(([, start]) => start.test(text))?.[0];
  const extension = kind ?? (/\bobj\b/.test(type) && !isImportable(name) ? 'obj' : '');
  return `${name || `key-${key + 1}`}${extension && '.'}${extension}`;
}

/**
 * Puts the files into numbered folders if different files have equal names, so each key finds its own companions. Names
 * of keys and messages leave folders out. Different files of one folder and name, such as files that a script gives
 * without their folders, belong to the first, second, ... file of that name.
 */
function withOwnNames(files: ReadFile[]): InputFile[] {
  const versions = new Map<string, Set<Uint8Array>>();
  const places = files.map(({ folder, name, bytes }) => {
    const known = versions.get(folder + name) ?? new Set();
    versions.set(folder + name, known.add(bytes));
    return `${[...known].indexOf(bytes)} ${folder}`;
  });
  const folders = [...new Set(places)];
  const names = new Map(files.map(({ name, bytes }) => [name.normalize(), bytes]));
  const isClash = files.some(({ name, bytes }) => names.get(name.normalize()) !== bytes);
  return files.map(({ name, bytes }, index) => ({
    name: isClash ? `${folders.indexOf(places[index]!) + 1}/${name}` : name,
    bytes,
  }));
}
