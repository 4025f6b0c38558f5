/** Files with compressed meshes: the worker loads their decoders only when needed. */
import { draco, meshopt } from '../engine/support/compress.ts';
import { poseFiles } from '../engine/support/glb.ts';
import { bar, bent } from '../engine/support/shapes.ts';
import { expect, test } from './support.ts';

const mesh = bar();
const plain = poseFiles(
  mesh,
  [0, 60, 120].map((degrees) => bent(mesh, degrees)),
);
const vertices = `${mesh.positions.length / 3} vertices`;

for (const [name, compress, decoder] of [
  ['Draco', draco, /draco_decoder.*\.wasm/],
  ['meshopt', meshopt, /meshopt(imizer)?_decoder/],
] as const) {
  // Only one format is also tested on the development server, because both are loaded in the same way.
  test(`poses compressed with ${name} open`, { tag: name === 'Draco' ? '@server' : [] }, async ({ app }) => {
    const files = await compress(plain);
    // A sample made in the browser, because other samples are compressed.
    await app.open({ sample: 'column' });
    expect(app.requests.filter((url) => decoder.test(url))).toEqual([]);
    const upload = files.map((file) => ({
      name: file.name,
      mimeType: 'model/gltf-binary',
      buffer: Buffer.from(file.bytes),
    }));
    await app.by('file-input').setInputFiles(upload);
    await expect.poll(async () => (await app.state()).source.kind).toBe('files');
    await app.settled();
    expect((await app.state()).doc.keys).toHaveLength(3);
    if (name === 'meshopt') await expect(app.by('status-vertices')).toHaveText(vertices);
    expect((await app.positionsAt(0.25)).every(Number.isFinite)).toBe(true);
    await app.expectNoProblems();
  });
}
