import { readFile } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import { EngineError } from '../../web/engine/api/errors.ts';
import { QUERIES } from '../../web/engine/wire/calls.ts';
import { MAX_TURNS } from '../../web/engine/api/option-table.ts';
import { ENCODING_DEFAULTS, IMPORT_DEFAULTS, MOTION_DEFAULTS } from '../../web/engine/api/types.ts';
import { bendData, createBend, localCore, localFiles, motion } from './support/core.ts';
import type { WasmModule } from '../../web/engine/worker/wasm-module.ts';
import { poseFiles } from './support/glb.ts';
import { bar, bent } from './support/shapes.ts';

function failure(work: () => unknown): EngineError {
  try {
    work();
  } catch (error) {
    expect(error).toBeInstanceOf(EngineError);
    return error as EngineError;
  }
  throw new Error('it did not fail');
}

describe('the bindings', () => {
  it('are exactly those that the engine declares', async () => {
    const source = await readFile(new URL('../../web/engine/worker/wasm-module.ts', import.meta.url), 'utf8');
    const declaredIn = (name: string): string[] => {
      const [, body = ''] = new RegExp(`interface ${name} [^{]*\\{([^}]*)\\}`).exec(source) ?? [];
      return [...body.matchAll(/^ {2}(_\w+)\(/gm)].map(([, symbol]) => symbol!);
    };
    const exportedBy = (module: WasmModule): string[] =>
      Object.keys(module).filter((name) => /^_(shapespline_|malloc|free)/.test(name));
    const common = declaredIn('WasmModule');
    const queries = Object.values(QUERIES).map(({ symbol }) => symbol);
    const [core, files] = [(await localCore()).module, (await localFiles()).module];
    expect(common.length).toBe(4);
    expect(exportedBy(core).sort()).toEqual([...common, ...declaredIn('CoreModule'), ...queries].sort());
    expect(exportedBy(files).sort()).toEqual([...common, ...declaredIn('FilesModule')].sort());
  });

  it('pass arrays unchanged: keys in, faces and positions out', async () => {
    const { files } = await localFiles();
    const mesh = bar();
    const poses = [0, 90].map((degrees) => bent(mesh, degrees));
    const { info, positions } = files.importKeys(poseFiles(mesh, poses), IMPORT_DEFAULTS);
    expect(info.names).toEqual(['pose-1', 'pose-2']);
    expect(info.times).toEqual([0, 1]);
    expect(info.faces).toEqual(mesh.indices);
    expect(positions).toEqual(poses);
    expect(files.objects).toBe(0);
  });

  it('pass every motion option', async () => {
    const { core } = await localCore();
    const bend = createBend(core);
    const at = (options: Partial<typeof MOTION_DEFAULTS>, t: number): Float32Array => {
      const spec = { ...motion, options: { ...MOTION_DEFAULTS, ...options } };
      const { handle } = core.motion(bend.shape, spec, bend.motion);
      const { positions } = core.evaluate(handle, t, null);
      core.release(handle);
      return positions;
    };
    const natural = at({}, 0.8);
    const others = [
      at({ boundary: 'hermite' }, 0.8),
      at({ boundary: 'hermite', startSpeed: 5 }, 0.8),
      at({ boundary: 'hermite', endSpeed: 0 }, 0.8),
      at({ boundary: 'periodic' }, 0.8),
      at({ boundary: 'periodic', period: 9 }, 0.8),
      at({ method: 'geodesic' }, 0.8),
      at({ method: 'linear' }, 0.8),
      at({ method: 'cubic-vertex' }, 0.8),
      at({ method: 'rotation-strain' }, 0.8),
      at({ method: 'rimd' }, 0.8),
      at({ tension: [0, 1, 0] }, 0.8),
      at({ bias: [0, 1, 0] }, 0.8),
      at({ bias: [0, -1, 0] }, 0.8),
      at({ turns: [{ key: 2, turns: 1 }] }, 0.8),
    ];
    const all = [natural, ...others].map((positions) => positions.join());
    expect(new Set(all).size).toBe(all.length);
    expect(at({}, 0.8)).toEqual(natural);
    bend.release();
    expect(core.objects).toBe(0);
  });

  it('pass every encoding option', async () => {
    const { core } = await localCore();
    const far = (options: Partial<typeof ENCODING_DEFAULTS>, boundary: 'natural' | 'hermite' = 'natural'): string => {
      const spec = { ...motion, options: { ...MOTION_DEFAULTS, boundary } };
      const bend = createBend(core, { ...bendData(), encoding: { ...ENCODING_DEFAULTS, ...options } }, spec);
      const frame = core.evaluate(bend.motion, 1.4, null);
      bend.release();
      return frame.positions.join();
    };
    const shape = bent(bar(), 90);
    const all = [
      far({}),
      far({ reference: 2 }),
      far({ patches: 3 }),
      far({ stretch: 'log' }),
      far({ precision: 'exact' }),
      far({}, 'hermite'),
      far({ ghostFaces: 80 }),
      far({ ghostFaces: 80, transfer: 'paper' }),
      far({ ghostFaces: 80, placement: 'optimal' }),
      far({ startTangent: shape }, 'hermite'),
      far({ endTangent: shape }, 'hermite'),
    ];
    expect(new Set(all).size).toBe(all.length);
  });

  it('report a failure with code, message and location', async () => {
    const { core } = await localCore();
    const data = bendData();
    data.positions[1]![7] = NaN;
    const error = failure(() => createBend(core, data));
    expect([error.code, error.place]).toEqual(['not-finite', { key: 1, vertex: 2 }]);
    expect(error.message).toMatch(/key 2|b/);
    expect(core.objects).toBe(0);
  });

  it('refuse more added turns than the option table allows', async () => {
    const { core } = await localCore();
    const turned = (turns: number): ReturnType<typeof createBend> =>
      createBend(core, bendData(), {
        ...motion,
        options: { ...MOTION_DEFAULTS, turns: [{ key: 1, turns }] },
      });
    turned(MAX_TURNS).release();
    expect(failure(() => turned(MAX_TURNS + 1)).code).toBe('invalid-option');
  });

  it('report an internal error for a stale handle and an unknown choice, without a trap', async () => {
    const { core } = await localCore();
    const stale = createBend(core);
    stale.release();
    expect(failure(() => core.evaluate(stale.motion, 0, null)).code).toBe('internal');
    expect(failure(() => core.ask('keySpacing', stale.motion, {})).code).toBe('internal');
    const odd = { ...motion, options: { ...MOTION_DEFAULTS, method: 'none' as 'lri' } };
    expect(failure(() => createBend(core, bendData(), odd)).code).toBe('internal');
    const good = createBend(core);
    expect(core.evaluate(good.motion, 0.5, null).positions).toHaveLength(bar().positions.length);
  });

  it('report progress that ends at 1 and names its stages', async () => {
    const { core } = await localCore();
    const encoding: [string, number][] = [];
    const making: [string, number][] = [];
    const shape = core.encode(bendData(), (...progress) => encoding.push(progress));
    core.motion(shape, motion, null, { report: (...progress) => making.push(progress) });
    for (const seen of [encoding, making]) {
      const fractions = seen.map(([, fraction]) => fraction);
      expect(seen.length).toBeGreaterThan(1);
      expect(seen.every(([stage, fraction]) => stage.length > 0 && fraction >= 0 && fraction <= 1)).toBe(true);
      expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
      expect(fractions.at(-1)).toBe(1);
    }
    const again: unknown[] = [];
    core.motion(shape, motion, null, { report: (...progress) => again.push(progress) });
    expect(again).toEqual([]);
  });
});
