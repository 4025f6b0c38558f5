import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import {
  beside,
  decodedUri,
  isImportable,
  isModel,
  modelName,
  withSpellings,
  withoutLeftovers,
  resolveUri,
  resourceUris,
  uriError,
  siblingUrl,
} from '../../../web/engine/api/paths.ts';

interface UriCases {
  sentences: Record<'external' | 'outside' | 'missing', string>;
  cases: { uri: string; from: string; files: string[]; finds?: string; is?: string; said?: string }[];
  /** URL of the model, and URLs of its files to fetch: only those on the same host. */
  model: string;
  fetched: Record<string, string>;
  unfetched: string[];
}

const shared = JSON.parse(readFileSync(new URL('../../uri-cases.json', import.meta.url), 'utf8')) as UriCases;

const file = (name: string) => ({ name, bytes: new Uint8Array() });
describe('paths', () => {
  it('are relative to the folder of the file that names them', () => {
    expect(beside('walk/a.gltf', '../skin/./a.png')).toBe('skin/a.png');
    expect(beside('a.gltf', 'skin\\a.png')).toBe('skin/a.png');
  });

  it('keep invalid escapes', () => {
    expect(decodedUri('100%25 a%20b%C3%A4')).toBe('100% a bä');
    expect(decodedUri('50% off%zz.png')).toBe('50% off%zz.png');
    expect(decodedUri('broken%FF.png')).toBe('broken%FF.png');
  });

  it('of operating system files are ignored, unless there are no others', () => {
    const left = ['._a.obj', 'x/._a.glb', '.DS_Store', 'Thumbs.db', 'thumbs.db', 'desktop.ini', '__MACOSX/a.obj'];
    expect(left.filter(isModel)).toEqual([]);
    expect(left.filter(isImportable)).toEqual([]);
    const names = (of: string[]): string[] => withoutLeftovers(of.map(file)).map(({ name }) => name);
    expect(names([...left, 'a.obj', 'thumbs.obj', 'a.blend'])).toEqual(['a.obj', 'thumbs.obj', 'a.blend']);
    expect(names(['Thumbs.db'])).toEqual(['Thumbs.db']);
    expect(['a.glb.txt', 'a.txt', 'a.obj.TXT'].filter(isModel)).toEqual(['a.glb.txt', 'a.obj.TXT']);
    expect(['.hidden.obj', 'notes.txt', 'a.PLY', 'a.mdd', 'a.mtl'].filter(isImportable)).toEqual([
      'a.PLY',
      'a.mdd',
      'a.mtl',
    ]);
  });

  it('use the base name of a model', () => {
    expect(['walk\\key.1.GLB', 'a/notes.txt', 'b/plain'].map(modelName)).toEqual(['key.1', 'notes.txt', 'plain']);
  });
});

describe('a URI in a file', () => {
  it.each(shared.cases)('$uri in $from, beside $files', ({ uri, from, files, finds, is, said = uri }) => {
    const target = resolveUri(uri, from, files.map(file));
    if (target.kind === 'file') return expect(target.file.name).toBe(finds);
    expect(target.kind).toBe(is);
    const sentence = shared.sentences[target.kind].replace('FILE', 'a.gltf').replace('URI', said);
    expect(uriError(target.kind, uri, from)).toMatchObject({
      message: sentence,
      code: is === 'missing' ? 'missing-resource' : 'external-resource',
    });
  });

  it.each(Object.entries(shared.fetched))('of a model from the web leads into its folder: %j', (uri, path) => {
    expect(siblingUrl(uri, new URL(shared.model))?.href).toBe(new URL(`/${path}`, shared.model).href);
  });

  it.each(shared.unfetched)('of a model from the web leads nowhere else: %j', (uri) => {
    expect(siblingUrl(uri, new URL(shared.model))).toBeNull();
  });

  it.each(['data:model/gltf+json,{}', 'blob:https://example.org/a.gltf'])('leads to no file from %s', (model) => {
    for (const uri of ['a.png', 'https://example.org/a.png']) expect(siblingUrl(uri, new URL(model))).toBeNull();
  });

  it('is listed from any JSON', () => {
    expect(resourceUris({ buffers: [{ uri: 'a.bin' }, null, {}], images: [{ uri: 'data:,' }, { uri: 7 }] })).toEqual({
      buffers: ['a.bin'],
      images: [],
    });
    for (const json of [null, 3, 'x', { buffers: {} }]) expect(resourceUris(json)).toEqual({ buffers: [], images: [] });
  });
});

it('companions get composed and decomposed names, and models composed ones', () => {
  const [composed, decomposed] = ['Gr\u00f6\u00dfe', 'Gro\u0308\u00dfe'];
  const names = (...given: string[]): string[] =>
    withSpellings(given.map((name) => ({ name }))).map(({ name }) => name);
  expect(names('a.bin', `${decomposed}.obj`)).toEqual(['a.bin', `${composed}.obj`]);
  for (const form of [composed, decomposed])
    expect(names(`${form}/${form}.PNG`)).toEqual([
      `${composed}/${composed}.PNG`,
      `${decomposed}/${decomposed}.PNG`,
      `${composed}/${decomposed}.PNG`,
    ]);
});
