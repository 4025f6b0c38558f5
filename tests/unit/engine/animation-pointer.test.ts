/** KHR_animation_pointer is preserved by the library that decodes compressed meshes. */
import * as core from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { expect, it } from 'vitest';
import { animationPointer } from '../../../web/engine/worker/animation-pointer.ts';

const pointer = (to: string): object => ({ path: 'pointer', extensions: { KHR_animation_pointer: { pointer: to } } });

it('the targets of channels are written unchanged', async () => {
  const times = Float32Array.of(0, 1, 0, 0, 0, 1, 2, 3);
  const accessor = (count: number, type: string, byteOffset: number): object => ({
    bufferView: 0,
    componentType: 5126,
    count,
    type,
    byteOffset,
  });
  const channels = [
    { sampler: 0, target: { node: 1, path: 'translation' } },
    { sampler: 0, target: pointer('/nodes/0/translation') },
    { sampler: 0, target: pointer('/nodes/1/extensions/KHR_node_visibility/visible') },
  ];
  const json = {
    asset: { version: '2.0' },
    extensionsUsed: ['KHR_animation_pointer', 'KHR_node_visibility'],
    nodes: [{}, { extensions: { KHR_node_visibility: { visible: false } } }],
    buffers: [{ byteLength: 32, uri: 'a.bin' }],
    bufferViews: [{ buffer: 0, byteLength: 32 }],
    accessors: [accessor(2, 'SCALAR', 0), accessor(2, 'VEC3', 8)],
    animations: [{ samplers: [{ input: 0, output: 1 }], channels }],
  };
  const io = new core.WebIO().registerExtensions([...ALL_EXTENSIONS, animationPointer(core)]);
  const resources = { 'a.bin': new Uint8Array(times.buffer) };
  const written = await io.writeJSON(await io.readJSON({ json: json as unknown as core.GLTF.IGLTF, resources }));
  expect(written.json.animations![0]!.channels.map(({ target }) => target)).toEqual(
    channels.map(({ target }) => target),
  );
  expect(written.json.extensionsUsed).toContain('KHR_animation_pointer');
  expect(written.json.nodes![1]!.extensions).toEqual({ KHR_node_visibility: { visible: false } });
});
