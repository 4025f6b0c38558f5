/** Detection of Z-up for real poses: as in their files, and rotated to the other axis. */
import { describe, expect, it } from 'vitest';
import type { InputFile } from '../../web/engine/api/types.ts';
import { dataFile, dataFiles, hasData } from './support/data.ts';
import { testEngine } from './support/engines.ts';

const engine = testEngine();

/** `z-up`: clear enough to stand the shapes up; `z-up-unclear`: only offered. */
async function hint(files: InputFile[]): Promise<string | null> {
  const keys = await engine.importKeyframes(files);
  const { warnings } = keys.info;
  keys.dispose();
  return warnings.find(({ code }) => code.startsWith('z-up'))?.code ?? null;
}

const isHinted = async (files: InputFile[]): Promise<boolean> => (await hint(files)) === 'z-up';

/** Points and triangles of an OFF file as an OBJ, where y is usually up; `standing`: rotated to y up. */
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

/** An OBJ as OFF, a format without a defined up axis. */
function asOff({ name, bytes }: InputFile, zUp: boolean): InputFile {
  const lines = new TextDecoder().decode(bytes as Uint8Array).split('\n');
  const of = (kind: string): string[][] =>
    lines.filter((line) => line.startsWith(`${kind} `)).map((line) => line.trim().split(/\s+/).slice(1));
  const points = of('v').map(([x, y, z]) => (zUp ? [x, -Number(z), y] : [x, y, z]).join(' '));
  const faces = of('f').map((corners) => [corners.length, ...corners.map((c) => parseInt(c, 10) - 1)].join(' '));
  const text = [`OFF\n${points.length} ${faces.length} 0`, ...points, ...faces].join('\n');
  return { name: name.replace('.obj', '.off'), bytes: new TextEncoder().encode(text) };
}

describe.skipIf(!hasData)('the detected up axis of real poses', () => {
  const cats = ['cat2', 'cat5', 'cat8'].map((name) => `turns/cat/${name}.off`);

  it.each([
    ['in their order', cats],
    ['with the one first that does not tell', [...cats].reverse()],
  ])('sees that the cats stand along z, %s', async (_, names) => {
    expect(await isHinted(names.map(dataFile))).toBe(true);
  });

  it.each(['obj/wolf', 'turns/lion'])('is correct for the poses of %s', async (folder) => {
    const poses = dataFiles(folder)
      .filter((name) => name.endsWith('.obj'))
      .map(dataFile);
    expect(await hint(poses.map((pose) => asOff(pose, false)))).toBe(null);
    // Not all poses stand on the floor, so the axis is unclear.
    expect(await hint(poses.map((pose) => asOff(pose, true)))).toBe('z-up-unclear');
  });

  /** Two poses of a box animal on four legs, standing at y = 0; its rump is a large flat face at z = 0. */
  const animal = (lift: number, zUp: boolean): string => {
    const boxes = [
      [0, 2, 0, 2, 4, 6],
      [0.6, 3.5, 6, 1.4, 4.5, 7],
      ...[0, 5.5].flatMap((z) => [0, 1.5].map((x) => [x, z === 0 && x === 0 ? lift : 0, z, x + 0.5, 2, z + 0.5])),
    ] as [number, number, number, number, number, number][];
    const points = boxes.flatMap(([x0, y0, z0, x1, y1, z1]) =>
      [z0, z1].flatMap((z) => [y0, y1].flatMap((y) => [x0, x1].map((x) => (zUp ? [x, -z, y] : [x, y, z])))),
    );
    const sides = ['0 2 3 1', '4 5 7 6', '0 1 5 4', '2 6 7 3', '0 4 6 2', '1 3 7 5'];
    const faces = boxes.flatMap((_, box) =>
      sides.map(
        (side) =>
          `4 ${side
            .split(' ')
            .map((corner) => Number(corner) + 8 * box)
            .join(' ')}`,
      ),
    );
    return `${points.map((point) => point.join(' ')).join('\n')}\n${faces.join('\n')}\n`;
  };
  it.each(['ply', 'off'])(
    'leaves an animal on four legs as it is in a %s with y up, and sees it with z up',
    async (kind) => {
      const header = {
        ply: 'ply\nformat ascii 1.0\nelement vertex 48\nproperty float x\nproperty float y\nproperty float z\nelement face 36\nproperty list uchar int vertex_indices\nend_header\n',
        off: 'OFF\n48 36 0\n',
      }[kind]!;
      const files = (zUp: boolean): InputFile[] =>
        [0, 0.5].map((lift, pose) => ({
          name: `p${pose}.${kind}`,
          bytes: new TextEncoder().encode(header + animal(lift, zUp)),
        }));
      expect(await isHinted(files(false))).toBe(false);
      expect(await isHinted(files(true))).toBe(true);
    },
  );

  it('is also correct for OBJ files, if it is clear', async () => {
    const files = cats.map(dataFile);
    expect(await isHinted(files.map((file) => asObj(file, false)))).toBe(true);
    expect(await isHinted(files.map((file) => asObj(file, true)))).toBe(false);
  });

  // The galloping cat would stand more stably on its side.
  it.each(['obj/wolf', 'turns/lion', 'obj/lowpoly-cat'])('rotates no OBJ files of %s', async (folder) => {
    const poses = dataFiles(folder).filter((name) => name.endsWith('.obj'));
    expect(poses.length).toBeGreaterThan(5);
    expect(await isHinted(poses.map(dataFile))).toBe(false);
    for (const [index, pose] of poses.slice(1).entries())
      expect(await isHinted([poses[index]!, pose].map(dataFile))).toBe(false);
  });

  it.each(['turns/saddle', 'turns/plate'])('gives no warning for %s', async (folder) => {
    const names = dataFiles(folder).filter((name) => name.endsWith('.ply'));
    expect(await isHinted(names.map(dataFile))).toBe(false);
  });
});
