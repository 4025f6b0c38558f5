import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { foundText, fuzzArguments } from '../../wasm/toolchain/fuzz.mjs';

const known = ['gltf', 'obj'];

describe('npm run fuzz', () => {
  it('accepts seconds and a target, either or none', () => {
    expect(fuzzArguments([], known)).toEqual({ seconds: 60, importers: known });
    expect(fuzzArguments(['5'], known)).toEqual({ seconds: 5, importers: known });
    expect(fuzzArguments(['obj'], known)).toEqual({ seconds: 60, importers: ['obj'] });
    expect(fuzzArguments(['120', 'gltf_fuzz'], known)).toEqual({ seconds: 120, importers: ['gltf'] });
  });

  it.each([[['0']], [['-5']], [['1.5']], [['stl']], [['5', 'stl']], [['5', 'obj', 'gltf']], [['obj', '5']]])(
    'refuses %j',
    (args) => {
      expect(() => fuzzArguments(args, known)).toThrow('usage: npm run fuzz');
    },
  );

  it('states where an input is and how to keep it for replays', () => {
    const text = foundText('obj', fileURLToPath(new URL('../../build/cmake-fuzz/found/obj/crash-1', import.meta.url)));
    expect(foundText('draco', '/x/build/fuzz-decoders/draco/broken-1')).toContain(
      'tests/fuzz/found/draco/WHAT-IS-THE-MATTER.glb',
    );
    expect(text).toContain('cp build/cmake-fuzz/found/obj/crash-1 tests/fuzz/found/obj/WHAT-IS-THE-MATTER.obj');
  });
});
