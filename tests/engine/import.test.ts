import { describe, expect, it } from 'vitest';
import { readPose, readPoses } from '../../web/engine/api/read-poses.ts';
import type { InputFile, Progress } from '../../web/engine/api/types.ts';
import { meshopt } from './support/compress.ts';
import { bendSequence, failureOf, frameAt, testEngine } from './support/engines.ts';
import { glb, meshGlb, poseFiles } from './support/glb.ts';
import { bar, bent, type Mesh } from './support/shapes.ts';

const engine = testEngine();
const mesh = bar();
const straight = mesh.positions;
const curved = bent(mesh, 60);
const good: InputFile[] = poseFiles(mesh, [straight, curved]);
const first = good[0]!;
const named = (name: string, bytes: Uint8Array): InputFile => ({ name, bytes });
const text = (content: string): Uint8Array => new TextEncoder().encode(content);

function withNaN(): Float32Array {
  const positions = curved.slice();
  positions[3 * 17 + 1] = NaN;
  return positions;
}

function otherFaces({ indices }: Mesh, face: number): Uint32Array {
  const changed = indices.slice();
  changed[3 * face] = (changed[3 * face]! + 1) % 50;
  return changed;
}

/** Every kind of invalid second file: the error's code and required text. */
const bad: [string, InputFile, string, RegExp][] = [
  ['an empty file', named('empty.glb', new Uint8Array(0)), 'empty-file', /empty/],
  ['a cut file', named('cut.glb', good[1]!.bytes.slice(0, 4000)), 'truncated-file', /cut/],
  [
    'an HTML page',
    named('page.glb', text('<!DOCTYPE html><html><body>Not found</body></html>')),
    'not-recognised',
    /page/,
  ],
  [
    'no glTF at all',
    named(
      'noise.glb',
      Uint8Array.from({ length: 999 }, (_, i) => (i * 7919) % 251),
    ),
    'not-recognised',
    /noise/,
  ],
  ['no mesh', named('none.glb', glb({ asset: { version: '2.0' } })), 'no-triangles', /none/],
  ['another vertex count', named('other.glb', meshGlb(bar(2, 10))), 'vertex-count-mismatch', /90 vertices.* 170|162/],
  [
    'another face',
    named('faces.glb', meshGlb({ ...mesh, indices: otherFaces(mesh, 5) }, curved)),
    'face-mismatch',
    /faces/,
  ],
  ['a coordinate that is no number', named('nan.glb', meshGlb(mesh, withNaN())), 'not-finite', /nan/],
  [
    'an external buffer',
    named(
      'far.gltf',
      text(
        JSON.stringify({
          asset: { version: '2.0' },
          buffers: [{ uri: 'https://example.com/a.bin', byteLength: 4 }],
          bufferViews: [{ buffer: 0, byteLength: 4 }],
          accessors: [{ bufferView: 0, componentType: 5126, count: 1, type: 'SCALAR' }],
        }),
      ),
    ),
    'external-resource',
    /example\.com/,
  ],
];

