import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { draco, meshopt } from './support/compress.ts';
import { failureOf, testEngine } from './support/engines.ts';
import { poseFiles } from './support/glb.ts';
import { bar, bent, diagonal } from './support/shapes.ts';

const mesh = bar();
const poses = [0, 60].map((degrees) => bent(mesh, degrees));
const plain = poseFiles(mesh, poses);
const engine = testEngine();

/** Corners in face order, independent of vertex numbers. */
const cornersOf = (positions: Float32Array, indices: Uint32Array): string[] =>
  Array.from(indices, (v) =>
    Array.from(positions.subarray(3 * v, 3 * v + 3), (value) => value.toFixed(2)).join(),
  ).sort();

/** Each face starting with its smallest corner, because meshopt may rotate corners but keeps order and winding. */
const facesOf = (indices: Uint32Array): string[] =>
  Array.from({ length: indices.length / 3 }, (_, f) => {
    const [a, b, c] = indices.subarray(3 * f, 3 * f + 3) as unknown as [number, number, number];
    const turned = a < b && a < c ? [a, b, c] : b < c ? [b, c, a] : [c, a, b];
    return turned.join();
  });

describe('compressed meshes', () => {
  it('with EXT_meshopt_compression are read bit for bit', async () => {
    const files = await meshopt(plain);
    expect(new TextDecoder('latin1').decode(files[0]!.bytes)).toContain('EXT_meshopt_compression');
    const keys = await engine.importKeyframes(files);
    expect(keys.info.names).toEqual(['pose-1', 'pose-2']);
    expect(keys.positions(1)).toEqual(poses[1]);
    expect(facesOf(keys.info.faces)).toEqual(facesOf(mesh.indices));
  });

  it('with KHR_draco_mesh_compression are read to its quantisation', async () => {
    const files = await draco(plain);
    expect(new TextDecoder('latin1').decode(files[0]!.bytes)).toContain('KHR_draco_mesh_compression');
    const keys = await engine.importKeyframes(files);
    expect(keys.info.report.faces).toBe(mesh.indices.length / 3);
    expect(diagonal(keys.positions(1))).toBeCloseTo(diagonal(poses[1]!), 3);
    expect(cornersOf(keys.positions(0), keys.info.faces)).toEqual(cornersOf(poses[0]!, mesh.indices));
  });

  it('find their buffers like other files, and report missing buffers only', async () => {
    const [{ bytes }, second] = (await meshopt(plain)) as [InputFile, InputFile];
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as {
      buffers: { uri?: string }[];
      images?: object[];
    };
    const binary = { name: 'the mesh.bin', bytes: bytes.slice(28 + length) };
    const gltf = (uri: string): InputFile => {
      json.buffers[0]!.uri = uri;
      json.images = [{ uri: 'missing.png' }];
      return { name: 'a.gltf', bytes: new TextEncoder().encode(JSON.stringify(json)) };
    };
    for (const uri of ['the%20mesh.bin', './the mesh.bin', 'buffers/the%20mesh.bin']) {
      const keys = await engine.importKeyframes([gltf(uri), second, binary]);
      expect(keys.positions(0)).toEqual(poses[0]);
    }
    const refused = async (uri: string) => failureOf(engine.importKeyframes([gltf(uri), second]));
    expect(await refused('the%20mesh.bin')).toMatchObject({
      code: 'missing-resource',
      message: expect.stringMatching(/^a\.gltf needs the file .*\.$/) as string,
    });
    expect(await refused('../m.bin')).toMatchObject({
      code: 'external-resource',
      message: expect.stringMatching(/outside the given files\./) as string,
    });
    expect(await refused('https://example.com/m.bin')).toMatchObject({
      code: 'external-resource',
      message: expect.stringMatching(/Only the given files are read.*\.$/) as string,
    });
  });

  it('that are truncated are refused like other files', async () => {
    for (const files of [await meshopt(plain), await draco(plain)]) {
      const cut = { name: 'cut.glb', bytes: files[1]!.bytes.slice(0, -100) };
      expect(await failureOf(engine.importKeyframes([files[0]!, cut]))).toMatchObject({
        code: 'truncated-file',
        message: expect.stringMatching(/^cut\.glb .*cut off/) as string,
      });
    }
  });

  it("that are broken are refused with the file's name", async () => {
    for (const files of [await meshopt(plain), await draco(plain)]) {
      const bytes = files[1]!.bytes;
      bytes.fill(0xee, bytes.length - 400);
      const error = await failureOf(engine.importKeyframes(files));
      expect(error.code).toBe('malformed-file');
      expect(error.message).toMatch(/^pose-2\.glb: [^\n]+\.$/);
    }
  });
});
