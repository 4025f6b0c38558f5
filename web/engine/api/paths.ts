/**
 * Names and paths of given files, and URIs in them that refer to other files. All path parsing is here, except for disk
 * access (`web/cli`). `wasm/io/base/uri` follows the same rules for files that only the core reads;
 * `tests/uri-cases.json` tests both.
 */
import { EngineError } from './errors.ts';
import type { InputFile } from './types.ts';

export const MODELS: readonly string[] = ['glb', 'gltf', 'obj', 'ply', 'off'];
/** Point caches: motions of a model's vertices in a separate file. */
export const CACHES: readonly string[] = ['pc2', 'mdd'];
/** Companion files of a model. */
export const COMPANIONS: readonly string[] = ['bin', 'mtl', 'png', 'jpg', 'jpeg', 'webp', 'ktx2'];

const IMPORTABLE: readonly string[] = [...MODELS, ...CACHES, ...COMPANIONS];

/** Longest quote from an untrusted file in a message, in characters. */
const LONGEST_QUOTE = 80;
/** Control characters, and marks that change how text is displayed; the core has the same list. */
const NO_TEXT = /[\p{Cc}\p{Cs}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/gu;

const nameStart = (path: string): number => Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1;

/** The path without folders. */
export const fileName = (path: string): string => path.slice(nameStart(path));

/** The extension in lower case without the dot; '' without an extension. */
export const extensionOf = (path: string): string => /\.([^./\\]*)$/.exec(path)?.[1]?.toLowerCase() ?? '';

/** Files that operating systems leave in folders, even with model extensions: ._walk.obj, Thumbs.db. */
export const isLeftover = (path: string): boolean =>
  /^(\._.*|\.ds_store|\.localized|(eh)?thumbs\.db|desktop\.ini|icon\r)$/is.test(fileName(path)) ||
  /(^|[/\\])__MACOSX[/\\]/.test(path);

/** Removes leftovers, unless all files are leftovers. */
export function withoutLeftovers<T extends { name: string }>(files: readonly T[]): T[] {
  const importable = files.filter(({ name }) => !isLeftover(name));
  return importable.length > 0 ? importable : [...files];
}

/** The extension without a .txt after it, which some programs append: walk.glb.txt. */
const innerExtension = (path: string): string => extensionOf(path.replace(/\.txt$/i, ''));

export const isModel = (path: string): boolean => MODELS.includes(innerExtension(path)) && !isLeftover(path);

/** Whether a file of a given folder belongs to the input: a model, its motion, or a companion. Hidden files do not. */
export const isImportable = (path: string): boolean =>
  !fileName(path).startsWith('.') && !isLeftover(path) && IMPORTABLE.includes(innerExtension(path));

/**
 * The files with composed names (NFC). macOS decomposes accents, and models refer to companions in either form, so
 * companions also get decomposed names. Their bytes are shared.
 */
export function withSpellings<T extends { name: string }>(files: readonly T[]): T[] {
  const composed = files.map((file) => ({ ...file, name: file.name.normalize('NFC') }));
  const names = new Set(composed.map(({ name }) => name));
  const others = composed.flatMap((file) => {
    if (!COMPANIONS.includes(extensionOf(file.name))) return [];
    // A model in a composed folder may refer to a decomposed name.
    const parts = file.name.split(/(?<=[/\\])/);
    const spellings = parts.map((_, i) => parts.slice(0, i).join('') + parts.slice(i).join('').normalize('NFD'));
    return [...new Set(spellings)].filter((name) => !names.has(name)).map((name) => ({ ...file, name }));
  });
  return [...composed, ...others];
}

/** Equal for names of one file, however it is spelled. */
export const nameKey = (path: string): string => normalised(path.normalize('NFC'));

/** A model's name without folders and extension, as the user knows it. */
export function modelName(path: string): string {
  const name = fileName(path);
  return isModel(name) ? name.slice(0, name.lastIndexOf('.')) : name;
}

/** Resolves a path relative to the file `from`. */
export const beside = (from: string, path: string): string => normalised(from.slice(0, nameStart(from)) + path);

/** Keeps invalid escapes. */
export function decodedUri(uri: string): string {
  return uri.replace(/(%[0-9a-f]{2})+/gi, (escaped) => {
    try {
      return decodeURIComponent(escaped);
    } catch {
      return escaped;
    }
  });
}

/** The start of a URI without leading spaces and line breaks, as in browsers; sufficient to find a scheme. */
function headOf(uri: string): string {
  let start = 0;
  while (uri.charAt(start) !== '' && uri.charAt(start) <= ' ') start += 1;
  return uri.slice(start, start + HEAD).replace(/[\t\n\r]/g, '');
}
const HEAD = 64;

/** Whether the URI has another host or scheme; a single letter is a Windows drive. */
const isElsewhere = (uri: string): boolean => /^([a-z][a-z0-9+.-]+:|\/\/)/i.test(headOf(uri));

const isAbsolute = (path: string): boolean => /^([a-z][a-z0-9+.-]*:|[/\\])/i.test(headOf(path));

/** Whether the path leaves its starting folder. */
const leaves = (path: string): boolean => /^\.\.(\/|$)/.test(normalised(path));

/** Whether the URI has another host, scheme or root. */
export const isExternal = (uri: string): boolean => isElsewhere(uri) || isAbsolute(decodedUri(uri));

/**
 * Resolves a URI in a model from the web. null if it leaves the model's folder: another host, another scheme, or a
 * parent folder. Also null if it would leave the folder on a host that decodes %2F or %5C.
 */
export function siblingUrl(uri: string, model: URL): URL | null {
  if (!/^(https?|file):$/.test(model.protocol) || !URL.canParse(uri, model)) return null;
  const url = new URL(uri, model);
  const isSameHost = url.protocol === model.protocol && url.host === model.host && url.username + url.password === '';
  const folder = decodedUri(model.pathname.slice(0, model.pathname.lastIndexOf('/') + 1));
  const path = decodedUri(url.pathname);
  const inside = path.startsWith(folder) && !leaves(path.slice(folder.length)) && !/[/\\]\.\.([/\\]|$)/.test(path);
  return isSameHost && inside ? url : null;
}

/** URIs of the buffers and images of a glTF, except those with embedded bytes. The JSON is untrusted. */
export function resourceUris(json: unknown): { buffers: string[]; images: string[] } {
  const { buffers, images } = (json ?? {}) as Record<string, unknown>;
  const uris = (list: unknown): string[] =>
    (Array.isArray(list) ? list : [])
      .map((entry) => (entry as { uri?: unknown } | null)?.uri)
      .filter((uri): uri is string => typeof uri === 'string' && !uri.startsWith('data:'));
  return { buffers: uris(buffers), images: uris(images) };
}

/** Target of a URI in a file. */
export type UriTarget =
  | { kind: 'file'; file: InputFile }
  /** The URI has another host or scheme. */
  | { kind: 'external' }
  /** A path outside the given files. */
  | { kind: 'outside' }
  | { kind: 'missing' };

/** Resolves a URI in the file `from`: by path, or by name alone if files were given without folders. */
export function resolveUri(uri: string, from: string, files: readonly InputFile[]): UriTarget {
  if (isElsewhere(uri)) return { kind: 'external' };
  const path = decodedUri(uri);
  if (isAbsolute(path)) return { kind: 'outside' };
  const wanted = beside(from, path);
  const file = files.find(({ name }) => normalised(name) === wanted) ?? findByName(path, files);
  if (file) return { kind: 'file', file };
  return { kind: leaves(path) ? 'outside' : 'missing' };
}

function findByName(path: string, files: readonly InputFile[]): InputFile | undefined {
  if (leaves(path)) return undefined;
  const [file, ...others] = files.filter(({ name }) => fileName(name) === fileName(path));
  return others.length === 0 ? file : undefined;
}

/** The reason why a URI in the file `from` has no bytes. */
export function uriError(kind: Exclude<UriTarget['kind'], 'file'>, uri: string, from: string): EngineError {
  const name = fileName(from);
  const text = [...uri];
  const shown = text.slice(0, LONGEST_QUOTE).join('').replace(NO_TEXT, '?');
  const quoted = `"${shown}${text.length > LONGEST_QUOTE ? '...' : ''}"`;
  const sentence = {
    external: `${name} refers to ${quoted}. Only the given files are read. Save that file in the same folder, change the reference to its name, and give both together.`,
    outside: `${name} refers to ${quoted}, which is outside the given files. Save that file in the same folder, change the reference to its name, and give both together.`,
    missing: `${name} needs the file ${quoted}, which was not given. Give both files together.`,
  }[kind];
  return new EngineError(kind === 'missing' ? 'missing-resource' : 'external-resource', sentence, { file: name });
}

/** Joins the parts with slashes and resolves '.' and '..'. */
function normalised(path: string): string {
  const parts: string[] = [];
  for (const part of path.split(/[/\\]/)) {
    if (part === '..' && parts.length > 0 && parts.at(-1) !== '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return parts.join('/');
}
