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
