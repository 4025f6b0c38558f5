/** Our exports in Blender: names, frames, vertices; and Blender's exports of the result. */
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import type { ExportedFile, ExportOptions } from '../../web/engine/api/types.ts';
import { describeBlender, runInBlender } from './blender.ts';
import { engine, farthestShown, paintedMotion, type Made } from './made.ts';

let made: Made;
let folder: string;
beforeAll(async () => {
  made = await paintedMotion();
  folder = await mkdtemp(path.join(tmpdir(), 'shapespline-tools-'));
});
afterAll(() => rm(folder, { recursive: true, force: true }));

type Shown = [vertex: number, x: number, y: number, z: number][];

interface Imported {
  object: string;
  mesh: string;
  materials: string[];
  keys: string[];
  frames: number[];
  shown: Shown[];
}

async function saved(files: ExportedFile[]): Promise<string[]> {
  const places = files.map(({ name }) => path.join(folder, name));
  for (const [index, { bytes }] of files.entries()) await writeFile(places[index]!, bytes);
  return places;
}

async function imported(options: Partial<ExportOptions>, times: number[], withScript = false): Promise<Imported> {
  const [file, , script] = await saved(await made.files({ name: 'bar', ...options }));
  return runInBlender<Imported>('blender_glb.py', { file, times, fps: 24, ...(withScript ? { script } : {}) });
}

const grid = Array.from({ length: 25 }, (_, i) => i / 24);

describeBlender('Blender', () => {
  it('shows the exported vertices, under the names of keys and times, on whole frames', async () => {
    const options = { fps: 24 };
    const { times, error } = await made.sequence.planExport(options);
    const { object, mesh, keys, frames, shown } = await imported(options, grid);
    expect([object, mesh]).toEqual(['bar', 'bar']);
    expect(keys).toHaveLength(times.length);
    expect(keys).toContain(`${made.keys.info.names[1]} t=0.5`);
    expect(keys.slice(1).every((name) => /t=[\d.]+$/.test(name))).toBe(true);
    for (const frame of frames) expect(Math.abs(frame - Math.round(frame))).toBeLessThan(1e-3);
    for (const [i, t] of grid.entries()) {
      const off = farthestShown(shown[i]!, await made.at(t));
      const isExported = times.some((time) => Math.abs(time - t) < 1e-9);
      expect(off).toBeLessThan((isExported ? 1e-6 : 1.1 * error!) * made.diagonal);
    }
  });

  it('reads the names of materials, and 16-bit coordinates', async () => {
    const { materials, shown } = await imported({ frames: 5, compression: 'quantized' }, [0.5]);
    expect(materials).toEqual(['skin', 'cloth']);
    expect(farthestShown(shown[0]!, await made.at(0.5))).toBeLessThan(1e-4 * made.diagonal);
  });

  it('moves the shape with one slider, by the drivers for keys and in-betweens', async () => {
    const { keys, shown } = await imported({ targets: 'principal' }, grid, true);
    expect(keys).toContain('in-between 1');
    for (const [i, t] of grid.entries())
      expect(farthestShown(shown[i]!, await made.at(t))).toBeLessThan(1.1e-3 * made.diagonal);
  });

  it.each(['pc2', 'mdd'] as const)('moves the OBJ exactly with its %s', async (format) => {
    const [cache, obj] = await saved(await made.files({ name: 'cached', format, fps: 24 }));
    const answer = await runInBlender<{ vertices: number; materials: string[]; uvs: number; shown: Shown[] }>(
      'blender_cache.py',
      { obj, cache, format: format.toUpperCase(), frames: 25 },
    );
    expect(answer.vertices).toBe(made.keys.info.report.vertices);
    expect(answer.materials).toEqual(['skin', 'cloth']);
    expect(answer.uvs).toBe(1);
    for (const [i, t] of grid.entries())
      expect(farthestShown(answer.shown[i]!, await made.at(t))).toBeLessThan(1e-6 * made.diagonal);
  });

  it('exports files that open here again', async () => {
    const [file] = await saved(await made.files({ name: 'round', fps: 24 }));
    const output = path.join(folder, 'round-again.glb');
    await runInBlender('blender_round.py', { file, output, extras: true });
    const again = await engine.importKeyframes([{ name: 'again.glb', bytes: await readFile(output) }], { sample: 3 });
    expect(again.info.names).toHaveLength(3);
    const plain = await engine.importKeyframes([{ name: 'again.glb', bytes: await readFile(output) }]);
    expect(plain.info.warnings.map(({ code }) => code)).toContain('project-lost');
    expect(again.info.report.faces).toBe(made.keys.info.report.faces);
  });
});
