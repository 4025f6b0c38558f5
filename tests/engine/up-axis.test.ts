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

  it.each(['turns/saddle', 'turns/plate'])('says nothing of %s', async (folder) => {
    const names = dataFiles(folder).filter((name) => name.endsWith('.ply'));
    expect(await isHinted(names.map(dataFile))).toBe(false);
  });
});