describe('importing', () => {
  it('reads one pose per file, in the given order', async () => {
    const keys = await engine.importKeyframes([good[1]!, first]);
    expect(keys.info.names).toEqual(['pose-2', 'pose-1']);
    expect(keys.info.times).toEqual([0, 1]);
    expect(keys.positions(0)).toEqual(curved);
    expect(keys.info.faces).toEqual(mesh.indices);
    expect(keys.info.report).toMatchObject({
      vertices: straight.length / 3,
      weldedVertices: straight.length / 3,
      faces: mesh.indices.length / 3,
      components: 1,
      boundaryEdges: 0,
      nonManifoldEdges: 0,
      degenerateFaces: 0,
      duplicateFaces: 0,
      unreferencedVertices: 0,
      inconsistentEdges: 0,
    });
    expect(keys.info.project).toBeNull();
  });

  it('places poses without times one second apart', async () => {
    const poses = await engine.importKeyframes([first, good[1]!, { ...first, name: 'pose-3.glb' }]);
    expect(poses.info.times).toEqual([0, 1, 2]);
    const targets = named('morph.glb', meshGlb(mesh, straight, [bent(mesh, 30), curved]));
    expect((await engine.importKeyframes([targets])).info.times).toEqual([0, 1, 2]);
  });

  it('reports named stages with non-decreasing progress, and can be cancelled in each', async () => {
    const fine = bar(4, 40);
    const morph = named(
      'morph.glb',
      meshGlb(
        fine,
        fine.positions,
        [20, 40, 60, 80].map((degrees) => bent(fine, degrees)),
      ),
    );
    for (const files of [[morph], good, await meshopt(good)]) {
      const heard: Progress[] = [];
      await engine.importKeyframes(files, {}, { onProgress: (progress) => heard.push(progress) });
      const fractions = heard.map(({ fraction }) => fraction);
      expect(fractions.length).toBeGreaterThanOrEqual(4);
      expect(fractions).toEqual(fractions.slice().sort((a, b) => a - b));
      expect(fractions[0]).toBe(0);
      expect(fractions.at(-1)).toBeLessThanOrEqual(1);
      for (const { stage } of heard) expect(stage).toMatch(/^[a-z ]{5,}$/);
    }
    const abort = new AbortController();
    const work = engine.importKeyframes([morph], {}, { signal: abort.signal, onProgress: () => abort.abort() });
    expect((await failureOf(work)).code).toBe('cancelled');
    expect((await engine.importKeyframes([morph])).info.names).toHaveLength(5);
  });

  it('neither keeps nor transfers the given bytes', async () => {
    const files = good.map(({ name, bytes }) => ({ name, bytes: bytes.slice() }));
    const keys = await engine.importKeyframes(files);
    for (const { bytes } of files) {
      expect(bytes.length).toBeGreaterThan(0);
      bytes.fill(0);
    }
    const sequence = await engine.createSequence(keys);
    expect((await frameAt(sequence, 0)).positions.length).toBe(straight.length);
    sequence.dispose();
  });

  it.each(bad)('refuses %s, alone and as the second of two files', async (_, file, code, says) => {
    const { sequence } = await bendSequence(engine);
    const before = (await frameAt(sequence, 0.4)).positions;
    const second = await failureOf(engine.importKeyframes([first, file]));
    expect(second.code).toBe(code);
    expect(second.message).toMatch(says);
    expect(second.message).toMatch(/^[^\n]+[.!]$/);
    expect(second.place.key).toBe(1);
    const alone = await failureOf(engine.importKeyframes([file]));
    expect(alone.message).toMatch(/^[^\n]+[.!]$/);
    expect((await frameAt(sequence, 0.4)).positions).toEqual(before);
    sequence.dispose();
  });

  it('reads further poses of the same mesh, one or several, and refuses another mesh', async () => {
    const mesh = bar();
    const poses = [0, 30, 60, 90].map((degrees) => bent(mesh, degrees));
    const [first, second, third, fourth] = poseFiles(mesh, poses) as [InputFile, InputFile, InputFile, InputFile];
    const keys = await engine.importKeyframes([first, second]);
    expect((await readPoses(engine, [third], keys)).map(({ positions }) => positions)).toEqual([poses[2]]);
    expect((await readPoses(engine, [third, fourth], keys)).map(({ positions }) => positions)).toEqual(poses.slice(2));
    expect(await readPose(engine, [fourth], keys)).toEqual(poses[3]);
    const other = { name: 'folder/other.glb', bytes: meshGlb(bar(2, 10)) };
    expect(await failureOf(readPoses(engine, [other], keys))).toMatchObject({
      code: 'vertex-count-mismatch',
      place: { file: 'other.glb' },
    });
    keys.dispose();
  });

  it('refuses a single key, invalid times, and invalid calls', async () => {
    const refused = async (...args: Parameters<typeof engine.importKeyframes>) =>
      (await failureOf(engine.importKeyframes(...args))).code;
    expect(await refused([first])).toBe('too-few-keys');
    expect(await refused(good, { keyTimes: [1, 1] })).toBe('times-not-increasing');
    expect(await refused(good, { keyTimes: [0, 1, 2] })).toBe('time-count-mismatch');
    expect(await refused([])).toBe('invalid-option');
    expect(await refused([{ name: 'a', bytes: 'text' } as unknown as InputFile])).toBe('invalid-option');
    expect(await refused(good, { upp: 'y' } as object)).toBe('invalid-option');
    for (const options of [{ animation: 0 }, { sample: 3 }, { sample: [0, 1] }])
      expect(await refused(good, options)).toBe('unknown-animation');
  });
});

it.each(['NFC', 'NFD'])(
  'finds companions whose accents are composed in another way than in the model: %s',
  async (form) => {
    const [given, other] = [form, form === 'NFC' ? 'NFD' : 'NFC'].map((one) => 'Gr\u00f6\u00dfe'.normalize(one));
    const file = (name: string, content: string): InputFile => ({ name, bytes: new TextEncoder().encode(content) });
    const pose = (name: string, z: number): InputFile =>
      file(`${given}/${name}.obj`, `mtllib ${other}/${other}.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 ${z}\nusemtl red\nf 1 2 3\n`);
    const library = file(`${given}/${given}/${given}.mtl`, 'newmtl red\nKd 1 0 0\n');
    const { info } = await testEngine().importKeyframes([pose('a', 0), pose('b', 1), library]);
    expect([info.warnings, info.names]).toEqual([[], ['a', 'b']]);
    expect(info.scene.materials).toMatchObject([{ name: 'red', baseColor: [1, 0, 0, 1] }]);
  },
);
