/** three.js and Babylon.js play the computed vertices: exactly at exported times, within the tolerance between them. */
import '@babylonjs/loaders/glTF';
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { ImportMeshAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';
import { beforeAll, describe, expect, it } from 'vitest';
import { expectValid } from '../engine/support/exported.ts';
import { largestDistance } from '../engine/support/shapes.ts';
import { threePlayer, withoutImages } from '../engine/support/three-player.ts';
import { paintedMotion, farthestShown, type Made } from './made.ts';

let made: Made;
beforeAll(async () => {
  made = await paintedMotion();
});

interface Player {
  /** Error relative to the motion at a time of the file. */
  off(seconds: number): Promise<number>;
}

async function three(bytes: Uint8Array): Promise<Player> {
  const player = await threePlayer(bytes);
  return { off: async (seconds) => largestDistance(player.positionsAt(seconds), await made.at(seconds)) };
}

/** Targets and weights as loaded and animated by Babylon.js, summed like its shaders do. */
async function babylon(bytes: Uint8Array): Promise<Player> {
  const scene = new Scene(new NullEngine());
  scene.useRightHandedSystem = true;
  new FreeCamera('camera', Vector3.Zero(), scene);
  const file = `data:model/gltf-binary;base64,${Buffer.from(withoutImages(bytes)).toString('base64')}`;
  const { meshes, animationGroups } = await ImportMeshAsync(file, scene, { pluginExtension: '.glb' });
  const [group] = animationGroups;
  group!.start(false);
  group!.pause();
  const shown = meshes.filter((mesh) => mesh.getTotalVertices() > 0);
  const off = async (seconds: number): Promise<number> => {
    // Babylon.js counts frames of 1/60 s.
    group!.goToFrame(seconds * 60);
    const vertices: [number, number, number, number][] = [];
    for (const mesh of shown) {
      mesh.computeWorldMatrix(true);
      const base = mesh.getVerticesData('position')!;
      const positions = Float32Array.from(base);
      const { morphTargetManager: manager } = mesh;
      for (let k = 0; k < manager!.numTargets; k += 1) {
        const target = manager!.getTarget(k);
        const offsets = target.getPositions()!;
        for (let i = 0; i < positions.length; i += 1) positions[i]! += target.influence * (offsets[i]! - base[i]!);
      }
      const numbers = mesh.metadata.vertices as number[];
      numbers.forEach((vertex, i) =>
        vertices.push([vertex, ...(positions.subarray(3 * i, 3 * i + 3) as unknown as [number, number, number])]),
      );
    }
    return farthestShown(vertices, await made.at(seconds));
  };
  const numbers = vertexNumbers(bytes);
  shown.forEach((mesh, primitive) => {
    mesh.metadata = { ...mesh.metadata, vertices: numbers[primitive] };
  });
  return { off };
}

/** The vertex numbers, read from the file because Babylon.js drops unknown attributes. */
function vertexNumbers(bytes: Uint8Array): number[][] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  return json.meshes[0].primitives.map(({ attributes }: { attributes: Record<string, number> }) => {
    const accessor = json.accessors[attributes['_SHAPESPLINE_VERTEX']!];
    const start = 28 + length + json.bufferViews[accessor.bufferView].byteOffset;
    return Array.from({ length: accessor.count }, (_, i) => view.getFloat32(start + 4 * i, true));
  });
}

describe.each([
  ['three.js', three],
  ['Babylon.js', babylon],
] as const)('%s', (_, play) => {
  it('shows every frame of an export of whole frames exactly', async () => {
    const options = { frames: 13 };
    const bytes = await made.glb(options);
    const { off } = await play(bytes);
    for (const t of (await made.sequence.planExport(options)).times)
      expect(await off(t)).toBeLessThan(1e-6 * made.diagonal);
  });

  it('stays within the tolerance of an export with as few targets as needed', async () => {
    const { times, error } = await made.sequence.planExport();
    const { off } = await play(await made.glb({}));
    for (const t of times) expect(await off(t)).toBeLessThan(1e-6 * made.diagonal);
    let largest = 0;
    for (let i = 0; i <= 60; i += 1) largest = Math.max(largest, await off(i / 60));
    expect(largest).toBeLessThan(1e-3 * made.diagonal);
    expect(largest).toBeLessThan(1.02 * error! * made.diagonal);
  });

  it('mixes the keys and their in-betweens', async () => {
    const { off } = await play(await made.glb({ targets: 'principal' }));
    for (let i = 0; i <= 60; i += 1) expect(await off(i / 60)).toBeLessThan(1e-3 * made.diagonal);
  });
});

describe('the validator', () => {
  it.each([
    {},
    { frames: 13 },
    { targets: 'principal' },
    { compression: 'quantized' },
    { compression: 'meshopt' },
  ] as const)('finds nothing in an export with %o', async (options) => expectValid(await made.glb(options)));
});
