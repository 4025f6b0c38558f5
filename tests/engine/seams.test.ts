import { describe, expect, it } from 'vitest';
import type { Keys } from '../../web/engine/api/api.ts';
import type { InputFile } from '../../web/engine/api/types.ts';
import { frameAt, testEngine } from './support/engines.ts';
import { expectValid, exported } from './support/exported.ts';
import { bar, bent, diagonal, largestDistance } from './support/shapes.ts';
import { threePlayer } from './support/three-player.ts';

const engine = testEngine();
const mesh = bar(2, 8);
const vertices = mesh.positions.length / 3;
const PNG = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==';
const text = (name: string, content: string): InputFile => ({ name, bytes: new TextEncoder().encode(content) });
const paint = [
  text('paint.mtl', 'newmtl paint\nmap_Kd paint.png\n'),
  { name: 'paint.png', bytes: Uint8Array.from(atob(PNG), (c) => c.charCodeAt(0)) },
];

/** Every second face has other texture coordinates; `shift` moves all of them. */
function objOf(name: string, positions: Float32Array, shift = 0): InputFile {
  const lines = ['mtllib paint.mtl', 'usemtl paint'];
  for (let i = 0; i < positions.length; i += 3) lines.push(`v ${positions.slice(i, i + 3).join(' ')}`);
  for (let i = 0; i < 2 * vertices; i += 1)
    lines.push(`vt ${(i % vertices) / vertices + shift} ${i < vertices ? 0.25 : 0.75}`);
  const corner = (vertex: number, face: number): string => `${vertex + 1}/${vertex + 1 + (face % 2) * vertices}`;
  for (let f = 0; f < mesh.indices.length / 3; f += 1)
    lines.push(`f ${Array.from(mesh.indices.subarray(3 * f, 3 * f + 3), (v) => corner(v, f)).join(' ')}`);
  return text(name, lines.join('\n'));
}

const poses = [0, 40, 80].map((degrees) => bent(mesh, degrees));
/** Only the first file's texture coordinates count. */
const files = poses.map((positions, index) => objOf(`pose-${index}.obj`, positions, index / 2));

/** Drawn texture coordinates of every corner of every face. */
function corners({ info }: Keys): number[] {
  return Array.from(info.scene.seams?.indices ?? info.faces).flatMap((v) => [
    info.scene.uvs![2 * v]!,
    info.scene.uvs![2 * v + 1]!,
  ]);
}

describe('an OBJ whose texture has seams', () => {
  it('is exported as a valid GLB that three.js plays, and that opens again as the same project', async () => {
    const keys = await engine.importKeyframes([...files, ...paint]);
    const sequence = await engine.createSequence(keys, { boundary: 'hermite', startSpeed: 2, endTangent: poses[1]! });
    const options = { frames: 6, range: [-0.2, 1] as [number, number] };
    const { times, bytes: stated } = await sequence.planExport(options);
    const bytes = await exported(sequence, options);
    expect(Math.abs(stated - bytes.length)).toBeLessThan(0.1 * bytes.length);
    await expectValid(bytes);
    const player = await threePlayer(bytes);
    for (const [index, t] of times.entries()) {
      const { positions } = await frameAt(sequence, t);
      expect(positions).toHaveLength(3 * vertices);
      expect(largestDistance(player.positionsAt(player.times[index]!), positions)).toBeLessThan(
        1e-4 * diagonal(positions),
      );
    }
    const again = await engine.importKeyframes([{ name: 'again.glb', bytes }]);
    expect(again.info.report).toEqual({ ...keys.info.report, diagonal: expect.closeTo(keys.info.report.diagonal, 4) });
    expect(again.info.names).toEqual(['pose-0', 'pose-1', 'pose-2']);
    expect(again.info.faces).toEqual(keys.info.faces);
    expect(corners(again)).toEqual(corners(keys));
    expect(again.info.project).toEqual(sequence.options);
    const other = await engine.createSequence(again, { ...again.info.project });
    expect(
      largestDistance((await frameAt(other, 0.3)).positions, (await frameAt(sequence, 0.3)).positions),
    ).toBeLessThan(1e-5 * diagonal(poses[0]!));
    // A pose from a separate file of any format matches the mesh.
    const [pose] = await other.export({ format: 'glb', pose: 0.3 });
    expect((await engine.importKeyframes([pose!, files[0]!])).info.report.vertices).toBe(vertices);
    for (const one of [sequence, other]) one.dispose();
  });
});
