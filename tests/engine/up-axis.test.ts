/** Which of real poses are taken to be Z-up: as they lie in their files, and turned onto the other axis. */
import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { dataFile, dataFiles, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

async function isHinted(files: InputFile[]): Promise<boolean> {
  const keys = await engine.importKeyframes(files);
  const { warnings } = keys.info;
  keys.dispose();
  return warnings.some(({ code }) => code === 'z-up');
}

/** Points and triangles of an OFF as an OBJ, whose files mostly have y up; `standing`: turned, so that it has. */
function asObj({ name, bytes }: InputFile, standing: boolean): InputFile {
  const [, count = 0, faces = 0, , ...numbers] = new TextDecoder()
    .decode(bytes as Uint8Array)
    .split(/\s+/)
    .map(Number);
  const three = (from: number): number[] => numbers.slice(from, from + 3);
  const lines = [
    ...Array.from({ length: count }, (_, v) => three(3 * v)).map(([x, y = 0, z]) =>
      ['v', x, ...(standing ? [z, -y] : [y, z])].join(' '),
    ),
    ...Array.from({ length: faces }, (_, f) => three(3 * count + 4 * f + 1)).map(
      (corners) => `f ${corners.map((corner) => corner + 1).join(' ')}`,
    ),
  ];
  return { name: name.replace('.off', '.obj'), bytes: new TextEncoder().encode(lines.join('\n')) };
}

/** An OBJ as OFF, which does not say which axis is up. */
function asOff({ name, bytes }: InputFile, zUp: boolean): InputFile {
  const lines = new TextDecoder().decode(bytes as Uint8Array).split('\n');
  const of = (kind: string): string[][] =>
    lines.filter((line) => line.startsWith(`${kind} `)).map((line) => line.trim().split(/\s+/).slice(1));
  const points = of('v').map(([x, y, z]) => (zUp ? [x, -Number(z), y] : [x, y, z]).join(' '));
  const faces = of('f').map((corners) => [corners.length, ...corners.map((c) => parseInt(c, 10) - 1)].join(' '));
  const text = [`OFF\n${points.length} ${faces.length} 0`, ...points, ...faces].join('\n');
  return { name: name.replace('.obj', '.off'), bytes: new TextEncoder().encode(text) };
}

describe.skipIf(!hasData)('the guess at the up axis of real poses', () => {
  const cats = ['cat2', 'cat5', 'cat8'].map((name) => `turns/cat/${name}.off`);

  it.each([
    ['in their order', cats],
    ['with the one first that does not tell', [...cats].reverse()],
  ])('sees that the cats stand along z, %s', async (_, names) => {
    expect(await isHinted(names.map(dataFile))).toBe(true);
  });

  it.each(['obj/wolf', 'turns/lion'])('sees which way the poses of %s stand', async (folder) => {
    const poses = dataFiles(folder)
      .filter((name) => name.endsWith('.obj'))
      .map(dataFile);
    expect(await isHinted(poses.map((pose) => asOff(pose, false)))).toBe(false);
    expect(await isHinted(poses.map((pose) => asOff(pose, true)))).toBe(true);
  });

  it('sees it in OBJ files, too, where that is clear', async () => {
    const files = cats.map(dataFile);
    expect(await isHinted(files.map((file) => asObj(file, false)))).toBe(true);
    expect(await isHinted(files.map((file) => asObj(file, true)))).toBe(false);
  });

  // The galloping cat would stand more firmly on its side.
  it.each(['obj/wolf', 'turns/lion', 'obj/lowpoly-cat'])('turns over none of the OBJ files of %s', async (folder) => {
    const poses = dataFiles(folder).filter((name) => name.endsWith('.obj'));
    expect(poses.length).toBeGreaterThan(5);
    expect(await isHinted(poses.map(dataFile))).toBe(false);
    for (const [index, pose] of poses.slice(1).entries())
      expect(await isHinted([poses[index]!, pose].map(dataFile))).toBe(false);
  });

  it.each(['turns/saddle', 'turns/plate'])('says nothing of %s', async (folder) => {
    const names = dataFiles(folder).filter((name) => name.endsWith('.ply'));
    expect(await isHinted(names.map(dataFile))).toBe(false);
  });
});
