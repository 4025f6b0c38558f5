import { describe, expect, it } from 'vitest';
import { EngineError } from '../../web/engine/api/errors.ts';
import { bendData, createBend, localCore, localFiles, type LocalCore } from './support/core.ts';
import { meshGlb, poseFiles } from './support/glb.ts';
import { bar, bent } from './support/shapes.ts';
import { IMPORT_DEFAULTS } from '../../web/engine/api/types.ts';

const MIB = 2 ** 20;

/** Allocates all memory that the heap can have; returns a function that frees it. */
function takeAll({ module }: LocalCore): () => void {
  const taken: number[] = [];
  for (let size = 1024 * MIB; size >= 4096; size /= 2) {
    for (let address = module._malloc(size); address !== 0; address = module._malloc(size)) taken.push(address);
  }
  return () => taken.splice(0).forEach((address) => module._free(address));
}

describe('the heap', () => {
  it('does not grow over hundreds of sequences that are made, used and released', async () => {
    const { core } = await localCore();
    const data = bendData();
    const cycle = (): void => {
      const bend = createBend(core, data);
      core.evaluate(bend.motion, 0.3, null);
      core.ask('measure', bend.motion, { times: [0.3], maxMs: 0 });
      bend.release();
    };
    for (let i = 0; i < 10; ++i) cycle();
    const bytes = core.heapBytes;
    for (let i = 0; i < 300; ++i) cycle();
    expect(core.heapBytes).toBe(bytes);
    expect(core.objects).toBe(0);
  });

  it('does not grow over valid and invalid imports, and exports', async () => {
    const { files } = await localFiles();
    const mesh = bar();
    const good = poseFiles(mesh, [mesh.positions, bent(mesh, 30)]);
    const bad = [good[0]!, { name: 'cut.glb', bytes: good[1]!.bytes.slice(0, 5000) }];
    const scene = { uvs: null, colors: null, seams: null, polygons: null, groups: [], materials: [], images: [] };
    const pose = { positions: mesh.positions, normals: mesh.positions };
    const animation = {
      seconds: [0, 1],
      stills: 0,
      weights: null,
      project: '',
      name: '',
      targetNames: [],
      compression: 'none' as const,
      clip: 'a',
      offset: [0, 0, 0] as const,
    };
    const cycle = (): void => {
      files.importKeys(good, IMPORT_DEFAULTS);
      expect(() => files.importKeys(bad, IMPORT_DEFAULTS)).toThrow(EngineError);
      const alone = { library: { file: '', names: [] }, offset: [1, 2, 3] as const, local: false };
      files.writePose({ format: 'ply', faces: mesh.indices, scene, pose, ...alone });
      files.writeAnimation([pose, pose], { ...animation, faces: mesh.indices, scene });
      files.principalOffsets({ frames: [pose.positions, pose.normals], tolerance: 0, max: 2 });
    };
    for (let i = 0; i < 10; ++i) cycle();
    const bytes = files.heapBytes;
    for (let i = 0; i < 100; ++i) cycle();
    expect(files.heapBytes).toBe(bytes);
    expect(files.objects).toBe(0);
  });

  it('may grow between two frames: old frames stay, new ones are right', async () => {
    const { core, module } = await localCore();
    const { motion } = createBend(core);
    const before = core.evaluate(motion, 0.3, null).positions;
    const copy = before.slice();
    const bytes = core.heapBytes;
    const block = module._malloc(bytes);
    expect(core.heapBytes).toBeGreaterThan(bytes);
    expect(before).toEqual(copy);
    expect(core.evaluate(motion, 0.3, null).positions).toEqual(copy);
    module._free(block);
  });

  it('grows in the middle of building a sequence', async () => {
    const { core } = await localCore();
    const small = core.heapBytes;
    const data = bendData(bar(24, 240));
    const { motion } = createBend(core, data);
    expect(core.heapBytes).toBeGreaterThan(small);
    const { positions } = core.evaluate(motion, 0, null);
    expect(positions).toHaveLength(data.positions[0]!.length);
    expect(positions.every(Number.isFinite)).toBe(true);
  });

  it('gives an error with a code if it is full, and works again when there is space', async () => {
    const local = await localCore();
    const data = bendData(bar(8, 80));
    const bend = createBend(local.core, data);
    const wanted = local.core.evaluate(bend.motion, 0.3, null).positions;
    bend.release();
    const giveBack = takeAll(local);
    let code = 'none';
    try {
      createBend(local.core, data);
    } catch (error) {
      code = error instanceof EngineError ? error.code : String(error);
    }
    giveBack();
    expect(code).toBe('out-of-memory');
    const again = createBend(local.core, data);
    expect(local.core.evaluate(again.motion, 0.3, null).positions).toEqual(wanted);
  });

  it('is addressed correctly beyond 2 GB', async () => {
    const [{ core, module }, { files, module: ofFiles }] = [await localCore(), await localFiles()];
    const blocks = [module, ofFiles].flatMap((one) => [1, 2, 3].map(() => one._malloc(800 * MIB)));
    expect(blocks.every((address) => address !== 0)).toBe(true);
    expect(Math.min(core.heapBytes, files.heapBytes)).toBeGreaterThan(2 ** 31);
    const mesh = bar();
    const poses = [0, 60, 120].map((degrees) => bent(mesh, degrees));
    const given = poses.map((positions, i) => ({ name: `${i}.glb`, bytes: meshGlb(mesh, positions) }));
    const { positions } = files.importKeys(given, IMPORT_DEFAULTS);
    expect(positions).toEqual(poses);
    const high = core.evaluate(createBend(core, bendData()).motion, 0.3, null).positions;
    const low = (await localCore()).core;
    expect(high).toEqual(low.evaluate(createBend(low).motion, 0.3, null).positions);
  });
});
