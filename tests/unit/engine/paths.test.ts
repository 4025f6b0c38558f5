import { describe, expect, it } from 'vitest';
import { beside, decodedUri, findByUri, modelName, resourceUris } from '../../../web/engine/api/paths.ts';

const file = (name: string) => ({ name, bytes: new Uint8Array() });
const found = (uri: string, from: string, names: string[]) => findByUri(uri, from, names.map(file))?.name;

describe('paths', () => {
  it('are joined from the folder of the file that names them', () => {
    expect(beside('walk/a.gltf', '../skin/./a.png')).toBe('skin/a.png');
    expect(beside('a.gltf', 'skin\\a.png')).toBe('skin/a.png');
  });

  it('keep what is no escape', () => {
    expect(decodedUri('100%25 a%20b%C3%A4')).toBe('100% a bä');
    expect(decodedUri('50% off%zz.png')).toBe('50% off%zz.png');
    expect(decodedUri('broken%FF.png')).toBe('broken%FF.png');
  });

  it('name a model by its own word', () => {
    expect(['walk\\key.1.GLB', 'a/notes.txt', 'b/plain'].map(modelName)).toEqual(['key.1', 'notes.txt', 'plain']);
  });
});

describe('a URI in a file', () => {
  it('finds the file by path, or by name alone where folders are missing', () => {
    expect(found('skin%20a.png', 'walk/a.gltf', ['skin a.png', 'walk/skin a.png'])).toBe('walk/skin a.png');
    expect(found('images/a.png', 'walk/a.gltf', ['a.png'])).toBe('a.png');
    expect(found('images/a.png', 'a.gltf', ['x/a.png', 'y/a.png'])).toBeUndefined();
  });

  it('never leaves the given files', () => {
    for (const uri of ['https://example.com/a.png', '/a.png', '%2Fa.png', 'C:a.png', '../a.png'])
      expect(found(uri, 'a.gltf', ['a.png'])).toBeUndefined();
    expect(found('../a.png', 'walk/a.gltf', ['a.png'])).toBe('a.png');
  });

  it('is listed from any JSON at all', () => {
    expect(resourceUris({ buffers: [{ uri: 'a.bin' }, null, {}], images: [{ uri: 'data:,' }, { uri: 7 }] })).toEqual({
      buffers: ['a.bin'],
      images: [],
    });
    for (const json of [null, 3, 'x', { buffers: {} }]) expect(resourceUris(json)).toEqual({ buffers: [], images: [] });
  });
});
