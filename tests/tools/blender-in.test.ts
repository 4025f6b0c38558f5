/**
 * Poses written by Blender itself (blender-poses.py) in several formats: all key vertices match Blender's. Skipped
 * without a Python with the module bpy, from SHAPESPLINE_BPY or .toolchain/blender.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import type { ImportOptions, InputFile } from '../../web/engine/api/types.ts';
import { testEngine } from '../engine/support/engines.ts';

const script = fileURLToPath(new URL('blender-poses.py', import.meta.url));
const installed = fileURLToPath(new URL('../../.toolchain/blender/bin/python', import.meta.url));
const python = [process.env.SHAPESPLINE_BPY, installed, 'python3.11', 'python3']
  .filter((program) => program !== undefined)
  .find((program) => spawnSync(program, ['-c', 'import bpy']).status === 0);

type Point = [number, number, number];

describe.skipIf(!python)('poses written by Blender', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-blender-'));
  const engine = testEngine();
  let reference: Record<string, Point[][]> = {};

  beforeAll(() => {
    const made = spawnSync(python!, [script, folder], { encoding: 'utf8' });
    expect(made.stdout, made.stderr).toMatch(/written/);
    reference = JSON.parse(readFileSync(path.join(folder, 'truth.json'), 'utf8')) as typeof reference;
  }, 600_000);
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  const filesOf = (pattern: RegExp): InputFile[] =>
    readdirSync(folder)
      .filter((name) => pattern.test(name))
      .sort()
      .map((name) => ({ name, bytes: readFileSync(path.join(folder, name)) }));
  const keysOf = (pattern: RegExp, options?: ImportOptions): Promise<Keys> =>
    engine.importKeyframes(filesOf(pattern), options);
  const warnings = ({ info }: Keys): string[] => info.warnings.map(({ code }) => code);

  /** The largest distance between a key's vertices and those of its pose, relative to the diagonal. */
  function distance(keys: Keys, poses: Point[][]): number {
    const first = keys.positions(0);
    const at = (points: Float32Array, v: number): Point => [points[3 * v]!, points[3 * v + 1]!, points[3 * v + 2]!];
    const apart = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    const own = Array.from({ length: first.length / 3 }, (_, v) => {
      const near = poses[0]!.map((point) => apart(point, at(first, v)));
      return near.indexOf(Math.min(...near));
    });
    const far = keys.info.times.flatMap((_, key) => {
      const positions = keys.positions(key);
      return own.map((vertex, v) => apart(poses[key]![vertex]!, at(positions, v)));
    });
    return far.reduce((most, one) => Math.max(most, one), 0) / keys.info.report.diagonal;
  }

  it.each([
    ['smooth shading', 'smooth', /^smooth-\d.glb$/],
    ['flat shading, which splits vertices by pose', 'flat', /^flat-\d.glb$/],
    ['quads that are cut otherwise in every pose', 'head', /^head-\d.glb$/],
    ['flat shading and other cuts at once', 'flat-head', /^flat-head-\d.glb$/],
    ['edges that are sharp where they are bent', 'sharp', /^sharp-\d.glb$/],
    ['OBJ of polygons', 'quads', /^quads-\d.obj$/],
    ['OBJ of triangles, cut and ordered otherwise', 'cut', /^cut-\d.obj$/],
  ])('%s: every vertex to a millionth', async (_, name, pattern) => {
    const keys = await keysOf(pattern);
    expect(keys.info.times).toHaveLength(3);
    expect(warnings(keys)).not.toContain('split-vertices');
    expect(distance(keys, reference[name]!)).toBeLessThan(1e-6);
    const sequence = await engine.createSequence(keys);
    const frame = await sequence.evaluate(0.5);
    expect(frame!.positions.every(Number.isFinite)).toBe(true);
    sequence.dispose();
  });

  it('PLY: Z is up, as the hint states', async () => {
    expect(warnings(await keysOf(/^zup-\d.ply$/))).toContain('z-up');
    const standing = await keysOf(/^zup-\d.ply$/, { up: 'z' });
    expect(warnings(standing)).not.toContain('z-up');
    expect(distance(standing, reference['zup']!)).toBeLessThan(1e-6);
  });

  it('a rig that was not applied: the warning states the reason, and that the bones are at rest', async () => {
    const { info } = await keysOf(/^still-\d.glb$/);
    const same = info.warnings.find(({ code }) => code === 'same-poses');
    expect(same?.message).toMatch(/^Keys 1, 2 and 3 are the same pose.*Apply the modifiers.*bones are at rest/);
    expect(info.animations).toEqual([]);
  });

  it('a rig with its animation in every file: the keys can be taken from it', async () => {
    const still = await keysOf(/^animated-\d.glb$/);
    expect(still.info.warnings[0]?.message).toMatch(/has its own animation.*--sample/);
    expect(still.info.animations).toHaveLength(1);
    const { start, end } = still.info.animations[0]!;
    const keys = await keysOf(/^animated-\d.glb$/, { sample: [start, (start + end) / 2, end] });
    expect(warnings(keys)).toEqual(['repeated-animation']);
    // Weights in glTF are float32 and scaled to sum to 1.
    expect(distance(keys, reference['animated']!)).toBeLessThan(1e-5);
  });

  it.each([
    ['objects-glb', /^objects-\d.glb$/, ['Floor', 'Bar'], 'Bar'],
    ['objects', /^objects-\d.obj$/, ['Floor', 'Bar'], 'Bar'],
    ['groups', /^groups-\d.obj$/, ['Floor_Plane', 'Bar_Cylinder'], 'Bar_Cylinder'],
  ])('%s: the floor is left out', async (name, pattern, objects, bar) => {
    const all = await keysOf(pattern);
    expect([...all.info.objects].sort()).toEqual([...objects].sort());
    const keys = await keysOf(pattern, { objects: [bar] });
    expect(keys.info.report.components).toBe(1);
    expect(distance(keys, reference[name]!)).toBeLessThan(1e-6);
  });

  it.each(['pc2', 'mdd'])('%s with its OBJ, with any axes', async (kind) => {
    const keys = await keysOf(new RegExp(`^cache\\.(obj|mtl|${kind})$`), { sample: [0, 0.5, 1] });
    const poses = [0, 12, 24].map((frame) => reference['cache']![frame]!);
    // OBJ has six decimals.
    expect(distance(keys, poses)).toBeLessThan(1e-6);
  });
});
