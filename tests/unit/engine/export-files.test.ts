/** Additional files of an export: point caches, materials, weights of a slider. */
import { describe, expect, it } from 'vitest';
import { materialFiles, materialLibrary } from '../../../web/engine/caller/material-library.ts';
import { PointCache } from '../../../web/engine/caller/point-cache.ts';
import { keyWeights } from '../../../web/engine/caller/principal-targets.ts';
import { sliderFiles } from '../../../web/engine/caller/slider-files.ts';
import { targetNames } from '../../../web/engine/caller/target-names.ts';
import type { Material, Scene } from '../../../web/engine/api/types.ts';

const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);
const planned = {
  times: [0, 0.25, 0.5, 1],
  seconds: [0, 0.25, 0.5, 1],
  stills: [-1],
  poses: 0,
  principal: null,
  error: 0,
};

describe('a point cache', () => {
  it('is a PC2 with its header and all positions, little-endian', () => {
    const cache = new PointCache('pc2', { seconds: [0, 1] }, 1);
    cache.add(Float32Array.of(1, 2, 3));
    cache.add(Float32Array.of(4, 5, 6));
    const view = new DataView(cache.bytes.buffer);
    expect(text(cache.bytes.subarray(0, 12))).toBe('POINTCACHE2\0');
    expect([12, 16, 28].map((at) => view.getInt32(at, true))).toEqual([1, 1, 2]);
    expect([20, 24, 32, 44, 52].map((at) => view.getFloat32(at, true))).toEqual([0, 1, 1, 4, 6]);
    expect(cache.bytes).toHaveLength(32 + 24);
  });

  it('is an MDD with the seconds of its samples, big-endian', () => {
    const cache = new PointCache('mdd', { seconds: [0, 0.5] }, 1);
    cache.add(Float32Array.of(1, 2, 3));
    cache.add(Float32Array.of(4, 5, 6));
    const view = new DataView(cache.bytes.buffer);
    expect([view.getInt32(0), view.getInt32(4)]).toEqual([2, 1]);
    expect([8, 12, 16, 28, 36].map((at) => view.getFloat32(at))).toEqual([0, 0.5, 1, 4, 6]);
    expect(cache.bytes).toHaveLength(16 + 24);
  });

  it('is refused if it would be too large', () => {
    expect(() => new PointCache('pc2', { seconds: Array(1000).fill(0) }, 1e6)).toThrow('12.0 GB');
  });
});

const material = (name: string, more: object = {}): Material =>
  ({
    name,
    baseColor: [1, 0.2140411, 0, 0.5],
    metallic: 0,
    roughness: 1,
    alphaMode: 'OPAQUE',
    emissive: [0, 0, 0],
    baseColorImage: -1,
    normalImage: -1,
    emissiveImage: -1,
    ...more,
  }) as unknown as Material;

describe('materials of an OBJ', () => {
  const scene = {
    materials: [material('red skin'), material('red_skin', { baseColorImage: 0, alphaMode: 'BLEND' }), material('')],
    images: [{ mimeType: 'image/png', bytes: Uint8Array.of(1), scale: 1 }],
  } as unknown as Scene;

  it('have unique names without spaces', () => {
    const { file, names } = materialLibrary('my cat', scene);
    expect(file).toBe('my_cat.mtl');
    expect(names).toEqual(['red_skin', 'red_skin_2', 'material_3']);
  });

  it.each([
    ['skin skin_3 skin', 'skin skin_3 skin_4'],
    ['skin skin skin_2 skin_2', 'skin skin_3 skin_2 skin_2_4'],
    ['a\tb a_b a\u009bb a_b_2', 'a_b a_b_3 a_b_4 a_b_2'],
    ['material_2  material_2', 'material_2 material_2_2 material_2_3'],
  ])('%j are different, and given names stay with the first that has them', (given, names) => {
    const materials = given.split(' ').map((name) => material(name));
    expect(materialLibrary('m', { ...scene, materials }).names.join(' ')).toBe(names);
  });

  it('are described with their textures, in sRGB colours', () => {
    const files = materialFiles('cat', scene);
    expect(files.map(({ name }) => name)).toEqual(['cat.mtl', 'cat-texture-1.png']);
    const library = text(files[0]!.bytes);
    expect(library).toContain('newmtl red_skin\nKd 1 0.5 0\n');
    expect(library).toContain('d 0.5');
    expect(library).toContain('map_Kd cat-texture-1.png');
    expect(materialFiles('cat', { ...scene, materials: [] })).toEqual([]);
  });
});

describe('morph targets', () => {
  it('are named after their keys and times', () => {
    expect(targetNames(['rest', 'bent', 'away'], [0, 0.5, -1], planned)).toEqual([
      't=0.25',
      'bent t=0.5',
      't=1',
      'away t=-1',
    ]);
    expect(targetNames(['rest', 'bent'], [0, 1], { ...planned, stills: [], poses: 2 }).slice(-3)).toEqual([
      'bent t=1',
      'rest as given',
      'bent as given',
    ]);
  });

  it('of keys fade out while the next fades in; a loop returns to the first', () => {
    const keys = [0, 1, 3];
    expect([-1, 0, 0.25, 1, 2, 3, 9].map((t) => keyWeights(keys, null, t))).toEqual([
      [0, 0],
      [0, 0],
      [0.25, 0],
      [1, 0],
      [0.5, 0.5],
      [0, 1],
      [0, 1],
    ]);
    expect([3, 3.5, 4, 5, -0.5].map((t) => keyWeights(keys, 4, t))).toEqual([
      [0, 1],
      [0, 0.5],
      [0, 0],
      [1, 0],
      [0, 0.5],
    ]);
  });

  it('that are blended have a table of weights and drivers for Blender', () => {
    const principal = {
      shapes: [],
      corrections: 1,
      error: 0,
      weights: Float32Array.of(0, 0, 0.5, 1, 1, 0),
    };
    const frames = { ...planned, times: [0, 0.5, 1], principal };
    const names = targetNames(['a', '=b'], [0, 1], frames);
    expect(names).toEqual(['=b t=1', 'in-between 1']);
    const [table, script] = sliderFiles('bend', names, frames).map(({ bytes }) => text(bytes));
    expect(table).toBe('slider,"\'=b t=1","in-between 1"\n0,0,0\n0.5,0.5,1\n1,1,0\n');
    expect(script).toContain('TIMES = [0,0.5,1]');
    expect(script).toContain('"in-between 1": [0,1,0],');
  });
});
