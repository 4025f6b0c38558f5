/** Keys from arrays equal those from files, without reading a file. */
import { expect, it } from 'vitest';
import { make } from '../../web/sculpt/make.ts';
import { bendKeys, failureOf, frameAt, testEngine } from './support/engines.ts';

const noFiles = { filesUrl: new URL('./support/no-such.wasm', import.meta.url) };

it('keys of arrays move as those of files do, without the module for files', async () => {
  const { keys, mesh, poses } = await bendKeys(testEngine());
  const engine = testEngine(noFiles);
  const named = poses.map((positions, key) => ({ name: keys.info.names[key]!, time: key / 2, positions }));
  const made = await engine.createKeys({ faces: mesh.indices, poses: named });
  expect(made.info).toMatchObject({ report: keys.info.report, names: keys.info.names, times: keys.info.times });
  const [one, other] = [await testEngine().createSequence(keys), await engine.createSequence(made)];
  for (const t of [0.3, 1.2]) expect((await frameAt(other, t)).positions).toEqual((await frameAt(one, t)).positions);
  expect((await failureOf(other.export())).message).toMatch(/no-such\.wasm.*configure\(\{ filesUrl \}\)/);
});

it('keys that are none are refused as in files', async () => {
  const engine = testEngine(noFiles);
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const poses = [0, 1].map((time) => ({ name: `at ${time}`, time, positions }));
  const codeOf = async (change: object): Promise<string> =>
    (await failureOf(engine.createKeys({ faces: Uint32Array.of(0, 1, 2), poses, ...change }))).code;
  expect(await codeOf({ faces: Uint32Array.of(0, 1, 3) })).toBe('index-out-of-range');
  expect(await codeOf({ poses: poses.slice(1) })).toBe('too-few-keys');
  expect(await codeOf({ poses: [poses[1], poses[0]] })).toBe('times-not-increasing');
  expect(await codeOf({ poses: [poses[0], { ...poses[1], positions: new Float32Array(6) }] })).toBe(
    'vertex-count-mismatch',
  );
  expect(await codeOf({ poses: [poses[0], { ...poses[1], positions: positions.map(() => NaN) }] })).toBe('not-finite');
});

const TRIANGLE = Uint32Array.of(0, 1, 2);
const flat = (time: number): { name: string; time: number; positions: Float32Array } => ({
  ...{ name: `at ${time}`, time },
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1 + time, 0),
});
const gone = new Float32Array(9);
structuredClone(gone.buffer, { transfer: [gone.buffer] });
const PLAIN = {
  ...{ uvs: null, seams: null, colors: null, polygons: null, materials: [], images: [] },
  groups: [{ start: 0, count: 1, material: -1 }],
};

it.each<[string, object | undefined, RegExp]>([
  ['no mesh', undefined, /Give a mesh as \{ faces, poses \}/],
  ['no poses', { poses: undefined }, /poses must be an array/],
  ['poses of another kind', { poses: { length: 2 } }, /poses must be an array/],
  ['an empty pose', { poses: [flat(0), null] }, /poses\[1\] must be \{ name, time, positions \}/],
  ['a name without text', { poses: [{ ...flat(0), name: {} }, flat(1)] }, /poses\[0\]\.name must be a string/],
  ['no time', { poses: [flat(0), { ...flat(1), time: NaN }] }, /poses\[1\]\.time must be a number/],
  ['a transferred pose', { poses: [flat(0), { ...flat(1), positions: gone }] }, /poses\[1\]\.positions .*transferred/],
  ['a far index', { faces: Uint32Array.of(0, 1, 2 ** 32 - 1) }, /Face 0 refers to vertex 4,294,967,295, .* 3 vertices/],
  ['a scene of text', { scene: 'x' }, /scene must be an object/],
  ['an empty scene', { scene: {} }, /scene\.seams must be null or/],
  ['a long group', { scene: { ...PLAIN, groups: [{ start: 0, count: 2, material: -1 }] } }, /scene\.groups .* 1 faces/],
  ['an unknown material', { scene: { ...PLAIN, groups: [{ start: 0, count: 1, material: 0 }] } }, /0 materials/],
  ['short uvs', { scene: { ...PLAIN, uvs: new Float32Array(4) } }, /scene\.uvs .* 6 finite numbers/],
  ['long colours', { scene: { ...PLAIN, colors: new Float32Array(16) } }, /scene\.colors .* 12 finite numbers/],
  ['far polygons', { scene: { ...PLAIN, polygons: Int32Array.of(2) } }, /scene\.polygons .* sum 1/],
  [
    'other seams',
    { scene: { ...PLAIN, seams: { copyOf: Int32Array.of(0), indices: TRIANGLE.map(() => 3) } } },
    /seams/,
  ],
  [
    'a bare material',
    { scene: { ...PLAIN, materials: [{ name: 'x' }] } },
    /scene\.materials\[0\]\.baseColor .* 4 numbers/,
  ],
  ['a page as image', { scene: { ...PLAIN, images: [{ mimeType: 'text/html' }] } }, /scene\.images\[0\]\.mimeType/],
  ['far objects', { scene: { ...PLAIN, objects: [{ start: 3, count: 9 }] } }, /scene\.objects/],
])('createKeys refuses %s in a sentence', async (_, change, says) => {
  const mesh = change && { faces: TRIANGLE, poses: [flat(0), flat(1)], ...change };
  expect((await failureOf(testEngine(noFiles).createKeys(mesh as never))).message).toMatch(says);
});

it('the scene of an import makes keys with the same exports, and the caller can change its own arrays', async () => {
  const engine = testEngine();
  const { bytes } = await make('column', 0.5);
  const keys = await engine.importKeyframes([{ name: 'column.glb', bytes }]);
  const { faces, scene, names, times } = keys.info;
  const poses = times.map((time, key) => ({ name: names[key]!, time, positions: keys.positions(key) }));
  const own = structuredClone(scene);
  const made = await engine.createKeys({ faces, poses, scene: own });
  own.groups[0]!.count = 1e9;
  const texts = async (of: typeof keys): Promise<string[]> => {
    const sequence = await engine.createSequence(of);
    return (await sequence.export({ format: 'obj', times: [0] })).map((file) => new TextDecoder().decode(file.bytes));
  };
  expect(await texts(made)).toEqual(await texts(keys));
});

it.each(['column', 'turret'])('the %s is the same as arrays and as a file', async (id) => {
  const { bytes, mesh } = await make(id, 0.5);
  const engine = testEngine();
  const [file, arrays] = [await engine.importKeyframes([{ name: `${id}.glb`, bytes }]), await engine.createKeys(mesh)];
  const { diagonal, ...counts } = file.info.report;
  expect(arrays.info.report).toMatchObject(counts);
  expect(arrays.info.report.diagonal).toBeCloseTo(diagonal, 5);
  expect([arrays.info.times, arrays.info.faces]).toEqual([file.info.times, file.info.faces]);
  const { objects: _, groups, materials, ...scene } = file.info.scene;
  expect(arrays.info.scene).toMatchObject({ ...scene, groups: [{ start: 0, count: groups[0]!.count, material: 0 }] });
  const roughness = Math.fround(arrays.info.scene.materials[0]!.roughness);
  expect([{ ...arrays.info.scene.materials[0], roughness }]).toEqual(materials);
  // Morph targets are differences, which are rounded.
  const off = file.positions(2).map((value, i) => Math.abs(value - arrays.positions(2)[i]!));
  expect(Math.max(...off)).toBeLessThan(1e-6);
});
