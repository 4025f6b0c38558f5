/** Files saved by glTF-Transform open in the engine. */
import { WebIO, type Transform } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import {
  dedup,
  join,
  meshopt,
  prune,
  quantize,
  reorder,
  resample,
  simplify,
  sparse,
  weld,
} from '@gltf-transform/functions';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import { beforeAll, describe, expect, it } from 'vitest';
import { largestDistance } from '../engine/support/shapes.ts';
import { engine, paintedMotion, type Made } from './made.ts';

let made: Made;
beforeAll(async () => {
  await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready, MeshoptSimplifier.ready]);
  made = await paintedMotion();
});

async function through(bytes: Uint8Array, ...transforms: Transform[]): Promise<Uint8Array> {
  const io = new WebIO()
    .registerExtensions(ALL_EXTENSIONS)
    .registerDependencies({ 'meshopt.encoder': MeshoptEncoder, 'meshopt.decoder': MeshoptDecoder });
  const document = await io.readBinary(bytes as Uint8Array<ArrayBuffer>);
  await document.transform(...transforms);
  return io.writeBinary(document);
}

/** The defaults of glTF-Transform's `optimize`, except for textures and simplification. */
const optimised = (): Transform[] => [
  dedup(),
  join(),
  weld(),
  resample(),
  prune({ keepAttributes: false, keepLeaves: false }),
  sparse(),
  meshopt({ encoder: MeshoptEncoder, level: 'high' }),
];

describe('an exported GLB', () => {
  it.each([
    ['read and written', () => []],
    ['reordered', () => [reorder({ encoder: MeshoptEncoder })]],
    ['quantised', () => [quantize()]],
    ['optimised', optimised],
  ] as const)('that was %s opens as the same project, with its vertices and faces', async (_, transforms) => {
    const bytes = await through(await made.glb({ frames: 9 }), ...transforms());
    const again = await engine.importKeyframes([{ name: 'again.glb', bytes }]);
    expect(again.info.project).toEqual(made.sequence.options);
    expect(again.info.names).toEqual(made.keys.info.names);
    expect(again.info.warnings.map(({ code }) => code)).toEqual([]);
    for (let key = 0; key < 3; key += 1)
      expect(largestDistance(again.positions(key), made.keys.positions(key))).toBeLessThan(3e-4 * made.diagonal);
  });

  it('with a simplified mesh opens, with a warning', async () => {
    const thin = simplify({ simplifier: MeshoptSimplifier, ratio: 0.3, error: 0.5 });
    const bytes = await through(await made.glb({ frames: 9 }), weld(), thin);
    const again = await engine.importKeyframes([{ name: 'thin.glb', bytes }]);
    const [warning] = again.info.warnings.filter(({ code }) => code === 'project-mesh-changed');
    expect(warning?.message).toContain('Another program changed the mesh of this project');
    expect(again.info.report.faces).toBeLessThan(made.keys.info.report.faces);
    await engine.createSequence(again, { ...again.info.project });
  });
});
