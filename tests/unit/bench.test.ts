import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { WebIO } from '@gltf-transform/core';
import { validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { benchArguments } from '../../wasm/toolchain/bench-arguments.mjs';
import { sharingVertices } from '../bench/old-layout.ts';
import { quantile, spread } from '../bench/quantile.ts';
import { sweptParts } from '../bench/sweep.ts';
import { verdict, type Target } from '../bench/targets.ts';
import { aligned, Sliding, walkedOn } from '../bench/reference-errors.ts';
import { meshGlb } from '../engine/support/glb.ts';
import { bar, bent } from '../engine/support/shapes.ts';

describe('the arguments of npm run bench --', () => {
  it('state what is measured, for which sizes, and where', () => {
    expect(benchArguments([])).toEqual({ what: 'stages', sizes: null, files: [], browser: false, save: false });
    expect(benchArguments(['64,4000000', '--save', '--browser'])).toEqual({
      what: 'stages',
      sizes: [{ faces: 64 }, { faces: 4_000_000 }],
      files: [],
      browser: true,
      save: true,
    });
    expect(benchArguments(['exports', '2000', '--save'])).toEqual({
      what: 'exports',
      sizes: [{ faces: 2000 }],
      files: [],
      browser: false,
      save: true,
    });
    expect(benchArguments(['start'])).toMatchObject({ what: 'start', sizes: null, save: false });
    expect(() => benchArguments(['start', '1000'])).toThrow();
    expect(benchArguments(['drop', '1000'])).toMatchObject({ what: 'drop', sizes: [{ faces: 1000 }] });
    expect(benchArguments(['hold', 'walk.glb', 'run.glb', '--save'])).toEqual({
      what: 'hold',
      sizes: null,
      files: ['walk.glb', 'run.glb'],
      browser: false,
      save: true,
    });
    expect(() => benchArguments(['hold'])).toThrow();
    expect(() => benchArguments(['hold', 'walk.glb', '--browser'])).toThrow();
  });

  it.each([
    'nonsense',
    '63',
    '4000001',
    '1e3',
    '1000.5',
    '1000,',
    '1000 2000',
    '--fast',
    'stages',
    'start 1000',
    'drop --save',
    'exports --browser',
  ])('are refused where they make no sense: %s', (words) => {
    expect(() => benchArguments(words.split(' '))).toThrow('usage: npm run bench');
  });

  it('are checked before any other work', () => {
    const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-bare-'));
    try {
      cpSync(fileURLToPath(new URL('../../wasm/toolchain', import.meta.url)), path.join(folder, 'wasm/toolchain'), {
        recursive: true,
      });
      const env = { ...process.env, SHAPESPLINE_NO_INSTALL: '1' };
      const { status, stderr } = spawnSync(
        process.execPath,
        [path.join(folder, 'wasm/toolchain/run.mjs'), 'bench', 'nonsense'],
        { encoding: 'utf8', env },
      );
      expect(stderr).toMatch(/^usage: npm run bench/);
      expect(status).toBe(1);
      expect(readdirSync(folder)).toEqual(['wasm']);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  });
});

describe('the old layout of an animation', () => {
  it('has all primitives share one vertex buffer with its targets, and the faces of the mesh in their order', async () => {
    const mesh = bar(2, 5);
    const bytes = sharingVertices(meshGlb(mesh, mesh.positions, [bent(mesh, 40)]), 3);
    const { issues } = await validateBytes(bytes);
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    const root = (await new WebIO().readBinary(bytes as Uint8Array<ArrayBuffer>)).getRoot();
    const primitives = root.listMeshes()[0]!.listPrimitives();
    expect(primitives).toHaveLength(3);
    expect(new Set(primitives.map((one) => one.getAttribute('POSITION')))).toHaveProperty('size', 1);
    expect(new Set(primitives.map((one) => one.listTargets()[0]!.getAttribute('POSITION')))).toHaveProperty('size', 1);
    expect(new Set(primitives.map((one) => one.getMaterial()))).toHaveProperty('size', 3);
    expect(primitives.flatMap((one) => [...(one.getIndices()!.getArray() as Uint32Array)])).toEqual([...mesh.indices]);
  });
});

describe('quantiles', () => {
  it('are values of the list, in any order', () => {
    expect(quantile([5, 1, 4, 2, 3])).toBe(3);
    expect(quantile([10, 9])).toBe(10);
    expect(quantile([7], 0.95)).toBe(7);
    expect(quantile([])).toBeNaN();
    expect(spread(Array.from({ length: 100 }, (_, i) => 99 - i))).toEqual({ median: 50, slow: 95 });
  });
});

describe('the verdict', () => {
  const frame: Target = { mesh: '10000 faces', what: 'frame, ms', value: 0.5, limit: 1, atLeast: false, met: true };
  const solve: Target = { mesh: '332000 faces', what: 'Eigen / ours', value: 0.9, limit: 1, atLeast: true, met: false };

  it('names missed targets in one sentence', () => {
    expect(verdict([frame, frame])).toBe('All 2 targets were met.');
    expect(verdict([frame, solve])).toBe('1 of 2 targets MISSED: Eigen / ours at 332000 faces (0.90, at least 1.00).');
  });
});

describe('errors over a sweep of times', () => {
  it('have their mean, their largest mean and their worst with its time, between the keys and beyond them', () => {
    const { inside, margins } = sweptParts([
      { t: -0.2, mean: 5, worst: 9 },
      { t: 0.25, mean: 1, worst: 8 },
      { t: 0.5, mean: 3, worst: 4 },
      { t: 1.4, mean: 1, worst: 2 },
    ]);
    expect(inside).toEqual({ mean: 2, largestMean: 3, worst: 8, at: 0.25 });
    expect(margins).toEqual({ mean: 3, largestMean: 5, worst: 9, at: -0.2 });
  });
});

describe('a motion beside a captured one', () => {
  const shape = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3);

  it('is aligned by a rigid motion', () => {
    // A quarter turn about z, which maps x to y, and a translation.
    const turned = shape.map((_, i) => [5 - shape[i + 1]!, shape[i - 1]! - 1, shape[i]! + 2][i % 3]!);
    aligned(shape, turned).forEach((value, i) => {
      expect(value).toBeCloseTo(turned[i]!, 5);
    });
    expect(
      aligned(
        shape,
        shape.map((value) => 2 * value),
      ),
    ).not.toEqual(shape);
  });

  it('has a sliding that is the distance of resting vertices from their true positions', () => {
    const moved = (x: number, which: number): Float32Array => shape.map((value, i) => value + (i === which ? x : 0));
    const sliding = new Sliding(10);
    expect(sliding.percent).toBeNaN();
    sliding.add(shape, shape, true);
    // The first vertex moves in the reference, so three vertices rest; one of these slides by 1, 10 % of the diagonal.
    sliding.add(moved(1, 0), moved(1, 3), false);
    sliding.add(moved(1, 0), moved(1, 0), true);
    expect(sliding.percent).toBeCloseTo(10 * Math.sqrt(1 / 3), 5);
  });

  it('moves forward so that vertices on the ground stay, but not without steps', () => {
    // A head, and a foot that slides back by 1 per frame along x and z.
    const frames = Array.from({ length: 8 }, (_, i) => Float32Array.of(0, 10, 0, -i, 0, -i, -i, 0.1, -i));
    const onward = walkedOn(frames, 10)!;
    expect(Array.from(onward[7]!)).toEqual([7, 10, 7, 0, 0, 0, 0, expect.closeTo(0.1, 5), 0]);
    expect(walkedOn(frames.slice(0, 3), 10)).toBeNull();
  });
});
