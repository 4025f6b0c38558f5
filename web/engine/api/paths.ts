/**
 * Names and paths of given files, and the URIs in them that name other files. They are taken apart, joined and decoded
 * here and nowhere else, but for what the disk needs (`web/cli`). `wasm/io/base/uri` follows the same rules for what only
 * the core reads.
 */
import type { InputFile } from './types.ts';

export const MODELS: readonly string[] = ['glb', 'gltf', 'obj', 'ply', 'off'];
/** Files that a model may need. */
export const COMPANIONS: readonly string[] = ['bin', 'mtl', 'png', 'jpg', 'jpeg', 'webp', 'ktx2'];

const nameStart = (path: string): number => Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1;

/** Without its folders. */
export const fileName = (path: string): string => path.slice(nameStart(path));

/** In lower case, without the dot; '' where there is none. */
export const extensionOf = (path: string): string => /\.([^./\\]*)$/.exec(path)?.[1]?.toLowerCase() ?? '';

export const isModel = (path: string): boolean => MODELS.includes(extensionOf(path));

/** A model's name without folders and extension: the user's own word for it. */
export function modelName(path: string): string {
  const name = fileName(path);
  return isModel(name) ? name.slice(0, name.lastIndexOf('.')) : name;
}

/** Where a path leads that is seen from the file `from`. */
export const beside = (from: string, path: string): string => normalised(from.slice(0, nameStart(from)) + path);

/** Escapes that are none stay as they are. */
export function decodedUri(uri: string): string {
  return uri.replace(/(%[0-9a-f]{2})+/gi, (escaped) => {
    try {
      return decodeURIComponent(escaped);
    } catch {
      return escaped;
    }
  });
}

/** Names another host, scheme or root. */
export const isExternal = (uri: string): boolean => /^([a-z][a-z0-9+.-]*:|[/\\])/i.test(decodedUri(uri));

/**
 * URIs of the buffers and images of a glTF, but for those that hold the bytes themselves. The JSON is trusted in
 * nothing.
 */
export function resourceUris(json: unknown): { buffers: string[]; images: string[] } {
  const { buffers, images } = (json ?? {}) as Record<string, unknown>;
  const uris = (list: unknown): string[] =>
    (Array.isArray(list) ? list : [])
      .map((entry) => (entry as { uri?: unknown } | null)?.uri)
      .filter((uri): uri is string => typeof uri === 'string' && !uri.startsWith('data:'));
  return { buffers: uris(buffers), images: uris(images) };
}

/**
 * The file that a URI in the file `from` names: by its path, or by its name alone where files came without their
 * folders.
 */
export function findByUri(uri: string, from: string, files: readonly InputFile[]): InputFile | undefined {
  if (isExternal(uri)) return undefined;
  const path = decodedUri(uri);
  const wanted = beside(from, path);
  const exact = files.find((file) => normalised(file.name) === wanted);
  if (exact || normalised(path).startsWith('..')) return exact;
  const byName = files.filter((file) => fileName(file.name) === fileName(path));
  return byName.length === 1 ? byName[0] : undefined;
}

/** Joined by slashes, with '.' and '..' resolved. */
function normalised(path: string): string {
  const parts: string[] = [];
  for (const part of path.split(/[/\\]/)) {
    if (part === '..' && parts.length > 0 && parts.at(-1) !== '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return parts.join('/');
}
